#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// The effect registry: what a scene may simulate or draw, and what it calls for now.
///
/// An effect that is not on costs nothing: whoever implements it asks `EffectLedger::decide` first
/// and neither allocates nor computes when the answer is no. `seaway explain` prints the ledger.
namespace seaway {

/// Every effect Seaway knows. `effectDescriptions()` has one entry each, in this order.
enum class Effect : std::size_t {
  waves,
  vesselMotion,
  hullLoads,
  water,
  sky,
  sun,
  vesselMeshes,
  wake,
  foam,
  trail,
  oil,
  splash,
  rain,
  ripples,
  outline,
  hullMask,
  reflection,
  refraction,
  underWater,
  haze,
  shadows,
  scenery,
  terrain,
  lights,
  moon,
  count
};

/// What a scene asks of an effect.
enum class EffectSetting {
  automatic,  ///< run when called for
  on,         ///< run always
  off,        ///< never run
};

enum class EffectState {
  on,    ///< ran
  idle,  ///< allowed, but nothing called for it
  off,   ///< switched off by the scene
};

/// "on", "idle" or "off".
std::string_view effectStateName(EffectState state);

struct EffectDescription {
  Effect effect;
  std::string_view name;     ///< key under `effects:` in a scene
  std::string_view summary;  ///< what it adds
  std::string_view calledForWhen;
};

std::span<const EffectDescription> effectDescriptions();
/// Its key under `effects:` in a scene.
std::string_view effectName(Effect effect);
std::optional<Effect> effectFromName(std::string_view name);

using EffectSettings = std::array<EffectSetting, static_cast<std::size_t>(Effect::count)>;

/// What one effect did since the ledger was made.
struct EffectReport {
  Effect effect = Effect::count;
  EffectState state = EffectState::idle;
  std::string reason;
  std::size_t memoryBytes = 0;
  double costMicroseconds = 0.0;  ///< wall time charged in all
  /// Whose passes do this effect's work too: it has no pass of its own to be measured, and what it
  /// costs is part of that effect's cost.
  std::optional<Effect> costInside;
};

/// Decides and keeps account. Not thread-safe: one ledger per simulation step or frame.
class EffectLedger {
 public:
  explicit EffectLedger(const EffectSettings& settings = {});

  /// True if `effect` is to run now: never when set off, always when set on, else `calledFor`.
  /// `reason` says why it is or is not called for. One "on" decision outweighs later idle ones.
  bool decide(Effect effect, bool calledFor, std::string_view reason);
  /// Whether the scene switched `effect` off.
  bool isOff(Effect effect) const;

  void charge(Effect effect, double microseconds);
  /// Says that `effect` works inside the passes that `payer` is charged for.
  void chargeInside(Effect effect, Effect payer);
  void holdMemory(Effect effect, std::size_t bytes);

  std::vector<EffectReport> report() const;

 private:
  EffectSettings settings_;
  std::array<EffectReport, static_cast<std::size_t>(Effect::count)> reports_;
};

/// Charges the wall time of a block to an effect.
class EffectTimer {
 public:
  EffectTimer(EffectLedger* ledger, Effect effect);
  ~EffectTimer();
  EffectTimer(const EffectTimer&) = delete;
  EffectTimer& operator=(const EffectTimer&) = delete;

 private:
  EffectLedger* ledger_;  // may be null: nothing is charged
  Effect effect_;
  double start_;
};

}  // namespace seaway
