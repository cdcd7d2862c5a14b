#include <algorithm>
#include <cmath>
#include <random>

#include "sim_bridge/cost/study.h"
#include "sim_bridge/scene/scene.h"
#include "sim_bridge/scene/sea.h"
#include "surface/field/kernels/field_blocks.h"
#include "surface/parallel_sampling.h"

namespace seaway::bridge {
namespace {

constexpr std::size_t batch = 1024;

std::vector<glm::dvec2> randomPoints(std::size_t count) {
  std::mt19937_64 random(1);
  const auto uniform = [&] { return (static_cast<double>(random() >> 11) * 0x1p-53 - 0.5) * 20e3; };
  std::vector<glm::dvec2> points(count);
  for (glm::dvec2& point : points) point = {uniform(), uniform()};
  return points;
}

/// Of the points that are not dry; NaN where all are.
double rmsDifference(const std::vector<SurfaceSample>& a, const std::vector<SurfaceSample>& b) {
  double sum = 0.0, count = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!std::isfinite(b[i].height)) continue;
    sum += std::pow(a[i].height - b[i].height, 2);
    ++count;
  }
  return std::sqrt(sum / count);
}

}  // namespace

Study studyQueryOctaves(const Scene& scene, const Sea& sea, const StudyOptions& options) {
  Study study{"query_octaves",
              "height of random points within 10 km, batches of 1024; truth: all octaves",
              "m",
              "ns/point",
              {}};
  const WaterSurface& water = sea.surface;
  const auto points = randomPoints(options.quick ? 8 * batch : 32 * batch);
  std::vector<SurfaceSample> truth(points.size()), samples(points.size());
  constexpr double time = 12.0;
  water.sample(points, time, truth);
  const std::size_t count = water.waves().octaves().size();
  std::vector<std::function<void()>> works;
  for (std::size_t kept = 0; kept <= count; ++kept) {
    const SampleOptions sampling{.tolerance = kept == count ? 0.0 : water.waves().leftOut(kept)};
    water.sample(points, time, samples, sampling);
    study.points.push_back({"octaves " + std::to_string(kept), rmsDifference(samples, truth), 0.0,
                            0.0, static_cast<double>(kept)});
    works.push_back([&, sampling] {
      for (std::size_t i = 0; i < points.size(); i += batch) {
        water.sample(std::span(points).subspan(i, batch), time,
                     std::span(samples).subspan(i, batch), sampling);
      }
    });
  }
  const std::vector<Timing> timings = timeByTurns(works, options.quick ? 5 : 15);
  const double perPoint = 1e9 / static_cast<double>(points.size());
  for (std::size_t kept = 0; kept <= count; ++kept) {
    study.points[kept].cost = timings[kept].median * perPoint;
    study.points[kept].spread = timings[kept].spread * perPoint;
  }
  study.chosen =
      "octaves " + std::to_string(water.waves().octavesFor(scene.accuracy.motionTolerance));
  return study;
}

Study studyQueryWays(const Sea& sea, const StudyOptions& options) {
  Study study{"query_ways",
              "the same heights asked for in different ways; largest difference from the field in "
              "double precision",
              "m",
              "ns/point",
              {}};
  const WaveField& waves = sea.surface.waves();
  const WaterSurface water{waves};
  const auto points = randomPoints(options.quick ? 8 * batch : 32 * batch);
  std::vector<SurfaceSample> truth(points.size()), samples(points.size());
  constexpr double time = 12.0;
  waves.sampleReference(points, time, truth);
  const auto add = [&](const std::string& setting, const std::function<void()>& work) {
    const Timing timing = timeRepeated(work, options.quick ? 3 : 9);
    double largest = 0.0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
      largest = std::max(largest, std::abs(samples[i].height - truth[i].height));
    }
    const double perPoint = 1e9 / static_cast<double>(points.size());
    study.points.push_back({setting, largest, timing.median * perPoint, timing.spread * perPoint});
  };
  add("double precision", [&] { waves.sampleReference(points, time, samples); });
  const auto inBatches = [&](std::size_t size) {
    for (std::size_t i = 0; i < points.size(); i += size) {
      water.sample(std::span(points).subspan(i, size), time, std::span(samples).subspan(i, size));
    }
  };
  for (const char* target : {"SSE4", "AVX2", "AVX3"}) {
    if (!forceKernelTarget(target)) continue;
    add(std::string(target) + ", batches of " + std::to_string(batch), [&] { inBatches(batch); });
  }
  forceKernelTarget("");
  for (const std::size_t size : {std::size_t{1}, std::size_t{8}, std::size_t{64}, batch}) {
    add("batches of " + std::to_string(size), [&] { inBatches(size); });
  }
  add("all threads", [&] { sampleInParallel(water.at(time), points, samples); });
  return study;
}

}  // namespace seaway::bridge
