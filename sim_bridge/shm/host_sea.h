#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

#include "sim_bridge/shm/seaway_shm_layout.h"

/// What the shared memory asks of a sea, without a sea.
namespace seaway::bridge::shm {

/// Why a request is not answered, for the host that made it.
struct Refused : std::runtime_error {
  Refused(seaway_shm_status why, const std::string& message)
      : std::runtime_error(message), status(why) {}
  seaway_shm_status status;
};

/// How a host wants its samples; checked.
struct SampleAsked {
  double time = 0.0;  ///< s since the scene's epoch; may be NaN
  double tolerance = 0.0;
  double shortestWavelength = 0.0;
  bool geodetic = false;  ///< x longitude, y latitude, degrees; vectors true east and north
  bool derivatives = true;
  bool orbitalVelocity = false;
  std::uint32_t ownHull = 0;  ///< of this host; 0: none
};

/// Where samples go: as many places as points, write-only (a host may change what lies there).
struct SampleArrays {
  double *height, *slopeEast, *slopeNorth, *verticalVelocity;
  double *orbitalEast, *orbitalNorth, *orbitalUp, *error, *bound;
  std::uint32_t* status;
};

/// The sea as one host asks it; its hulls go with it. One thread at a time, several on one sea.
class HostSea {
 public:
  virtual ~HostSea() = default;
  /// `x` and `y` alike in size, of at most the limit's points, any values.
  virtual void sample(const SampleAsked& asked, std::span<const double> x,
                      std::span<const double> y, const SampleArrays& out) = 0;
  /// A hull of the scene's vessel `vessel`, above 0. Throws Refused.
  virtual std::uint32_t addHull(std::uint32_t vessel) = 0;
  /// Throws Refused for a hull that is not this host's, and for values that are no place; then
  /// none is moved.
  virtual void placeHulls(double t, std::span<const seaway_shm_pose> poses) = 0;
  virtual void removeHull(std::uint32_t hull) = 0;
  /// JSON.
  virtual std::string describe() const = 0;
  /// First and last time that wakes cover; none without wakes.
  virtual std::optional<std::pair<double, double>> wakeSpan() const = 0;
};

/// A drawn picture; `kept` holds its pixels.
struct Picture {
  std::uint32_t width = 0, height = 0;
  std::span<const std::uint8_t> rgb;
  std::span<const float> depth;
  std::shared_ptr<const void> kept;
};

/// What is counted; called from several threads.
class Observer {
 public:
  virtual ~Observer() = default;
  virtual void answered(std::size_t points, double seconds) noexcept = 0;
  /// SEAWAY_SHM_NO_SLOT: a host that says it found none, on trust.
  virtual void refused(seaway_shm_status why) noexcept = 0;
  virtual void pictureSent(double seconds) noexcept = 0;
};

/// Everything that stands behind the shared memory.
struct Backing {
  std::function<std::unique_ptr<HostSea>()> newHost;
  /// At the time of the request, which is finite; the size is within the limit. Throws Refused.
  std::function<Picture(const seaway_shm_picture_request&)> draw;
  std::function<std::optional<double>()> now;  ///< the server's clock, where it has one
  Observer* observer = nullptr;                ///< outlives all
};

}  // namespace seaway::bridge::shm
