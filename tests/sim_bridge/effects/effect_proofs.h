#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "surface/effects.h"

/// Scenes that show what an effect costs where it is not called for: a row each, found by the
/// effect, so that an effect without one fails.
namespace seaway::bridge::test {

using Json = nlohmann::ordered_json;

/// Scenes are differences from a quiet bay by day, with one camera 3 m above the water that looks
/// north (JSON merge patches in YAML's words).
struct EffectProof {
  Effect effect;
  const char* busy;   ///< calls for the effect
  const char* quiet;  ///< does not, though where that is possible its cause is in the scene
  /// Without the cause: what `busy` must be like with the effect switched off; none where there is
  /// no such scene.
  const char* bare = nullptr;
  /// What must not change where the effect is forced on; `quiet` where there is none. Other than
  /// that where forcing it on shows what is only held back: lamps by day, a sky below the horizon.
  const char* forced = nullptr;
};

/// Its proof; none where there is none.
std::optional<EffectProof> proofOf(Effect effect);

/// A scene of a proof, with `setting` ("auto", "on", "off") for its effect. Files that it needs are
/// written into `folder`, which must exist as long as it is used.
Json sceneOf(Effect effect, const char* difference, const char* setting,
             const std::filesystem::path& folder);

}  // namespace seaway::bridge::test
