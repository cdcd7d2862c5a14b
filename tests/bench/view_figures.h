#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <vector>

#include "render/compare_frames.h"
#include "tests/render/random_views.h"

namespace seaway::bench {

/// A view's parameters, and how far its picture is from the reference's.
struct ViewFigures {
  std::uint64_t number = 0;
  render::test::SeaKind sea{};
  double waveHeight = 0.0, time = 0.0;        // m, s
  glm::dvec3 position{0.0};                   // of the camera, m
  double yaw = 0.0, pitch = 0.0, roll = 0.0;  // rad
  double fieldOfView = 0.0;                   // rad
  render::FrameComparison comparison;
  double mismatch = 0.0;          // missing and extra pixels, part of the picture
  double vertexEfficiency = 0.0;  // of pictures with water
  bool hasVertices = false;
  std::size_t notNumbers = 0;  // depths, normals that are no finite numbers in range
};

/// Compares two frames of a random view.
ViewFigures figuresOf(std::uint64_t number, render::test::SeaKind sea,
                      const render::test::RandomView& view, const render::Frame& drawn,
                      const render::Frame& reference);

/// Worst figures so far in one line.
std::string worstSoFar(const std::vector<ViewFigures>& views);

/// Worst, 99th percentile and median of every figure, and the views that are worst in each.
nlohmann::ordered_json summaryOf(const std::vector<ViewFigures>& views);

}  // namespace seaway::bench
