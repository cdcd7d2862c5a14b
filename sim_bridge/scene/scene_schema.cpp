#include "sim_bridge/scene/light_schema.h"
#include "sim_bridge/scene/scene_camera_schema.h"
#include "sim_bridge/scene/scene_loader.h"
#include "sim_bridge/scene/schema_fields.h"
#include "sim_bridge/scene/sea_state_schema.h"

// The one table of a scene's keys.
namespace seaway::bridge {
namespace {

const Range latitudes = Range::within(-90.0, 90.0);
const Range longitudes = Range::within(-180.0, 360.0);
const Range compass = Range::within(-360.0, 360.0);

Mapping<Place> placeSchema() {
  return Mapping<Place>({
      number("latitude_deg", &Place::latitude_deg, "°", latitudes, "WGS84", Need::required),
      number("longitude_deg", &Place::longitude_deg, "°", longitudes, "WGS84", Need::required),
  });
}

Mapping<SeaSettings> seaSchema() {
  using S = SeaSettings;
  const Mapping<Current> current({
      number("speed_m_s", &Current::speed, "m/s", Range::within(0.0, 20.0), "speed"),
      number("toward_deg", &Current::toward_deg, "°", compass, "compass direction it sets to"),
  });
  return Mapping<S>({
      mapping("anchor", &S::anchor, placeSchema(), "origin of the sea plane", Need::required),
      number("depth_m", &S::depth, "m", Range::above(0.0).orInfinite(), "water depth"),
      number("water_level_m", &S::waterLevel, "m", Range::within(-500.0, 9000.0),
             "still-water level above the geoid: tide, set-up, a lake's level"),
      mapping("current", &S::current, current, "uniform current; it carries the waves along"),
      integer("seed", &S::seed, 0, std::numeric_limits<std::int64_t>::max(),
              "rules every random choice"),
      choice("model", &S::model, {{"group", OctaveKind::group}, {"perlin", OctaveKind::perlin}},
             "kind of octaves that parametric states become"),
      mapping("state", &S::state, seaStateSchema(), "the waves", Need::required),
      text("outline", &S::outlinePath,
           "GeoJSON file of the water's shores, relative to the scene; without it there is water "
           "everywhere"),
  });
}

Mapping<SceneVessel> vesselSchema() {
  using V = SceneVessel;
  using S = VesselStart;
  const Mapping<S> start({
      number("latitude_deg", &S::latitude_deg, "°", latitudes, "WGS84", Need::required),
      number("longitude_deg", &S::longitude_deg, "°", longitudes, "WGS84", Need::required),
      number("heading_deg", &S::heading_deg, "°", compass, "true heading"),
  });
  return Mapping<V>({
      name("name", &V::name, "unique among vessels"),
      text("model", &V::modelPath, "vessel file, relative to the scene", Need::required),
      mapping("start", &V::start, start, "where it is at time 0", Need::required),
      number("speed_m_s", &V::speed, "m/s", Range::within(-60.0, 60.0),
             "speed over ground, negative astern; of a free vessel through the water, which its "
             "propeller keeps and its start has"),
      choice("motion", &V::motion,
             {{"prescribed", VesselMotion::prescribed}, {"free", VesselMotion::free}},
             "prescribed: sails the course that start, speed and turn give, heaves, rolls and "
             "pitches on the box of its model; free: moves in six degrees by the loads on its "
             "model's mesh, propeller and rudder along its waypoints, from time 0 on, straight "
             "on its start's heading before"),
      number("turn_deg_s", &V::turn_deg, "°/s", Range::within(-90.0, 90.0),
             "rate of turn, positive to starboard"),
      list("waypoints", &V::waypoints, placeSchema(),
           "where a free vessel, and any under `seaway sail`, steers by its rudder"),
  });
}

Mapping<EffectSettings> effectsSchema() {
  std::vector<Field<EffectSettings>> fields;
  for (const EffectDescription& effect : effectDescriptions()) {
    const auto index = static_cast<std::size_t>(effect.effect);
    KeyDescription description{
        std::string(effect.name),
        "word",
        "",
        "auto, on, off",
        "auto",
        Need::optional,
        std::string(effect.summary) + "; auto: when " + std::string(effect.calledForWhen),
        {}};
    description.words = {"auto", "on", "off"};
    fields.push_back(
        {std::move(description), [index](EffectSettings& target, const YamlValue& value) {
           const bool scalar = value.kind == YamlValue::Kind::scalar;
           if (scalar && value.scalar == "auto") {
             target[index] = EffectSetting::automatic;
           } else if (scalar && value.scalar == "on") {
             target[index] = EffectSetting::on;
           } else if (scalar && value.scalar == "off") {
             target[index] = EffectSetting::off;
           } else {
             failChoice(value, {"auto", "on", "off"});
           }
         }});
  }
  return Mapping<EffectSettings>(std::move(fields));
}

Field<Performance> heightError() {
  return number("height_m", &Performance::height, "m", Range::atLeast(0.0),
                "error of heights, one standard deviation, for `seaway tune`");
}

Field<Performance> pictureError() {
  return number("pixel", &Performance::position, "px", Range::atLeast(0.0),
                "error of the sea's place in pictures, rms, for `seaway tune`");
}

std::vector<Field<Performance>> costFields() {
  using P = Performance;
  return {number("query_ns", &P::query, "ns", Range::above(0.0), "a point's height in batches"),
          number("frame_ms", &P::frame, "ms", Range::above(0.0), "a frame, mean of the cameras"),
          number("step_us", &P::step, "µs", Range::above(0.0), "a step of the vessels")};
}

Mapping<Accuracy> accuracySchema() {
  using W = WakeAccuracy;
  const Mapping<W> wakes({
      number("cell_m", &W::cell, "m", Range::within(0.0, 100.0),
             "cells near the hull, which carry waves from four cells up; 0: 0.5 m, twice as much "
             "for hulls above 64 m, and so on"),
      number("window_m", &W::window, "m", Range::within(0.0, 1e5),
             "side of the square around a vessel that its waves are followed in, rounded up to "
             "2ⁿ cells; 0: 2048 cell_m"),
      integer("most", &W::most, 0, 1000, "wakes that run at once: those nearest to who is near"),
  });
  std::vector<Field<Accuracy>> fields{
      number("motion_tolerance_m", &Accuracy::motionTolerance, "m", Range::atLeast(0.0),
             "height that vessels' samples of the sea may leave out, one standard deviation"),
      vector("grid", &Accuracy::grid, "", Range::within(2, 4096),
             "vertices of the projected grid, across and along"),
      mapping("layers", &Accuracy::layers, layerAccuracySchema(), "foam, smoothed water and oil"),
      mapping("wakes", &Accuracy::wakes, wakes, "the windows of vessels' waves"),
  };
  for (Field<Performance>& field : std::vector{heightError(), pictureError()}) {
    fields.push_back(
        {field.description, [read = field.read](Accuracy& target, const YamlValue& value) {
           read(target.wanted, value);
         }});
  }
  return Mapping<Accuracy>(std::move(fields));
}

Mapping<Performance> budgetSchema() { return Mapping<Performance>(costFields()); }

Mapping<Performance> tunedSchema() {
  std::vector<Field<Performance>> fields = costFields();
  fields.push_back(heightError());
  fields.push_back(pictureError());
  return Mapping<Performance>(std::move(fields));
}

Mapping<RunSettings> runSchema() {
  using R = RunSettings;
  return Mapping<R>({
      number("duration_s", &R::duration, "s", Range::between(0.0, 1e7), "simulated time"),
      number("fps", &R::framesPerSecond, "1/s", Range::within(0.0, 1000.0),
             "frames per simulated second; 0 draws none"),
      vector("size", &R::size, "pixels", Range::within(1, 8192), "width and height of frames"),
      number("step_s", &R::step, "s", Range::within(1e-4, 1.0), "step of the vessels' motion"),
  });
}

}  // namespace

const Mapping<Scene>& sceneSchema() {
  static const Mapping<Scene> schema({
      mapping("sea", &Scene::sea, seaSchema(), "the water and where it is", Need::required),
      list("vessels", &Scene::vessels, vesselSchema(), "what floats"),
      list("scenery", &Scene::scenery, scenerySchema(), "meshes that are no vessels"),
      list("cameras", &Scene::cameras, cameraSchema(), "who looks"),
      list("splashes", &Scene::splashes, splashSchema(placeSchema()),
           "what falls into the water or bursts in it"),
      mapping("rain", &Scene::rain, rainSchema(), "rings of raindrops; without it none falls"),
      list("ripples", &Scene::ripples, ripplesSchema(placeSchema()), "what bobs in the water"),
      list("layers", &Scene::layers, layerSchema(placeSchema()), "what lies on the water"),
      mapping("terrain", &Scene::terrain, terrainSchema(placeSchema()),
              "islands, shores and sea bed; without it the bed is at sea.depth_m"),
      mapping("light", &Scene::light, lightSchema(), "sun, moon, wind, air and how water is lit"),
      list("lights", &Scene::lamps, lampSchema(placeSchema()),
           "lamps: shown when it is dusk or dark"),
      mapping("effects", &Scene::effects, effectsSchema(), "what may be simulated and drawn"),
      mapping("accuracy", &Scene::accuracy, accuracySchema(), "what exactness is paid for"),
      mapping("budget", &Scene::budget, budgetSchema(), "what `seaway tune` may spend"),
      mapping("tuned", &Scene::tuned, tunedSchema(),
              "what `seaway tune` foresaw on its machine; `seaway run` sets beside it what it "
              "achieves"),
      mapping("run", &Scene::run, runSchema(), "defaults of `seaway run`"),
  });
  return schema;
}

}  // namespace seaway::bridge
