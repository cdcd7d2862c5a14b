#pragma once

#include <array>
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
/// Part of the waves that break where still water is h deep: (H_rms/γh)⁴, 1 at the most, after
/// Thornton & Guza 1983 (doi:10.1029/JC088iC10p05925), γ = 0.42, H_rms = H_m0/√2. (H_rms/h inside
/// surf: 0.29 to 0.55, Sallenger & Holman 1985, J. Geophys. Res. 90(C6), 11939.) It is the highest
/// ones that do, heights by Rayleigh's distribution.
///
/// Each breaks as a bore: a roller on its front, behind it foam that decays exponentially until the
/// next one comes, both less where less water is left than the wave is high. A point's place in its
/// wave is the phase of height and slope along the mean direction, of waves from half the mean
/// length on. The roller's length, the foam it leaves and its time of 2.5 s are artistic (whitecaps
/// fade in 0.5 to 8 s: Callaghan, Deane, Stokes & Ward, AMS 20th Symposium on Boundary Layers and
/// Turbulence, 2012). Waves neither shoal nor turn nor lose height for it. Immutable.
class Surf {
 public:
  Surf(std::shared_ptr<const TerrainMap> terrain, const WaveField& waves);

  /// Part of the waves that break over a depth of still water, m; 1 ashore.
  double breaking(double depth) const;
  /// m: where it falls to a 255th, the least that a cover tells from nothing.
  double deepest() const { return deepest_; }

  /// Mean of the foam over a depth of still water, m, negative ashore: of all phases of waves, and
  /// their heights by Rayleigh's distribution.
  float mean(double depth) const;

  /// Adds to the foam at points (x, y) of the sea plane, [0, 1]; returns whether it added any. Of
  /// waves that a row of a grid does not carry (`keptWavelength`, BandLimit) the mean foam is
  /// added. At most 256 points; no allocation.
  bool addTo(const SurfaceAtTime& water, std::span<const double> x, std::span<const double> y,
             double keptWavelength, std::span<float> foam) const;

 private:
  std::shared_ptr<const TerrainMap> terrain_;
  double allBreak_ = 0.0;  // m: the depth at which all waves break
  double deepest_ = 0.0;
  double shortest_ = 0.0;          // m: waves that are bores
  glm::dvec2 towards_{1.0, 0.0};   // mean direction of waves
  double driest_ = 0.0;            // m: the depth, less than 0, that no wave reaches
  std::array<float, 24> means_{};  // from there to `allBreak_`, evenly
};

/// That of a view; none where there are no waves, where no terrain may be in view, and where the
/// effects `foam` or `terrain` are switched off.
std::optional<Surf> surfOf(const View& view);

}  // namespace seaway::render
