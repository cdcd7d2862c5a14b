#pragma once

#include "surface/hull/triangle_mesh.h"

namespace seaway {

/// The mesh widened or narrowed so that what lies below z = 0 has `volume` m³ and z = 0 cuts it
/// with an area of `waterplane` m²: vertices on either side of y = 0 move apart by a distance that
/// is even at and above the waterline and bulges below it, fading out within 3 % of half the
/// breadth from the centreplane. Both figures are linear in the two distances: exact to rounding.
/// An inscribed mesh of a round hull falls short about evenly, so that moments follow: with 800
/// triangles V, KB, BM and the waterplane's area and moments of a Wigley hull within 0.05 %
/// (tests/surface/hull/mesh_calibration_test.cpp).
///
/// Throws InputError for a mesh with nothing below or nothing above z = 0, and where vertices would
/// move by more than a tenth of the breadth.
TriangleMesh calibrated(const TriangleMesh& mesh, double volume, double waterplane);

}  // namespace seaway
