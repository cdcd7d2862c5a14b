#include "surface/effects.h"

#include <algorithm>
#include <chrono>

namespace seaway {
namespace {

constexpr std::array<EffectDescription, static_cast<std::size_t>(Effect::count)> descriptions{{
    {Effect::waves, "waves", "the wave field, for queries and pictures",
     "the sea state has a significant wave height above zero"},
    {Effect::vesselMotion, "vessel_motion", "heave, roll and pitch of vessels from sampled columns",
     "the scene has a vessel on a prescribed course"},
    {Effect::hullLoads, "hull_loads",
     "pressure, drag and damping on the meshes of free vessels, which move by them; off: they keep "
     "their courses",
     "the scene has a vessel whose motion is free"},
    {Effect::water, "water", "the sea surface in the picture, on a projected grid",
     "the volume the waves can reach meets the camera's view"},
    {Effect::sky, "sky", "procedural sky behind the scene and in reflections",
     "the picture shows sky, water or things that it lights"},
    {Effect::sun, "sun", "sun disc and its glitter on the water", "the sun is above the horizon"},
    {Effect::vesselMeshes, "vessel_meshes", "vessels in the picture",
     "a vessel's bounding sphere meets the camera's view"},
    {Effect::wake, "wake", "waves that vessels make, felt by others and seen",
     "a vessel is or was under way and another hull, a camera or a query is near"},
    {Effect::foam, "foam", "white water in the picture: whitecaps, breaking wakes, trails",
     "water is in view and the wind raises whitecaps, or foam or a wake is there"},
    {Effect::trail, "trail", "foam and smoothed water that vessels leave behind",
     "a vessel is under way and a camera, another hull or a query is there"},
    {Effect::oil, "oil", "oil on the water, which damps short waves", "the scene has `oil`"},
    {Effect::splash, "splash", "splashes and explosions: rings that run out, and their foam",
     "a splash of the scene is alive"},
    {Effect::rain, "rain", "rings of raindrops", "the scene has `rain` at the time"},
    {Effect::ripples, "ripples", "ripples about things that bob, by a cellular automaton",
     "a source of the scene's `ripples` is alive"},
    {Effect::outline, "outline",
     "shores: no water beyond the sea's outline, for queries and pictures",
     "the sea has an outline"},
    {Effect::hullMask, "hull_mask", "no sea inside open hulls in the picture",
     "a vessel with a hold or cockpit is in the camera's view"},
    {Effect::reflection, "reflection", "vessels mirrored in the water around them",
     "the camera, above the water, sees where a vessel is mirrored"},
    {Effect::refraction, "refraction", "what of vessels lies under the water, seen through it",
     "the camera, above the water, sees a vessel's wet part from near"},
    {Effect::underWater, "under_water",
     "Snell's window, total reflection and dimming below the surface",
     "a part of the camera's view is under water"},
    {Effect::haze, "haze", "air that dims and tints what is far",
     "the view has water or things far enough away to be dimmed"},
    {Effect::shadows, "shadows",
     "the sun's shadows of vessels and scenery, on themselves and water",
     "the sun is up and a thing that casts a shadow is in or near the view"},
    {Effect::scenery, "scenery", "meshes of the scene that are no vessels: piers, buoys, houses",
     "an object of the scene meets the camera's view"},
    {Effect::terrain, "terrain", "islands, shores and sea bed by a map of heights",
     "the scene has `terrain` and it meets the camera's view"},
    {Effect::lights, "lights",
     "vessels' navigation lights and lamps of the scene, on the water too",
     "it is dusk or night and a light's arc shows towards the camera"},
    {Effect::moon, "moon", "the moon's disc, its light and its glitter",
     "the scene has `light.moon`, the moon is up and the sun is down"},
}};

/// Reasons are seldom longer, characters.
constexpr std::size_t mostOfAReason = 96;

std::size_t indexOf(Effect effect) { return static_cast<std::size_t>(effect); }

double nowMicroseconds() {
  using namespace std::chrono;
  return duration<double, std::micro>(steady_clock::now().time_since_epoch()).count();
}

}  // namespace

std::span<const EffectDescription> effectDescriptions() { return descriptions; }

std::string_view effectName(Effect effect) { return descriptions[indexOf(effect)].name; }

std::string_view effectStateName(EffectState state) {
  switch (state) {
    case EffectState::on:
      return "on";
    case EffectState::idle:
      return "idle";
    case EffectState::off:
      return "off";
  }
  return "";
}

std::optional<Effect> effectFromName(std::string_view name) {
  const auto found =
      std::find_if(descriptions.begin(), descriptions.end(),
                   [&](const auto& description) { return description.name == name; });
  if (found == descriptions.end()) return std::nullopt;
  return found->effect;
}

EffectLedger::EffectLedger(const EffectSettings& settings) : settings_(settings) {
  for (std::size_t i = 0; i < reports_.size(); ++i) {
    reports_[i].effect = descriptions[i].effect;
    const bool off = settings_[i] == EffectSetting::off;
    reports_[i].state = off ? EffectState::off : EffectState::idle;
    reports_[i].reason.reserve(mostOfAReason);  // so that deciding allocates nothing
    reports_[i].reason = off ? "off in the scene" : "nothing asked for it";
  }
}

bool EffectLedger::decide(Effect effect, bool calledFor, std::string_view reason) {
  EffectReport& report = reports_[indexOf(effect)];
  const EffectSetting setting = settings_[indexOf(effect)];
  if (setting == EffectSetting::off) return false;
  const bool runs = calledFor || setting == EffectSetting::on;
  if (report.state != EffectState::on || runs) {
    report.state = runs ? EffectState::on : EffectState::idle;
    report.reason.clear();
    if (runs && !calledFor) report.reason = "forced on; ";
    report.reason += reason;
  }
  return runs;
}

bool EffectLedger::isOff(Effect effect) const {
  return settings_[indexOf(effect)] == EffectSetting::off;
}

void EffectLedger::charge(Effect effect, double microseconds) {
  reports_[indexOf(effect)].costMicroseconds += microseconds;
}

void EffectLedger::chargeInside(Effect effect, Effect payer) {
  reports_[indexOf(effect)].costInside = payer;
}

void EffectLedger::holdMemory(Effect effect, std::size_t bytes) {
  reports_[indexOf(effect)].memoryBytes = bytes;
}

std::vector<EffectReport> EffectLedger::report() const {
  return {reports_.begin(), reports_.end()};
}

EffectTimer::EffectTimer(EffectLedger* ledger, Effect effect)
    : ledger_(ledger), effect_(effect), start_(ledger ? nowMicroseconds() : 0.0) {}

EffectTimer::~EffectTimer() {
  if (ledger_) ledger_->charge(effect_, nowMicroseconds() - start_);
}

}  // namespace seaway
