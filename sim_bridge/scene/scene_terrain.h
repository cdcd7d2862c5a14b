#pragma once

#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <string>

#include "sim_bridge/scene/place.h"
#include "sim_bridge/scene/schema.h"
#include "surface/terrain/terrain_map.h"

/// Ground and sea bed of a scene, as its file gives them.
namespace seaway::bridge {

/// What heights of a terrain's file are above.
enum class TerrainDatum {
  geoid,       ///< mean sea level: the scene's water level is taken from them
  stillWater,  ///< the scene's still-water level
};

/// Edges of a picture, WGS84 degrees; it may cross 180°, with an east below its west.
struct TerrainExtent {
  double west_deg = 0.0, east_deg = 0.0, south_deg = 0.0, north_deg = 0.0;
};

struct SceneTerrain {
  std::string path;  ///< as in the scene; empty: there is none
  TerrainDatum datum = TerrainDatum::geoid;
  // Of pictures; a GeoTIFF tells its own.
  std::optional<TerrainExtent> extent;
  std::optional<Place> centre;
  glm::dvec2 size{0.0};           ///< m, eastwards and northwards
  glm::dvec2 blackAndWhite{0.0};  ///< heights at black and at white, m
  std::optional<double> noData;   ///< height where the file has none, m
  TerrainLook look;
  double shoreHardness = TerrainLook{}.shoreHardness;  ///< 1/m
  std::shared_ptr<const TerrainMap> map;               ///< read by the loader
};

Mapping<SceneTerrain> terrainSchema(const Mapping<Place>& place);

}  // namespace seaway::bridge
