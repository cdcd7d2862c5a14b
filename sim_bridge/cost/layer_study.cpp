#include <cmath>
#include <random>

#include "sim_bridge/cost/study.h"
#include "surface/disturbance/layers/vessel_trail.h"

namespace seaway::bridge {
namespace {

constexpr double speed = 6.0;  // m/s

/// A launch's trail of `duration` s along a straight course, in cells of `cell` m.
struct LaidTrail {
  SurfaceLayer foam, smooth;
};

LaidTrail trailOf(double duration, double cell) {
  LaidTrail trail{SurfaceLayer({.cellSize = cell, .decayTime = 900.0}),
                  SurfaceLayer({.cellSize = cell, .decayTime = 900.0})};
  const glm::dvec2 velocity = speed * glm::dvec2(std::cos(0.5), std::sin(0.5));
  const auto poseAt = [&](double t) { return TrailPose{velocity * t, 0.5, velocity}; };
  for (double t = 0.0; t < duration; t += 0.25) {
    paintTrail({12.0, 3.6}, poseAt, t, t + 0.25, trail.foam, trail.smooth);
  }
  return trail;
}

/// Places within 8 m of the trail, but for its ends.
std::vector<glm::dvec2> placesAlong(double duration, std::size_t count) {
  std::mt19937_64 random(2);
  const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  std::vector<glm::dvec2> places(count);
  for (glm::dvec2& place : places) {
    const double along = speed * duration * (0.1 + 0.8 * uniform()), aside = 16.0 * uniform() - 8.0;
    place = along * glm::dvec2(std::cos(0.5), std::sin(0.5)) +
            aside * glm::dvec2(-std::sin(0.5), std::cos(0.5));
  }
  return places;
}

}  // namespace

std::vector<Study> studyLayers(const StudyOptions& options) {
  const double duration = options.quick ? 30.0 : 600.0;
  const std::string trail =
      std::string(options.quick ? "30 s" : "10 min") + " of a launch's foam and smoothed water";
  const std::string truth = "; error: foam's cover against cells of 1/16 m, rms beside the trail";
  std::vector<Study> studies{
      {"layer_memory", "memory of " + trail + truth, "1", "MB", {}},
      {"layer_painting", "painting of a launch's trail" + truth, "1", "ms/s of trail", {}},
      {"layer_sampling",
       "sampling of foam beside a trail, batches of 1024" + truth,
       "1",
       "ns/point",
       {}}};
  const double shorter = options.quick ? 30.0 : 60.0;  // for the truth: in fine cells all is large
  const auto places = placesAlong(shorter, options.quick ? 8192 : 65536);
  std::vector<float> exact(places.size()), cover(places.size());
  trailOf(shorter, 0.0625).foam.sample(places, shorter, exact);
  for (const double cell : {1.0, 0.5, 0.25, 0.125}) {
    const LaidTrail compared = trailOf(shorter, cell);
    compared.foam.sample(places, shorter, cover);
    double sum = 0.0;
    for (std::size_t i = 0; i < places.size(); ++i) sum += std::pow(cover[i] - exact[i], 2);
    const double error = std::sqrt(sum / static_cast<double>(places.size()));
    const LaidTrail laid = trailOf(duration, cell);
    const Timing painting = timeRepeated([&] { trailOf(shorter, cell); }, 3);
    const Timing sampling = timeRepeated(
        [&] {
          for (std::size_t i = 0; i < places.size(); i += 1024) {
            compared.foam.sample(std::span(places).subspan(i, 1024), shorter,
                                 std::span(cover).subspan(i, 1024));
          }
        },
        options.quick ? 5 : 15);
    const std::string setting = "cell " + std::to_string(cell).substr(0, 5) + " m";
    const auto bytes = static_cast<double>(laid.foam.memoryBytes() + laid.smooth.memoryBytes());
    studies[0].points.push_back({setting, error, 1e-6 * bytes, 0.0, cell});
    studies[1].points.push_back(
        {setting, error, 1e3 * painting.median / shorter, 1e3 * painting.spread / shorter, cell});
    const double perPoint = 1e9 / static_cast<double>(places.size());
    studies[2].points.push_back(
        {setting, error, sampling.median * perPoint, sampling.spread * perPoint, cell});
  }
  return studies;
}

}  // namespace seaway::bridge
