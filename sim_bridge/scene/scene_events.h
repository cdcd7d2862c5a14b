#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "sim_bridge/scene/place.h"
#include "sim_bridge/scene/schema.h"

/// What disturbs the water of a scene beside waves and vessels, as its file gives it.
namespace seaway::bridge {

enum class SplashKind { splash, explosion };

struct SceneSplash {
  SplashKind kind = SplashKind::splash;
  Place place;
  double time = 0.0;  ///< s
  // Where not given, by kind.
  std::optional<double> height, wavelength, reach, duration, foamRadius;
};

struct SceneRain {
  double rate = 0.0;                                       ///< mm/h
  double from = -std::numeric_limits<double>::infinity();  ///< s
  double to = std::numeric_limits<double>::infinity();     ///< s
};

struct SceneRipples {
  Place place;
  double time = 0.0, duration = 10.0;    ///< s
  double height = 0.05;                  ///< m
  double period = 0.8;                   ///< s
  double wavelength = 1.0, side = 20.0;  ///< m
};

enum class LayerKind { foam, smooth, oil };

/// Something that lies on the water from a time on: a round patch, or a grid of an OpenVDB file.
struct SceneLayer {
  LayerKind kind = LayerKind::oil;
  std::optional<Place> place;  ///< of a patch
  double radius = 20.0;        ///< m
  double cover = 0.8;
  std::string path, grid;  ///< of a file, as in the scene
  double time = 0.0;       ///< s
  std::string file;        ///< resolved by the loader
  int line = 0;
};

struct LayerAccuracy {
  double cell = 0.25;                                        ///< m
  double foamLife = 20.0;                                    ///< 1/e of foam, s
  double smoothLife = 60.0;                                  ///< 1/e of smoothed water, s
  double oilLife = std::numeric_limits<double>::infinity();  ///< s
};

Mapping<SceneSplash> splashSchema(const Mapping<Place>& place);
Mapping<SceneRain> rainSchema();
Mapping<SceneRipples> ripplesSchema(const Mapping<Place>& place);
Mapping<SceneLayer> layerSchema(const Mapping<Place>& place);
Mapping<LayerAccuracy> layerAccuracySchema();

}  // namespace seaway::bridge
