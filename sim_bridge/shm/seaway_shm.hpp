// seaway_shm.h in C++20: connections that end by themselves, spans, exceptions. Header only.
//
//   seaway::shm::Client sea("sea");
//   const auto samples = sea.sample(x, y, {.time = t});
//   use(samples.height[0]);
#ifndef SEAWAY_SHM_HPP
#define SEAWAY_SHM_HPP

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

#include "seaway_shm.h"

namespace seaway::shm {

using Status = seaway_shm_status;
using Pose = seaway_shm_pose;

/// A call that was not OK; `what` says why.
class Error : public std::runtime_error {
 public:
  Error(Status status, const std::string& message)
      : std::runtime_error(std::string(seaway_shm_status_text(status)) + ": " + message),
        status_(status) {}
  Status status() const { return status_; }

 private:
  Status status_;
};

/// How samples are wanted.
struct How {
  double time = 0.0;                ///< s since the scene's epoch
  double tolerance = 0.0;           ///< m, one standard deviation of height; 0: all waves
  double shortestWavelength = 0.0;  ///< m; 0: all waves
  std::uint32_t ownHull = 0;        ///< whose own waves are left out; 0: none
  bool geodetic = false;            ///< x longitude, y latitude, degrees; else the sea plane, m
  bool derivatives = true;          ///< slopes and vertical velocity
  bool orbitalVelocity = false;
  bool serversTime = false;  ///< the server's clock in place of `time`

  seaway_shm_request request() const {
    seaway_shm_request made{};
    made.time = time;
    made.tolerance = tolerance;
    made.shortest_wavelength = shortestWavelength;
    made.own_hull = ownHull;
    made.flags = (geodetic ? unsigned{SEAWAY_SHM_GEODETIC} : 0u) |
                 (derivatives ? 0u : unsigned{SEAWAY_SHM_HEIGHT_ONLY}) |
                 (orbitalVelocity ? unsigned{SEAWAY_SHM_ORBITAL_VELOCITY} : 0u) |
                 (serversTime ? unsigned{SEAWAY_SHM_SERVERS_TIME} : 0u);
    return made;
  }
};

/// An answer in the shared memory, until layout().cell_count further requests; spans of what was
/// not asked for are empty.
struct Samples {
  double time = 0.0;
  std::span<const double> height, slopeEast, slopeNorth, verticalVelocity;
  std::span<const double> orbitalEast, orbitalNorth, orbitalUp, error, bound;
  std::span<const std::uint32_t> status;  ///< SEAWAY_SHM_POINT_ bits
};

/// Pixels in the shared memory, until the next picture is asked for.
struct Picture {
  std::uint32_t width = 0, height = 0;
  double time = 0.0;
  std::span<const unsigned char> rgb;
  std::span<const float> depth;  ///< axial m, +inf for sky
};

/// A connection, for one thread at a time. Calls throw Error; after one of SEAWAY_SHM_SERVER_GONE
/// `reconnect`, and add hulls anew.
class Client {
 public:
  explicit Client(const std::string& name,
                  const seaway_shm_options& options = seaway_shm_default_options())
      : client_(new seaway_shm_client) {
    require(seaway_shm_connect(client_.get(), name.c_str(), &options));
  }

  void reconnect() { require(seaway_shm_reconnect(client_.get())); }
  const seaway_shm_header& layout() const { return client_->layout; }
  /// For calls of seaway_shm.h.
  seaway_shm_client& c() { return *client_; }

  /// The water at points of x and y alike in number.
  Samples sample(std::span<const double> x, std::span<const double> y, const How& how) {
    if (x.size() != y.size() || x.size() > UINT32_MAX) {
      throw Error(SEAWAY_SHM_BAD_VALUE, "x and y must be alike in number");
    }
    const seaway_shm_request request = how.request();
    seaway_shm_batch batch{};
    const auto count = static_cast<std::uint32_t>(x.size());
    require(seaway_shm_sample(client_.get(), &request, x.data(), y.data(), count, &batch));
    return samplesOf(batch, request.flags, count);
  }

  std::uint32_t addHull(std::uint32_t vessel) {
    std::uint32_t hull = 0;
    require(seaway_shm_add_hull(client_.get(), vessel, &hull));
    return hull;
  }
  void placeHulls(double t, std::span<const Pose> poses) {
    require(seaway_shm_place_hulls(client_.get(), t, poses.data(),
                                   static_cast<std::uint32_t>(poses.size())));
  }
  void removeHull(std::uint32_t hull) { require(seaway_shm_remove_hull(client_.get(), hull)); }

  /// JSON.
  std::string describe() {
    std::string text(65536, '\0');
    std::size_t length = 0;
    require(seaway_shm_describe(client_.get(), text.data(), text.size(), &length));
    if (length >= text.size()) {
      text.resize(length + 1);
      require(seaway_shm_describe(client_.get(), text.data(), text.size(), &length));
    }
    text.resize(length < text.size() ? length : text.size() - 1);
    return text;
  }

  /// Asks for a picture, to be waited for; samples go on meanwhile.
  void askPicture(const seaway_shm_picture_request& picture) {
    require(seaway_shm_ask_picture(client_.get(), &picture));
  }
  Picture waitPicture(double timeout) {
    seaway_shm_picture got{};
    require(seaway_shm_wait_picture(client_.get(), &got, timeout));
    const std::size_t pixels = std::size_t{got.width} * got.height;
    return {got.width, got.height, got.time, {got.rgb, 3 * pixels}, {got.depth, pixels}};
  }

 private:
  struct Disconnect {
    void operator()(seaway_shm_client* client) const {
      seaway_shm_disconnect(client);
      delete client;
    }
  };

  void require(Status status) const {
    if (status != SEAWAY_SHM_OK) throw Error(status, client_->message);
  }

  static Samples samplesOf(const seaway_shm_batch& batch, std::uint32_t flags, std::size_t n) {
    Samples got;
    got.time = batch.answer->time;
    got.height = {batch.height, n};
    got.error = {batch.error, n};
    got.bound = {batch.bound, n};
    got.status = {batch.status, n};
    if ((flags & SEAWAY_SHM_HEIGHT_ONLY) == 0 || (flags & SEAWAY_SHM_ORBITAL_VELOCITY) != 0) {
      got.slopeEast = {batch.slope_east, n};
      got.slopeNorth = {batch.slope_north, n};
      got.verticalVelocity = {batch.vertical_velocity, n};
    }
    if ((flags & SEAWAY_SHM_ORBITAL_VELOCITY) != 0) {
      got.orbitalEast = {batch.orbital_east, n};
      got.orbitalNorth = {batch.orbital_north, n};
      got.orbitalUp = {batch.orbital_up, n};
    }
    return got;
  }

  std::unique_ptr<seaway_shm_client, Disconnect> client_;
};

}  // namespace seaway::shm

#endif
