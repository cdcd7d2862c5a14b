#pragma once

#include <optional>
#include <span>
#include <vector>

#include "sim_bridge/cigi/counts.h"
#include "sim_bridge/cigi/entities.h"
#include "sim_bridge/cigi/message_writer.h"
#include "sim_bridge/cigi/point_requests.h"
#include "sim_bridge/cigi/water.h"

namespace seaway::bridge::cigi {

/// The moment that a frame's answers hold for.
struct FrameMoment {
  double time = 0.0;        ///< s since the scene's epoch
  double waterLevel = 0.0;  ///< of still water above mean sea level, m
  std::uint32_t hostFrame = 0;
  std::uint32_t host = 0;  ///< as the water knows it
};

/// The material code of answers: water.
inline constexpr std::uint32_t waterMaterial = 1;

/// Answers a frame's requests from one batch of heights and one of velocities. A point without
/// water, out of reach or of an entity that is not there is answered as not valid, its numbers 0.
/// Keeps its memory from one frame to the next.
class PointAnswers {
 public:
  void answer(std::span<const PointRequest> requests, const Entities& entities,
              const FrameMoment& moment, Water& water, MessageWriter& out, Counts& counts);

 private:
  struct Asked {
    PointRequest request;
    double altitude = 0.0;  // m above mean sea level
  };
  void locate(std::span<const PointRequest> requests, const Entities& entities,
              const FrameMoment& moment, Water& water);
  void answerHeights(const FrameMoment& moment, MessageWriter& out, Counts& counts) const;
  void answerVelocities(const FrameMoment& moment, MessageWriter& out, Counts& counts) const;

  std::vector<Asked> heightsAsked_, velocitiesAsked_;
  std::vector<WaterPoint> heightPoints_, velocityPoints_;
  std::vector<WaterHeight> heights_;
  std::vector<WaterVelocity> velocities_;
};

}  // namespace seaway::bridge::cigi
