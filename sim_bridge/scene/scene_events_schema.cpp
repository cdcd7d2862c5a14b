#include "sim_bridge/scene/scene_events.h"
#include "sim_bridge/scene/schema_fields.h"
#include "surface/disturbance/analytic/splash.h"

// Keys of a scene's splashes, rain, ripples and layers.
namespace seaway::bridge {
namespace {

const Range times = Range::within(-1e7, 1e7);

}  // namespace

Mapping<SceneSplash> splashSchema(const Mapping<Place>& place) {
  using S = SceneSplash;
  return Mapping<S>({
      choice("kind", &S::kind,
             {{"splash", SplashKind::splash}, {"explosion", SplashKind::explosion}},
             "which sizes it has where none are given: a stone's or a charge's"),
      mapping("place", &S::place, place, "where", Need::required),
      number("time_s", &S::time, "s", times, "when"),
      number("height_m", &S::height, "m", Range::within(0.0, Splash::mostHeight),
             "of its rings; default 0.3, explosion 2.5"),
      number("wavelength_m", &S::wavelength, "m", Range::within(0.1, Splash::mostLength),
             "of its rings; default 1.5, explosion 9"),
      number("reach_m", &S::reach, "m", Range::within(0.1, Splash::mostLength),
             "distance in which rings fall to 1/e; default 3, explosion 18"),
      number("duration_s", &S::duration, "s", Range::within(0.05, Splash::mostDuration),
             "time in which they do; default 1.5, explosion 5"),
      number("foam_radius_m", &S::foamRadius, "m", Range::within(0.0, 200.0),
             "of the foam it leaves; default 0.5, explosion 9"),
  });
}

Mapping<SceneRain> rainSchema() {
  using R = SceneRain;
  return Mapping<R>({
      number("rate_mm_h", &R::rate, "mm/h", Range::within(0.0, 500.0), "of rain", Need::required),
      number("from_s", &R::from, "s", times, "when it begins"),
      number("to_s", &R::to, "s", times.orInfinite(), "when it ends"),
  });
}

Mapping<SceneRipples> ripplesSchema(const Mapping<Place>& place) {
  using R = SceneRipples;
  return Mapping<R>({
      mapping("place", &R::place, place, "where something bobs", Need::required),
      number("time_s", &R::time, "s", times, "when it starts"),
      number("duration_s", &R::duration, "s", Range::within(0.0, 3600.0), "how long it bobs"),
      number("height_m", &R::height, "m", Range::within(0.0, 5.0), "how high it bobs"),
      number("period_s", &R::period, "s", Range::within(0.2, 60.0), "how often"),
      number("wavelength_m", &R::wavelength, "m", Range::within(0.1, 100.0), "of its ripples"),
      number("side_m", &R::side, "m", Range::within(0.2, 2500.0),
             "of the square of water that ripples: 2 to 25 wavelengths"),
  });
}

Mapping<SceneLayer> layerSchema(const Mapping<Place>& place) {
  using L = SceneLayer;
  return Mapping<L>(
      {
          choice(
              "kind", &L::kind,
              {{"foam", LayerKind::foam}, {"smooth", LayerKind::smooth}, {"oil", LayerKind::oil}},
              "white water; water without short waves; oil, which lacks them too"),
          mapping("place", &L::place, place, "middle of a round patch"),
          number("radius_m", &L::radius, "m", Range::within(0.1, 1000.0), "of the patch"),
          number("cover", &L::cover, "1", Range::within(0.0, 1.0), "of the water in the patch"),
          text("file", &L::path,
               "OpenVDB file, relative to the scene, in place of a patch: a fog volume in the sea "
               "plane's metres (x east, y north of the anchor), cover in [0, 1]"),
          text("grid", &L::grid, "which of the file's grids; may be left out where it has one"),
          number("time_s", &L::time, "s", times, "from when on it lies there"),
      },
      [](const L& layer, const YamlValue& value) {
        if (layer.place.has_value() == !layer.path.empty()) {
          value.fail("needs exactly one of place and file");
        }
      });
}

Mapping<LayerAccuracy> layerAccuracySchema() {
  using L = LayerAccuracy;
  return Mapping<L>({
      number("cell_m", &L::cell, "m", Range::within(0.02, 20.0), "side of a layer's cells"),
      number("foam_life_s", &L::foamLife, "s", Range::within(0.1, 3600.0),
             "time in which foam fades to 1/e"),
      number("smooth_life_s", &L::smoothLife, "s", Range::within(0.1, 3600.0),
             "time in which smoothed water does"),
      number("oil_life_s", &L::oilLife, "s", Range::within(1.0, 86400.0).orInfinite(),
             "time in which oil does"),
  });
}

}  // namespace seaway::bridge
