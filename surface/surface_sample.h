#pragma once

#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <string>

namespace seaway {

/// What an answer wants the asker to know; a set of bits, 0 is "ok".
enum class SampleStatus : std::uint32_t {
  ok = 0,
  truncated = 1u << 0,     ///< octaves were left out, as the options allow; `error` says how much
  notFinite = 1u << 1,     ///< the point or the time was NaN or infinite; values are NaN
  outOfRange = 1u << 2,    ///< a place or time too far to be served; values are NaN. The field sets
                           ///< it beyond WaveField::farthest and latest, geodetic queries beyond
                           ///< Geodesy::usableRange
  noKinematics = 1u << 3,  ///< the field has Perlin octaves: orbital motion is not defined, NaN
  aboveSurface = 1u << 4,  ///< the point is in the air: no water motion there, NaN
  belowBed = 1u << 5,      ///< the point is in the sea bed, or the bed has fallen dry: NaN
  wakeOutOfTime = 1u << 6,  ///< the time is before or after the wakes' snapshot: its nearer end is
                            ///< given
  wakePartial = 1u << 7,  ///< some of a wake's waves are missing or too low here: the point lies in
                          ///< a window's border, or beyond the window of the short waves
  dry = 1u << 8,  ///< outside the water's outline, or the terrain stands above the water: there is
                  ///< no water, values are NaN
};

constexpr SampleStatus operator|(SampleStatus a, SampleStatus b) {
  return static_cast<SampleStatus>(static_cast<std::uint32_t>(a) | static_cast<std::uint32_t>(b));
}
constexpr SampleStatus& operator|=(SampleStatus& a, SampleStatus b) { return a = a | b; }
constexpr bool has(SampleStatus set, SampleStatus bit) {
  return (static_cast<std::uint32_t>(set) & static_cast<std::uint32_t>(bit)) != 0;
}

/// "ok", or the names of the bits joined by '|': `truncated|out_of_range`.
std::string statusText(SampleStatus status);

/// The water surface at one point and time, in the sea plane.
struct SurfaceSample {
  double height = 0.0;            ///< m above the still-water level
  glm::dvec2 slope{0.0};          ///< (∂η/∂x, ∂η/∂y), dimensionless
  double verticalVelocity = 0.0;  ///< ∂η/∂t at the fixed point, m/s
  /// Velocity of the water at the surface (east, north, up), m/s, the current not included; NaN
  /// unless SampleOptions asks for it.
  glm::dvec3 orbitalVelocity{std::numeric_limits<double>::quiet_NaN()};
  double error = 0.0;  ///< one standard deviation of the height left out, m
  double bound = 0.0;  ///< largest numerical error of the height, m
  SampleStatus status = SampleStatus::ok;

  /// Upward unit normal of the surface.
  glm::dvec3 normal() const { return glm::normalize(glm::dvec3(-slope.x, -slope.y, 1.0)); }
};

/// How exact an answer is wanted. The default asks for everything.
struct SampleOptions {
  /// Height that may be left out, m, one standard deviation; ≥ 0. Octaves are kept by falling
  /// variance until what remains is no more than this.
  double tolerance = 0.0;
  /// Shortest waves wanted, m; ≥ 0. Octaves whose dominant wavelength is shorter are left out.
  double shortestWavelength = 0.0;
  /// Fill slope and ∂η/∂t; without them (and without `orbitalVelocity`, which needs them) they are
  /// NaN and a sample is some 15 % cheaper.
  bool derivatives = true;
  bool orbitalVelocity = false;  ///< fill SurfaceSample::orbitalVelocity
  /// Handle of a vessel whose own waves are left out, 0 for none: a hull's wave-making is in its
  /// resistance, it must not feel it twice. Without wakes in the scene there is nothing to leave
  /// out.
  std::uint32_t excludeVessel = 0;
};

/// The shortest wavelength that matters to a hull of a length in m: a quarter of it. Pressures of
/// shorter waves cancel over the hull (their force falls below 2 % of what the height suggests).
constexpr double cutoffFor(double hullLength) { return 0.25 * hullLength; }

}  // namespace seaway
