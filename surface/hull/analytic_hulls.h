#pragma once

#include <cstddef>

#include "surface/hull/triangle_mesh.h"

/// Hulls whose hydrostatics are known in closed form, as closed meshes of about as many triangles
/// as asked for (never more; the fewest that a shape needs at least). Body frame, z = 0 at the
/// design waterline, x = 0 amidships.
namespace seaway {

/// L × B × D, from z = −`draft` up to D − draft. Exact. Faces are divided into near-squares.
TriangleMesh boxMesh(double length, double beam, double depth, double draft,
                     std::size_t triangles = 800);

/// Wigley's hull y = (B/2)(1 − (2x/L)²)(1 − (z/T)²), above the waterline wall-sided up to
/// `freeboard`, with a flat deck. Vertices lie on the hull: the mesh is inscribed, short of volume
/// by 0.47 % at 800 triangles and 0.025 % at 13 000 (tests/surface/hull/hydrostatics_test.cpp).
TriangleMesh wigleyMesh(double length, double beam, double draft, double freeboard,
                        std::size_t triangles = 800);

/// An open boat: the same without a deck, hollow down to `wall` m from the outside amidships, ends
/// and keel; closed as a mesh (its skin is two-sided), for drawings. Loads take the water to be
/// inside it too: give them wigleyMesh. Throws InputError for a wall of half the beam or of the
/// draft, or more.
TriangleMesh openWigleyMesh(double length, double beam, double draft, double freeboard, double wall,
                            std::size_t triangles = 800);

/// A ball about the origin, by rings of latitude. Vertices stand a little outside (0.5 % of the
/// radius at 800 triangles), so that the volume is the ball's.
TriangleMesh sphereMesh(double radius, std::size_t triangles = 800);

/// An upright round column of a diameter, from z = −`draft` to `freeboard`. Vertices stand a little
/// outside, so that the section's area is the circle's.
TriangleMesh sparMesh(double diameter, double draft, double freeboard, std::size_t triangles = 800);

}  // namespace seaway
