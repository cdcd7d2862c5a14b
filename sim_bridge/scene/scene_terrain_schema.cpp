#include "sim_bridge/scene/scene_terrain.h"
#include "sim_bridge/scene/schema_fields.h"

// Keys of a scene's terrain.
namespace seaway::bridge {

Mapping<SceneTerrain> terrainSchema(const Mapping<Place>& place) {
  using S = SceneTerrain;
  using E = TerrainExtent;
  using L = TerrainLook;
  const Range heights = Range::within(-12000.0, 12000.0);
  const Range longitudes = Range::within(-180.0, 360.0), latitudes = Range::within(-90.0, 90.0);
  const Range reflectances = Range::within(0.0, 1.0);
  const Mapping<E> extent({
      number("west_deg", &E::west_deg, "°", longitudes, "WGS84", Need::required),
      number("east_deg", &E::east_deg, "°", longitudes, "WGS84", Need::required),
      number("south_deg", &E::south_deg, "°", latitudes, "WGS84", Need::required),
      number("north_deg", &E::north_deg, "°", latitudes, "WGS84", Need::required),
  });
  const Mapping<L> colour({
      vector("sand", &L::sand, "", reflectances, "flat ground near the water and below it"),
      vector("grass", &L::grass, "", reflectances, "flat ground higher up"),
      vector("rock", &L::rock, "", reflectances, "steep ground"),
      vector("reef", &L::reef, "", reflectances, "rough ground under water"),
      number("grass_from_m", &L::grassFrom, "m", heights, "height above the still water"),
      number("rock_slope", &L::rockSlope, "", Range::within(0.01, 100.0),
             "rise over run at which half of the ground is rock"),
  });
  return Mapping<S>({
      text("file", &S::path,
           "map of heights, relative to the scene: a GeoTIFF of one band in any projection that "
           "PROJ takes to WGS84, or a grey PNG of 8 or 16 bits; 4096² heights at the most",
           Need::required),
      choice("datum", &S::datum,
             {{"geoid", TerrainDatum::geoid}, {"still_water", TerrainDatum::stillWater}},
             "what its heights are above; of the geoid, `sea.water_level_m` is taken from them"),
      mapping("extent", &S::extent, extent, "edges of a PNG, even in longitude and latitude"),
      mapping("centre", &S::centre, place, "middle of a PNG, instead of `extent`"),
      vector("size_m", &S::size, "m", Range::within(0.0, 1e6),
             "of a PNG about its `centre`, eastwards and northwards, even in metres"),
      vector("height_m", &S::blackAndWhite, "m", heights, "of a PNG, at black and at white"),
      number("no_data_m", &S::noData, "m", heights,
             "height where a GeoTIFF has none; without it 20 m below the still water, or the map's "
             "lowest height if that is lower"),
      mapping("colour", &S::look, colour, "linear reflectances, and where they lie"),
      number("shore_hardness_per_m", &S::shoreHardness, "1/m", Range::within(0.1, 1000.0),
             "how fast water fades in where it begins: all of it is there at a depth of 1 / this"),
  });
}

}  // namespace seaway::bridge
