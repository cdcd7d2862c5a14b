#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "sim_bridge/cigi/packets.h"

namespace seaway::bridge::cigi {

/// What is asked of a point; the first three are HeightKind.
enum class PointQuestion : std::uint8_t { aboveTerrain, ofTerrain, extended, velocity };

/// A question about the water at a point, however it was put.
struct PointRequest {
  std::uint16_t request = 0;
  PointQuestion question = PointQuestion::ofTerrain;
  bool entityAxes = false;
  std::uint8_t period = 0;
  std::uint16_t entity = 0;
  double x = 0.0, y = 0.0, z = 0.0;  ///< latitude, longitude (deg), altitude (m), or body axes (m)
};

PointRequest pointRequest(const HatHotRequest& request);
PointRequest pointRequest(const WaterVelocityRequest& request);

/// Requests of one host that wait for an answer, once or every so many frames.
class PointRequests {
 public:
  /// Keeps at most `most` periodic requests, and as many that are answered once.
  explicit PointRequests(std::size_t most) : most_(most) {}

  /// A period replaces that of a request of the same number, no period ends it. False: one too
  /// many, or a question that is none; nothing was changed.
  bool take(const PointRequest& request);

  /// What is to be answered in the next frame, in the order it was asked, periodic ones first; each
  /// call is a frame. Valid until the next call.
  std::span<const PointRequest> nextFrame();

  void clear();

 private:
  struct Periodic {
    PointRequest request;
    std::uint32_t wait = 0;  // frames until the next answer
  };
  std::size_t most_;
  std::map<std::uint32_t, Periodic> periodic_;  // by velocity or not, and the request's number
  std::vector<PointRequest> once_, due_;
};

}  // namespace seaway::bridge::cigi
