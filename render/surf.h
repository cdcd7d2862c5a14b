#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <span>

#include "surface/terrain/terrain_map.h"
#include "surface/water_surface.h"

namespace seaway::render {

struct View;

/// Foam of waves that break on a shore: where a terrain lies so little below the still water that
/// waves of the field's height do not pass over it unbroken.
///
/// Part of the waves that break where still water is h deep: (H_rms/γh)⁴, 1 at the most, γ = 0.42,
/// H_rms = H_m0/√2 (Thornton & Guza 1983, doi:10.1029/JC088iC10p05925, from a beach's surf). How
/// much of such a wave is white is an artistic rule: ½ + η/4σ, [0, 1], all at a crest of two
/// deviations, nothing in such a trough. Waves neither shoal nor break for it. Immutable.
class Surf {
 public:
  /// Waves that a row of a grid does not carry (`keptWavelength`, BandLimit) count as still.
  Surf(std::shared_ptr<const TerrainMap> terrain, const WaveField& waves);

  /// Part of the waves that break over a depth of still water, m; 1 ashore.
  double breaking(double depth) const;
  /// m: where it falls to a 255th, the least that a cover tells from nothing.
  double deepest() const { return deepest_; }

  /// Adds to the foam at points (x, y) of the sea plane, [0, 1]; returns whether it added any. At
  /// most 256 points; no allocation.
  bool addTo(const SurfaceAtTime& water, std::span<const double> x, std::span<const double> y,
             double keptWavelength, std::span<float> foam) const;

 private:
  std::shared_ptr<const TerrainMap> terrain_;
  double allBreak_ = 0.0;  // m: the depth at which all waves break
  double deepest_ = 0.0;
  float perHeight_ = 0.0f;  // 1/m: 1/4σ
};

/// That of a view; none where there are no waves, where no terrain may be in view, and where the
/// effects `foam` or `terrain` are switched off.
std::optional<Surf> surfOf(const View& view);

}  // namespace seaway::render
