#include "surface/parallel_sampling.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>

namespace seaway {
namespace {

/// Points a task: some 20 µs of work, whole tiles.
constexpr std::size_t pointsPerTask = 2 * pointsPerTile;

/// Calls work(first, count) for each chunk of `total` points.
template <typename Work>
void inChunks(std::size_t total, const Work& work) {
  const std::size_t tasks = (total + pointsPerTask - 1) / pointsPerTask;
  if (tasks < 2) return work(std::size_t{0}, total);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, tasks), [&](const auto& range) {
    const std::size_t first = range.begin() * pointsPerTask;
    work(first, std::min(range.end() * pointsPerTask, total) - first);
  });
}

}  // namespace

void sampleInParallel(const SurfaceAtTime& water, std::span<const glm::dvec2> points,
                      std::span<SurfaceSample> out, const SampleOptions& options) {
  inChunks(points.size(), [&](std::size_t first, std::size_t count) {
    water.sample(points.subspan(first, count), out.subspan(first, count), options);
  });
}

void sampleInParallel(const FieldAtTime& waves, std::span<const double> x,
                      std::span<const double> y, const FieldAtTime::Arrays& out,
                      const SampleOptions& options) {
  inChunks(x.size(), [&](std::size_t first, std::size_t count) {
    const auto part = [&](std::span<float> all) {
      return all.empty() ? all : all.subspan(first, count);
    };
    waves.sample(x.subspan(first, count), y.subspan(first, count),
                 {part(out.height), part(out.slopeX), part(out.slopeY), part(out.rate)}, options);
  });
}

}  // namespace seaway
