#pragma once

#include <filesystem>

#include "sim_bridge/scene/scene_terrain.h"
#include "surface/geodesy.h"

namespace seaway::bridge {

/// Whether a file begins as a PNG does.
bool isPngFile(const std::filesystem::path& file);

/// Reads a terrain's map of heights (a PNG or a GeoTIFF) onto an even grid of the sea plane, about
/// as fine as the file's pixels, over the largest upright rectangle that the file covers there;
/// linear between pixels, mapped within 0.02 pixels. `waterLevel`: the still-water level above the
/// file's datum, m. The grid is divided into blocks of 2ⁿ cells, as render/terrain wants them.
///
/// Throws InputError, naming the file, where it cannot be read, has more than
/// HeightPicture::mostPixels pixels, has a height beyond ±12 000 m or none at all, or lies nowhere
/// within 100 km of the scene's anchor.
TerrainMap loadTerrain(const SceneTerrain& terrain, const std::filesystem::path& file,
                       const Geodesy& geodesy, double waterLevel);

}  // namespace seaway::bridge
