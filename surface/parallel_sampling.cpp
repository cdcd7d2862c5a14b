#include "surface/parallel_sampling.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>

namespace seaway {
namespace {

/// Points a task: some 0.1 ms of work, whole tiles.
constexpr std::size_t pointsPerTask = 8 * pointsPerTile;

/// Calls work(first, count) for each chunk of `total` points.
template <typename Work>
void inChunks(std::size_t total, int threads, const Work& work) {
  const std::size_t tasks = (total + pointsPerTask - 1) / pointsPerTask;
  if (tasks < 2 || threads == 1) return work(std::size_t{0}, total);
  const auto run = [&] {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, tasks), [&](const auto& range) {
      const std::size_t first = range.begin() * pointsPerTask;
      work(first, std::min(range.end() * pointsPerTask, total) - first);
    });
  };
  if (threads > 0) return tbb::task_arena(threads).execute(run);
  run();
}

}  // namespace

void sampleInParallel(const SurfaceAtTime& water, std::span<const glm::dvec2> points,
                      std::span<SurfaceSample> out, const SampleOptions& options, int threads) {
  inChunks(points.size(), threads, [&](std::size_t first, std::size_t count) {
    water.sample(points.subspan(first, count), out.subspan(first, count), options);
  });
}

void sampleInParallel(const FieldAtTime& waves, std::span<const double> x,
                      std::span<const double> y, const FieldAtTime::Arrays& out,
                      const SampleOptions& options, int threads) {
  inChunks(x.size(), threads, [&](std::size_t first, std::size_t count) {
    const auto part = [&](std::span<float> all) {
      return all.empty() ? all : all.subspan(first, count);
    };
    waves.sample(x.subspan(first, count), y.subspan(first, count),
                 {part(out.height), part(out.slopeX), part(out.slopeY), part(out.rate)}, options);
  });
}

}  // namespace seaway
