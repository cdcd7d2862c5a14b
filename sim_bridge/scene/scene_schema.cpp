#include "sim_bridge/scene/scene_loader.h"
#include "sim_bridge/scene/schema_fields.h"

// The one table of a scene's keys.
namespace seaway::bridge {
namespace {

const Range latitudes = Range::within(-90.0, 90.0);
const Range longitudes = Range::within(-180.0, 360.0);
const Range compass = Range::within(-360.0, 360.0);

constexpr int mostOctaves = 64;

// Far beyond any water: all numbers downstream stay finite.
void requireSeaLike(const ParametricState& state, const YamlValue& value) {
  const auto check = [&](const char* key, double number, const Range& range, const char* unit) {
    if (range.holds(number)) return;
    const YamlValue& given = *value.find(key);
    given.fail(given.scalar + " is not allowed; " + range.sentence() + " " + unit);
  };
  check("hm0_m", state.significantWaveHeight, Range::within(0.0, 1000.0), "m");
  check("tp_s", state.peakPeriod, Range::within(0.01, 1e4), "s");
}

Mapping<Place> placeSchema() {
  return Mapping<Place>({
      number("latitude_deg", &Place::latitude_deg, "°", latitudes, "WGS84", Need::required),
      number("longitude_deg", &Place::longitude_deg, "°", longitudes, "WGS84", Need::required),
  });
}

Mapping<ParametricState> parametricSchema(bool withPeakEnhancement) {
  using P = ParametricState;
  std::vector<Field<P>> fields{
      number("hm0_m", &P::significantWaveHeight, "m", Range::above(0.0),
             "significant wave height H_m0, at most 1000", Need::required),
      number("tp_s", &P::peakPeriod, "s", Range::above(0.0), "peak period",
             Need::required),
      number("from_deg", &P::from_deg, "°", compass, "compass direction the waves come from",
             Need::required),
      number("spread_s", &P::spreadExponent, "1", Range::atLeast(0.5).orInfinite(),
             "exponent s of the spreading cos²ˢ((θ − θ_m)/2) that the sea has at its frequencies"),
      integer("octaves", &P::octaves, 0, mostOctaves,
              "octaves to fit; 0: 24 group octaves or 8 Perlin octaves"),
  };
  if (withPeakEnhancement) {
    fields.push_back(
        number("gamma", &P::peakEnhancement, "1", Range::within(1.0, 20.0), "peak enhancement γ"));
  }
  return Mapping<P>(std::move(fields), requireSeaLike);
}

// γ is no key of a Pierson–Moskowitz sea: it is 1.
Field<SeaState> piersonMoskowitzField() {
  Field<SeaState> field = alternative<SeaState>("pierson_moskowitz", parametricSchema(false),
                                                "fully developed wind sea");
  field.read = [inner = parametricSchema(false)](SeaState& target, const YamlValue& value) {
    ParametricState state = inner.read(value);
    state.peakEnhancement = 1.0;
    target = state;
  };
  return field;
}

Field<SeaState> octavesField() {
  Field<FittedSeaState> octaves =
      list("octaves", &FittedSeaState::octaves, octaveEntrySchema(), "the octaves themselves");
  return {octaves.description, [=](SeaState& target, const YamlValue& value) {
            FittedSeaState state;
            octaves.read(state, value);
            target = std::move(state);
          }};
}

Field<SeaState> fileField() {
  KeyDescription description{"file",
                             "path",
                             "",
                             "",
                             "",
                             Need::optional,
                             "sea state file of `seaway fit`, relative to the scene",
                             {}};
  return {std::move(description), [](SeaState& target, const YamlValue& value) {
            target = FileState{readText(value), {}};
          }};
}

Mapping<SeaState> stateSchema() {
  return Mapping<SeaState>::oneOf({
      alternative<SeaState>("calm", Mapping<CalmState>({}), "flat water"),
      alternative<SeaState>("jonswap", parametricSchema(true), "wind sea by its spectrum"),
      piersonMoskowitzField(),
      fileField(),
      octavesField(),
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
      mapping("state", &S::state, stateSchema(), "the waves", Need::required),
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
             "speed over ground, negative astern"),
      number("turn_deg_s", &V::turn_deg, "°/s", Range::within(-90.0, 90.0),
             "rate of turn, positive to starboard"),
  });
}

Mapping<SceneCamera> cameraSchema() {
  using C = SceneCamera;
  using P = CameraPlace;
  const Mapping<P> place({
      number("latitude_deg", &P::latitude_deg, "°", latitudes, "WGS84", Need::required),
      number("longitude_deg", &P::longitude_deg, "°", longitudes, "WGS84", Need::required),
      number("height_m", &P::height, "m", Range::within(-1000.0, 10000.0),
             "above the still-water level"),
  });
  return Mapping<C>({
      name("name", &C::name, "unique among cameras"),
      text("mount", &C::mount,
           "vessel that carries the camera; a fixed camera has `place` instead"),
      choice(
          "stabilised", &C::stabilised, {{"true", true}, {"false", false}},
          "carried along by the vessel's place and heading, but not heaving, rolling or pitching"),
      vector("position_m", &C::position, "m", Range::within(-1000.0, 1000.0),
             "on the mount: forward, to port, above its waterline at rest"),
      mapping("place", &C::place, place, "of a fixed camera"),
      number("yaw_deg", &C::yaw_deg, "°", compass,
             "clockwise from the mount's bow; from true north for a fixed camera"),
      number("pitch_deg", &C::pitch_deg, "°", Range::within(-90.0, 90.0), "positive up"),
      number("roll_deg", &C::roll_deg, "°", compass, "positive right side down"),
      number("fov_deg", &C::fieldOfView_deg, "°", Range::within(1.0, 170.0),
             "vertical field of view"),
  });
}

Mapping<LightSettings> lightSchema() {
  const Mapping<Sun> sun({
      number("elevation_deg", &Sun::elevation_deg, "°", Range::within(-90.0, 90.0),
             "above the horizon"),
      number("azimuth_deg", &Sun::azimuth_deg, "°", compass, "compass direction it stands in"),
  });
  const Mapping<Wind> wind({
      number("speed_m_s", &Wind::speed, "m/s", Range::within(0.0, 80.0),
             "at 12.5 m: roughness below the shortest waves of the field"),
  });
  return Mapping<LightSettings>({
      mapping("sun", &LightSettings::sun, sun, "the sun"),
      mapping("wind", &LightSettings::wind, wind, "the wind, as the picture shows it"),
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

Mapping<Accuracy> accuracySchema() {
  return Mapping<Accuracy>({
      number("motion_tolerance_m", &Accuracy::motionTolerance, "m", Range::atLeast(0.0),
             "height that vessels' samples of the sea may leave out, one standard deviation"),
      vector("grid", &Accuracy::grid, "", Range::within(2, 4096),
             "vertices of the projected grid, across and along"),
  });
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
      list("cameras", &Scene::cameras, cameraSchema(), "who looks"),
      mapping("light", &Scene::light, lightSchema(), "sun and wind"),
      mapping("effects", &Scene::effects, effectsSchema(), "what may be simulated and drawn"),
      mapping("accuracy", &Scene::accuracy, accuracySchema(), "what exactness is paid for"),
      mapping("run", &Scene::run, runSchema(), "defaults of `seaway run`"),
  });
  return schema;
}

}  // namespace seaway::bridge
