#pragma once

#include <filesystem>

#include "surface/geodesy.h"
#include "surface/outline/water_outline.h"

namespace seaway::bridge {

/// Reads a GeoJSON file (RFC 7946) of Polygons and MultiPolygons, bare or in Features and
/// FeatureCollections: the shores of some water, holes being islands. Their union is the water.
///
/// Longitudes and latitudes are WGS84 degrees; a position's height is not looked at. Edges are
/// straight in longitude and latitude, the shorter way around, so that a ring may cross 180°; they
/// are divided into parts of 0.01° and mapped to the sea plane (within 0.2 m of the straight line
/// to 80° of latitude). Throws InputError, naming file and key
/// ("features[0].geometry.coordinates[0] [3]"), for anything else, for rings that are not closed or
/// have no area, and for positions farther from the anchor than the geodesy reaches.
WaterOutline loadOutline(const std::filesystem::path& file, const Geodesy& geodesy);

}  // namespace seaway::bridge
