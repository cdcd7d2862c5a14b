#pragma once

#include <unistd.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "sim_bridge/shm/shm_endpoint.h"

namespace seaway::bridge::shm::test {

/// A sea whose answers are known in closed form, and what hosts have done to it. Thread-safe.
struct KnownSea : Observer {
  static double heightAt(double x, double y, double t) { return 2.0 * x + 3.0 * y + t; }

  void answered(std::size_t points, double) noexcept override {
    ++requests;
    allPoints += points;
  }
  void refused(seaway_shm_status why) noexcept override {
    ++refusals;
    lastRefusal = why;
  }
  void pictureSent(double) noexcept override { ++pictures; }

  std::set<std::uint32_t> hullsNow() const {
    const std::lock_guard lock(mutex);
    return hulls;
  }
  std::vector<seaway_shm_pose> posesNow() const {
    const std::lock_guard lock(mutex);
    return poses;
  }

  std::atomic<std::uint64_t> requests{0}, allPoints{0}, refusals{0}, pictures{0}, hosts{0};
  std::atomic<int> lastRefusal{0};
  std::atomic<double> seconds{0.0};  ///< that each sample takes
  std::atomic<double> drawing{0.0};  ///< s that each picture takes
  mutable std::mutex mutex;
  std::set<std::uint32_t> hulls;
  std::uint32_t lastHull = 0;
  std::vector<seaway_shm_pose> poses;
};

class KnownHost : public HostSea {
 public:
  explicit KnownHost(KnownSea& sea) : sea_(sea) { ++sea_.hosts; }
  ~KnownHost() override {
    const std::lock_guard lock(sea_.mutex);
    for (const std::uint32_t hull : mine_) sea_.hulls.erase(hull);
    --sea_.hosts;
  }

  void sample(const SampleAsked& asked, std::span<const double> x, std::span<const double> y,
              const SampleArrays& out) override {
    if (asked.ownHull != 0 && !mine_.contains(asked.ownHull)) {
      throw Refused(SEAWAY_SHM_NOT_FOUND, "no hull " + std::to_string(asked.ownHull));
    }
    if (sea_.seconds > 0.0) usleep(static_cast<useconds_t>(1e6 * sea_.seconds));
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double height = KnownSea::heightAt(x[i], y[i], asked.time);
      out.height[i] = height;
      out.error[i] = asked.tolerance;
      out.bound[i] = 0.125;
      out.status[i] = std::isfinite(height) ? 0u : unsigned{SEAWAY_SHM_POINT_NOT_FINITE};
      if (asked.derivatives) {
        out.slopeEast[i] = 2.0;
        out.slopeNorth[i] = 3.0;
        out.verticalVelocity[i] = 1.0;
      }
      if (asked.orbitalVelocity) out.orbitalEast[i] = out.orbitalNorth[i] = out.orbitalUp[i] = 0.5;
    }
  }
  std::uint32_t addHull(std::uint32_t vessel) override {
    if (vessel > 1) throw Refused(SEAWAY_SHM_NOT_FOUND, "no vessel " + std::to_string(vessel));
    const std::lock_guard lock(sea_.mutex);
    mine_.insert(++sea_.lastHull);
    sea_.hulls.insert(sea_.lastHull);
    return sea_.lastHull;
  }
  void placeHulls(double, std::span<const seaway_shm_pose> poses) override {
    const std::lock_guard lock(sea_.mutex);
    sea_.poses.assign(poses.begin(), poses.end());
  }
  void removeHull(std::uint32_t hull) override {
    if (mine_.erase(hull) == 0) throw Refused(SEAWAY_SHM_NOT_FOUND, "no hull");
    const std::lock_guard lock(sea_.mutex);
    sea_.hulls.erase(hull);
  }
  std::string describe() const override { return R"({"sea": "known"})"; }
  std::optional<std::pair<double, double>> wakeSpan() const override { return {{1.0, 2.0}}; }

 private:
  KnownSea& sea_;
  std::set<std::uint32_t> mine_;
};

/// Colour (x, y, 7), depth the pixel's number.
inline Picture knownPicture(std::uint32_t width, std::uint32_t height) {
  struct Pixels {
    std::vector<std::uint8_t> rgb;
    std::vector<float> depth;
  };
  const auto pixels = std::make_shared<Pixels>();
  for (std::uint32_t y = 0; y < height; ++y) {
    for (std::uint32_t x = 0; x < width; ++x) {
      pixels->rgb.insert(pixels->rgb.end(),
                         {static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y), 7});
      pixels->depth.push_back(static_cast<float>(y * width + x));
    }
  }
  return {width, height, pixels->rgb, pixels->depth, pixels};
}

inline std::string uniqueName() {
  static std::atomic<int> count{0};
  return "seaway-test-" + std::to_string(getpid()) + "-" + std::to_string(++count);
}

/// An endpoint on a KnownSea, with small room.
inline ShmOptions knownOptions(KnownSea& sea, const std::string& name) {
  ShmOptions options;
  options.name = name;
  options.segment = {.slots = 4, .cells = 4, .points = 1000, .pixels = 64 * 48};
  options.backing.newHost = [&sea] { return std::make_unique<KnownHost>(sea); };
  options.backing.draw = [&sea](const seaway_shm_picture_request& asked) {
    if (sea.drawing > 0.0) usleep(static_cast<useconds_t>(1e6 * sea.drawing));
    if (std::string(asked.camera) == "nobody") throw Refused(SEAWAY_SHM_NOT_FOUND, "no camera");
    return knownPicture(asked.width == 0 ? 32 : asked.width, asked.height == 0 ? 24 : asked.height);
  };
  options.backing.observer = &sea;
  return options;
}

/// Waits until something is so, for as long as only a hang takes; whether it came.
template <class Condition>
bool comesTrue(Condition condition, double seconds = 20.0) {
  for (int i = 0; i < 1000 * seconds; ++i) {
    if (condition()) return true;
    usleep(1000);
  }
  return false;
}

}  // namespace seaway::bridge::shm::test
