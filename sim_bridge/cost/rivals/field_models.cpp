#include "sim_bridge/cost/rivals/field_models.h"

#include <cmath>
#include <memory>
#include <random>
#include <utility>

#include "sim_bridge/cost/rivals/cached_octaves.h"
#include "sim_bridge/cost/rivals/fft_tile.h"
#include "sim_bridge/cost/rivals/seas.h"
#include "sim_bridge/cost/rivals/sine_sum.h"
#include "surface/constants.h"

namespace seaway::rivals {
namespace {

constexpr std::size_t spectralBands = 200;  // 0.0385 f_p each

/// A field at `modelTime`; kept where it was made, since the prepared one refers to it.
struct Prepared {
  explicit Prepared(std::vector<Octave> octaves)
      : field(std::move(octaves)), now(field.at(modelTime)) {}
  WaveField field;
  FieldAtTime now;
};

/// Room for the answers that come with a height.
struct Derivatives {
  std::vector<float> slopeX, slopeY, rate;
  FieldAtTime::Arrays with(std::span<float> height) {
    for (std::vector<float>* values : {&slopeX, &slopeY, &rate}) values->resize(height.size());
    return {height, slopeX, slopeY, rate};
  }
};

FieldModel fieldModel(std::string name, const FittedOctaves& fit) {
  FieldModel model;
  model.name = std::move(name);
  model.spectralResidual = fit.residual;
  const auto prepared = std::make_shared<Prepared>(fit.octaves);
  const auto rest = std::make_shared<Derivatives>();
  model.memoryBytes = prepared->field.memoryBytes();
  model.sample = [=](auto x, auto y, auto height) {
    prepared->now.sample(x, y, rest->with(height));
  };
  model.exact = [=](std::span<const glm::dvec2> points) {
    std::vector<SurfaceSample> samples(points.size());
    prepared->field.sampleReference(points, modelTime, samples);
    std::vector<double> heights;
    for (const SurfaceSample& sample : samples) heights.push_back(sample.height);
    return heights;
  };
  return model;
}

/// Look-ups answer in texels; `sea` is anything with sample(x, y, …, texels).
template <typename LookUp>
auto heightsByTexel(LookUp lookUp) {
  const auto texels = std::make_shared<std::vector<Texel>>();
  return [=](std::span<const double> x, std::span<const double> y, std::span<float> height) {
    texels->resize(height.size());
    lookUp(x, y, std::span(*texels));
    for (std::size_t i = 0; i < height.size(); ++i) height[i] = (*texels)[i].height;
  };
}

Interpolation interpolationOf(bool cubic) {
  return cubic ? Interpolation::cubic : Interpolation::bilinear;
}

/// Heights at each point by a function of one.
template <typename Height>
auto pointByPoint(Height height) {
  return [=](std::span<const glm::dvec2> points) {
    std::vector<double> heights;
    for (const glm::dvec2& point : points) heights.push_back(height(point));
    return heights;
  };
}

}  // namespace

FieldModel groupModel(const FrequencySpectrum& target, int octaves) {
  return fieldModel("group " + std::to_string(octaves), groupOctaves(target, octaves));
}

FieldModel perlinModel(const FrequencySpectrum& target, int octaves) {
  return fieldModel("perlin " + std::to_string(octaves), perlinOctaves(target, octaves));
}

FieldModel regularModel(const FrequencySpectrum& target, int waves) {
  return fieldModel("regular " + std::to_string(waves),
                    {regularWaves(target, waves), sineResidual(target, waves)});
}

FieldModel sineModel(const FrequencySpectrum& target, int components) {
  FieldModel model;
  model.name = "sines " + std::to_string(components);
  model.spectralResidual = sineResidual(target, static_cast<std::size_t>(components));
  const auto parts = sineComponents(target, static_cast<std::size_t>(components));
  const auto sum = std::make_shared<SineSum>(parts);
  const auto rest = std::make_shared<Derivatives>();
  sum->prepare(modelTime);
  model.memoryBytes = sum->memoryBytes();
  model.sample = [=](auto x, auto y, auto height) { sum->sample(x, y, rest->with(height)); };
  model.exact = pointByPoint([=](glm::dvec2 p) { return sineSumHeight(parts, p, modelTime); });
  return model;
}

FieldModel fftModel(const JonswapParameters& sea, std::uint32_t size, bool cubic) {
  const FrequencySpectrum target = jonswap(sea);
  const double peakWavelength = standardGravity * sea.peakPeriod * sea.peakPeriod / (2.0 * pi);
  const auto tile = std::make_shared<FftTile>(target, size, size * peakWavelength / 49.0);
  tile->step(modelTime);
  FieldModel model;
  model.name = "fft " + std::to_string(size) + (cubic ? " cubic" : " bilinear");
  model.spectralResidual = bandResidual(target, tile->bandVariance(target, spectralBands));
  model.memoryBytes = tile->memoryBytes();
  model.step = [=] { tile->step(modelTime); };
  model.sample = heightsByTexel(
      [=](auto x, auto y, auto texels) { tile->sample(x, y, interpolationOf(cubic), texels); });
  model.exact = pointByPoint([=](glm::dvec2 p) { return tile->exactHeight(p, modelTime); });
  return model;
}

FieldModel cachedModel(const JonswapParameters& sea, bool cubic, double detail) {
  const FittedOctaves fit = halvingPerlinOctaves(sea);
  const auto cached = std::make_shared<CachedOctaves>(fit.octaves);
  cached->step(modelTime);
  FieldModel model;
  model.name = cubic ? "cached cubic" : detail > 0.0 ? "cached trilinear" : "cached bilinear";
  model.spectralResidual = fit.residual;
  model.memoryBytes = cached->memoryBytes();
  model.step = [=] { cached->step(modelTime); };
  model.sample = heightsByTexel([=](auto x, auto y, auto texels) {
    cached->sample(x, y, interpolationOf(cubic), detail, texels);
  });
  model.exact = [=](std::span<const glm::dvec2> points) {
    return cached->exactHeights(points, modelTime);
  };
  return model;
}

double heightError(const FieldModel& model) {
  constexpr std::size_t count = 400;
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(-10e3, 10e3);
  std::vector<glm::dvec2> points(count);
  std::vector<double> x, y;
  for (glm::dvec2& point : points) {
    point.x = uniform(random);
    point.y = uniform(random);
    x.push_back(point.x), y.push_back(point.y);
  }
  std::vector<float> heights(count);
  model.sample(x, y, heights);
  const std::vector<double> truth = model.exact(points);
  double sum = 0.0;
  for (std::size_t i = 0; i < count; ++i) sum += std::pow(heights[i] - truth[i], 2);
  return std::sqrt(sum / static_cast<double>(count));
}

}  // namespace seaway::rivals
