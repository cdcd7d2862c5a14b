#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "sim_bridge/capi/handles.h"
#include "sim_bridge/capi/point_blocks.h"
#include "sim_bridge/capi/sample_options.h"
#include "sim_bridge/output/number_text.h"
#include "sim_bridge/service/wave_arrays.h"

namespace seaway::bridge::capi {
namespace {

static_assert(SEAWAY_SAMPLE_TRUNCATED == static_cast<unsigned>(SampleStatus::truncated));
static_assert(SEAWAY_SAMPLE_NOT_FINITE == static_cast<unsigned>(SampleStatus::notFinite));
static_assert(SEAWAY_SAMPLE_OUT_OF_RANGE == static_cast<unsigned>(SampleStatus::outOfRange));
static_assert(SEAWAY_SAMPLE_NO_KINEMATICS == static_cast<unsigned>(SampleStatus::noKinematics));
static_assert(SEAWAY_SAMPLE_ABOVE_SURFACE == static_cast<unsigned>(SampleStatus::aboveSurface));
static_assert(SEAWAY_SAMPLE_BELOW_BED == static_cast<unsigned>(SampleStatus::belowBed));
static_assert(SEAWAY_SAMPLE_WAKE_OUT_OF_TIME == static_cast<unsigned>(SampleStatus::wakeOutOfTime));
static_assert(SEAWAY_SAMPLE_WAKE_PARTIAL == static_cast<unsigned>(SampleStatus::wakePartial));
static_assert(SEAWAY_SAMPLE_DRY == static_cast<unsigned>(SampleStatus::dry));

constexpr seaway_points pointDefaults{
    sizeof(seaway_points), SEAWAY_SEA_PLANE, 0, nullptr, nullptr, nullptr};
constexpr seaway_samples noSamples{sizeof(seaway_samples),
                                   0,
                                   nullptr,
                                   nullptr,
                                   nullptr,
                                   nullptr,
                                   nullptr,
                                   nullptr,
                                   nullptr,
                                   nullptr,
                                   nullptr,
                                   nullptr};

// Below this a batch is done before other threads have woken.
constexpr std::size_t fewestForThreads = 4096;

template <class Value>
void write(double* out, const PointBlock& block, const Value& value) {
  if (!out) return;
  if (block.everyPoint) {
    for (std::size_t i = 0; i < block.count; ++i) out[block.first + i] = value(i);
  } else {
    for (std::size_t i = 0; i < block.count; ++i) out[block.rows[i]] = value(i);
  }
}

bool wantsOrbital(const seaway_samples& out) {
  return out.orbital_east || out.orbital_north || out.orbital_up;
}

/// A sampling call, ready to run on any part of its points.
struct Sampling {
  const CoupledSea& sea;
  const SurfaceAtTime& water;
  const seaway_points& points;
  const seaway_samples& out;
  SampleOptions options;

  void run(std::size_t first, std::size_t end) const {
    const bool everyPlace = points.frame == SEAWAY_SEA_PLANE && !points.wanted;
    if (everyPlace && isPlain(water, options)) return runPlain(first, end - first);
    thread_local std::array<SurfaceSample, pointsPerBlock> samples;
    PointBlock& block = threadsBlock();
    PlanePlacer* placer = points.frame == SEAWAY_GEODETIC ? &placerOf(sea) : nullptr;
    while (first < end) {
      first = fill(block, points, first, end, placer);
      const std::span<SurfaceSample> answers = std::span(samples).first(block.count);
      water.sample(block.places(), answers, options);
      writeAll(block, answers);
    }
  }

 private:
  // From the caller's arrays to the caller's arrays.
  void runPlain(std::size_t first, std::size_t count) const noexcept {
    if (count == 0) return;
    const auto from = [=](auto* array) { return array ? array + first : nullptr; };
    sampleWaves<double>(
        water, {points.first + first, count}, {points.second + first, count}, options,
        SampleStatus::ok,
        {from(out.height), from(out.slope_east), from(out.slope_north), from(out.vertical_velocity),
         from(out.error), from(out.bound), from(out.status)});
  }

  void writeAll(const PointBlock& block, std::span<const SurfaceSample> a) const {
    write(out.height, block, [&](std::size_t i) { return a[i].height; });
    write(out.vertical_velocity, block, [&](std::size_t i) { return a[i].verticalVelocity; });
    write(out.orbital_up, block, [&](std::size_t i) { return a[i].orbitalVelocity.z; });
    write(out.error, block, [&](std::size_t i) { return a[i].error; });
    write(out.bound, block, [&](std::size_t i) { return a[i].bound; });
    if (block.geodetic) {
      writeVectors(block, a);
    } else {
      write(out.slope_east, block, [&](std::size_t i) { return a[i].slope.x; });
      write(out.slope_north, block, [&](std::size_t i) { return a[i].slope.y; });
      write(out.orbital_east, block, [&](std::size_t i) { return a[i].orbitalVelocity.x; });
      write(out.orbital_north, block, [&](std::size_t i) { return a[i].orbitalVelocity.y; });
    }
    if (!out.status) return;
    for (std::size_t i = 0; i < block.count; ++i) {
      out.status[block.row(i)] = block.statusOf(i, a[i].status, points);
    }
  }

  void writeVectors(const PointBlock& block, std::span<const SurfaceSample> a) const {
    const auto slope = [&](std::size_t i) { return block.along(i, a[i].slope); };
    const auto motion = [&](std::size_t i) {
      return block.along(i, glm::dvec2(a[i].orbitalVelocity));
    };
    write(out.slope_east, block, [&](std::size_t i) { return slope(i).x; });
    write(out.slope_north, block, [&](std::size_t i) { return slope(i).y; });
    write(out.orbital_east, block, [&](std::size_t i) { return motion(i).x; });
    write(out.orbital_north, block, [&](std::size_t i) { return motion(i).y; });
  }
};

}  // namespace

SampleOptions sampleOptionsOf(const CoupledSea& sea, const CoupledSea::Moment& moment,
                              const seaway_sample_options& given) {
  const auto requireNotNegative = [](const char* name, double value) {
    requireThat(value >= 0.0, [&] {
      return std::string("options.") + name + " is " + numberText(value) + " m; must be >= 0";
    });
  };
  requireNotNegative("tolerance", given.tolerance);
  requireNotNegative("shortest_wavelength", given.shortest_wavelength);
  requireThat(given.parallel <= 1, "options.parallel must be 0 or 1");
  SampleOptions options;
  options.tolerance = given.tolerance;
  options.shortestWavelength = given.shortest_wavelength;
  options.excludeVessel = excludedWake(sea, moment, given.own_vessel);
  return options;
}

}  // namespace seaway::bridge::capi

using namespace seaway::bridge;
using namespace seaway::bridge::capi;

extern "C" {

void seaway_points_init(seaway_points* points, size_t size) {
  initialise(points, size, pointDefaults);
}
void seaway_sample_options_init(seaway_sample_options* options, size_t size) {
  initialise(options, size, seaway_sample_options{});
}
void seaway_samples_init(seaway_samples* samples, size_t size) {
  initialise(samples, size, noSamples);
}

seaway_status seaway_sea_sample(const seaway_sea* handle, double time, const seaway_points* points,
                                const seaway_sample_options* given, const seaway_samples* out) {
  return guarded([&] {
    const CoupledSea& sea = seaOf(handle);
    requirePoints(points);
    requireStruct(out, "out");
    const PreparedWater prepared(sea, time);
    const seaway_sample_options asked = optionsOr(given, {}, "options");
    Sampling sampling{sea, prepared.water(), *points, *out,
                      sampleOptionsOf(sea, prepared.moment(), asked)};
    sampling.options.orbitalVelocity = wantsOrbital(*out);
    sampling.options.derivatives = out->slope_east || out->slope_north || out->vertical_velocity;
    if (asked.parallel == 0 || points->count < fewestForThreads) {
      return sampling.run(0, points->count);
    }
    // Isolated: a thread that waits here must not take up another call's work in its own memory.
    tbb::this_task_arena::isolate([&] {
      tbb::parallel_for(tbb::blocked_range<std::size_t>(0, points->count, fewestForThreads),
                        [&](const auto& part) { sampling.run(part.begin(), part.end()); });
    });
  });
}

}  // extern "C"
