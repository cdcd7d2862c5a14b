#include "sim_bridge/scene/sea_state_schema.h"

#include "sim_bridge/scene/schema_fields.h"

namespace seaway::bridge {
namespace {

using P = ParametricState;

constexpr int mostOctaves = 64;

// Far beyond any water: all numbers downstream stay finite.
const Range heights = Range::within(0.0, 1000.0), periods = Range::within(0.01, 1e4);

void check(const YamlValue& value, const char* key, double number, const Range& range,
           const char* unit) {
  const YamlValue* given = value.find(key);
  if (!given || range.holds(number)) return;
  given->fail(given->scalar + " is not allowed; " + range.sentence() + " " + unit);
}

void requireSeaLike(const P& state, const YamlValue& value) {
  check(value, "hm0_m", state.significantWaveHeight, heights, "m");
  check(value, "tp_s", state.peakPeriod, periods, "s");
}

void requireSpreadingWind(const P& state, const YamlValue& value) {
  const bool wanted = state.spreading == Spreading::mitsuyasu;
  if (wanted && !value.find("spread_wind_m_s")) {
    value.fail("lacks 'spread_wind_m_s', which `spread: mitsuyasu` goes by");
  }
  if (!wanted && value.find("spread_wind_m_s")) {
    value.find("spread_wind_m_s")->fail("is for `spread: mitsuyasu` only");
  }
  if (wanted && value.find("spread_s")) {
    value.find("spread_s")->fail("is for `spread: cosine` only");
  }
}

Field<P> heightField(Need need = Need::required) {
  return number("hm0_m", &P::significantWaveHeight, "m", Range::above(0.0),
                "significant wave height H_m0, at most 1000", need);
}

Field<P> periodField(Need need = Need::required) {
  return number("tp_s", &P::peakPeriod, "s", Range::above(0.0), "peak period", need);
}

Field<P> gammaField() {
  return number("gamma", &P::peakEnhancement, "1", Range::within(1.0, 20.0), "peak enhancement γ");
}

/// What every parametric sea has, and what those with one wind sea have besides.
void addCommon(std::vector<Field<P>>& fields, bool ofOneWind) {
  fields.push_back(number("from_deg", &P::from_deg, "°", Range::within(-360.0, 360.0),
                          "compass direction the waves come from", Need::required));
  fields.push_back(
      number("spread_s", &P::spreadExponent, "1", Range::atLeast(0.5).orInfinite(),
             "exponent s of the spreading cos²ˢ((θ − θ_m)/2) that the sea has at its frequencies"));
  if (ofOneWind) {
    fields.push_back(
        choice("spread", &P::spreading,
               {{"cosine", Spreading::cosinePower}, {"mitsuyasu", Spreading::mitsuyasu}},
               "one exponent, or Mitsuyasu's: narrowest at the peak, by the wind"));
    fields.push_back(number("spread_wind_m_s", &P::spreadWind, "m/s", Range::between(0.0, 80.0),
                            "wind at 10 m for `spread: mitsuyasu`"));
  }
  fields.push_back(integer("octaves", &P::octaves, 0, mostOctaves,
                           "octaves to fit; 0: 24 group octaves or 8 Perlin octaves"));
}

/// A kind of parametric sea; `settle` gives what the file does not.
Field<SeaState> family(const char* key, std::vector<Field<P>> fields, bool ofOneWind,
                       const char* summary,
                       const std::function<void(P&, const YamlValue&)>& settle) {
  addCommon(fields, ofOneWind);
  const Mapping<P> schema(std::move(fields), [](const P& state, const YamlValue& value) {
    requireSeaLike(state, value);
    requireSpreadingWind(state, value);
  });
  Field<SeaState> field = alternative<SeaState>(key, schema, summary);
  field.read = [=](SeaState& target, const YamlValue& value) {
    P state = schema.read(value);
    settle(state, value);
    target = std::move(state);
  };
  return field;
}

std::function<void(P&, const YamlValue&)> ofFamily(SpectralFamily which) {
  return [=](P& state, const YamlValue&) { state.family = which; };
}

Field<SeaState> piersonMoskowitzField() {
  return family(
      "pierson_moskowitz",
      {heightField(Need::optional), periodField(Need::optional),
       number("wind_m_s", &P::windSpeed, "m/s", Range::between(0.0, 100.0),
              "wind at 19.5 m that the sea has grown to; exactly this or hm0_m and tp_s")},
      true, "fully developed wind sea", [](P& state, const YamlValue& value) {
        // γ is no key of such a sea: it is 1.
        state.peakEnhancement = 1.0;
        const int given = (value.find("hm0_m") != nullptr) + (value.find("tp_s") != nullptr);
        if (given != (value.find("wind_m_s") ? 0 : 2)) {
          value.fail("needs hm0_m and tp_s, or wind_m_s alone");
        }
        if (given == 0) state.family = SpectralFamily::piersonMoskowitzOfWind;
      });
}

Mapping<OchiHubblePart> partSchema() {
  using O = OchiHubblePart;
  return Mapping<O>({
      number("hm0_m", &O::significantWaveHeight, "m", heights, "its H_m0", Need::required),
      number("tp_s", &O::peakPeriod, "s", periods, "its peak period", Need::required),
      number("lambda", &O::shape, "1", Range{.least = 0.0, .most = 20.0, .leastIncluded = false},
             "shape λ: 1 is Pierson–Moskowitz, larger is narrower"),
  });
}

Field<SeaState> ochiHubbleField() {
  return family(
      "ochi_hubble",
      {heightField(Need::optional), mapping("swell", &P::swell, partSchema(), "the longer system"),
       mapping("wind_sea", &P::windSea, partSchema(), "the shorter system")},
      false, "swell and wind sea: two systems, or the most probable ones of an H_m0 up to 20 m",
      [](P& state, const YamlValue& value) {
        state.family = SpectralFamily::ochiHubble;
        const int given = state.swell.has_value() + state.windSea.has_value();
        if (given != (value.find("hm0_m") ? 0 : 2)) {
          value.fail("needs hm0_m alone, or swell and wind_sea");
        }
        check(value, "hm0_m", state.significantWaveHeight, Range::within(0.0, 20.0), "m");
        if (given == 2 &&
            state.swell->significantWaveHeight + state.windSea->significantWaveHeight == 0.0) {
          value.fail("has no waves: both hm0_m are 0 (for flat water use `calm: {}`)");
        }
      });
}

Field<SeaState> swellField() {
  return family("swell",
                {heightField(), periodField(),
                 number("width_hz", &P::width, "Hz", Range::above(0.0),
                        "width of the bell, one standard deviation; at most 0.5/tp_s")},
                false, "swell as a Gaussian bell in frequency",
                [](P& state, const YamlValue& value) {
                  state.family = SpectralFamily::swell;
                  const double most = 0.5 / state.peakPeriod;
                  check(value, "width_hz", state.width,
                        Range{.least = 0.0, .most = most, .leastIncluded = false}, "Hz");
                  state.width = std::min(state.width, most);  // the default, for very long swell
                });
}

Field<SeaState> wmoField() {
  return family("wmo",
                {integer("state", &P::code, 1, 9, "code of the WMO's table 3700 (0 is `calm: {}`)",
                         Need::required)},
                true,
                "Pierson–Moskowitz sea with the middle height and usual period of a sea state",
                ofFamily(SpectralFamily::wmo));
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

}  // namespace

Mapping<SeaState> seaStateSchema() {
  return Mapping<SeaState>::oneOf({
      alternative<SeaState>("calm", Mapping<CalmState>({}), "flat water"),
      family("jonswap", {heightField(), periodField(), gammaField()}, true,
             "wind sea by its spectrum", ofFamily(SpectralFamily::jonswap)),
      piersonMoskowitzField(),
      family("tma", {heightField(), periodField(), gammaField()}, true,
             "wind sea in water of the sea's own depth_m", ofFamily(SpectralFamily::tma)),
      ochiHubbleField(),
      family("torsethaugen", {heightField(), periodField()}, false,
             "swell and wind sea of the open North Sea, by its H_m0 and T_p",
             ofFamily(SpectralFamily::torsethaugen)),
      swellField(),
      wmoField(),
      fileField(),
      octavesField(),
  });
}

}  // namespace seaway::bridge
