#include "tests/bench/accuracy.h"

#include <cmath>
#include <functional>
#include <vector>

#include "tests/bench/setups.h"

namespace seaway::bench {
namespace {

constexpr std::size_t errorPoints = 400;
constexpr std::size_t spectralBands = 200;  // 0.0385 f_p each

/// Root mean square of heights less the truth at each point.
double rms(const std::vector<double>& heights, const BenchPoints& at,
           const std::function<double(glm::dvec2)>& truth) {
  double sum = 0.0;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    sum += std::pow(heights[i] - truth(at.points[i]), 2);
  }
  return std::sqrt(sum / static_cast<double>(heights.size()));
}

std::vector<double> heightsOf(const std::vector<Texel>& texels) {
  std::vector<double> heights;
  for (const Texel& texel : texels) heights.push_back(texel.height);
  return heights;
}

Accuracy ofField(OctaveKind kind, const BenchPoints& at) {
  const PreparedField& prepared = preparedField(kind);
  BenchArrays out(errorPoints);
  prepared.now.sample(at.x, at.y, out.arrays());
  const auto truth = [&](glm::dvec2 point) {
    SurfaceSample sample;
    prepared.field.sampleReference({&point, 1}, benchTime, {&sample, 1});
    return sample.height;
  };
  return {rms({out.height.begin(), out.height.end()}, at, truth), prepared.residual,
          prepared.field.memoryBytes()};
}

Accuracy ofSines(int count, const BenchPoints& at) {
  const SineSum& sum = sineSum(count);
  const auto components = sineComponents(targetSpectrum(), static_cast<std::size_t>(count));
  BenchArrays out(errorPoints);
  sum.sample(at.x, at.y, out.arrays());
  const auto truth = [&](glm::dvec2 p) { return sineSumHeight(components, p, benchTime); };
  return {rms({out.height.begin(), out.height.end()}, at, truth),
          sineResidual(static_cast<std::size_t>(count)), sum.memoryBytes()};
}

Accuracy ofTile(std::uint32_t size, Interpolation interpolation, const BenchPoints& at) {
  const FftTile& tile = fftTile(size);
  std::vector<Texel> out(errorPoints);
  tile.sample(at.x, at.y, interpolation, out);
  const auto truth = [&](glm::dvec2 p) { return tile.exactHeight(p, benchTime); };
  return {rms(heightsOf(out), at, truth),
          bandResidual(tile.bandVariance(targetSpectrum(), spectralBands)), tile.memoryBytes()};
}

Accuracy ofCached(Interpolation interpolation, double detail, const BenchPoints& at,
                  const std::vector<double>& exact) {
  const CachedOctaves& cached = cachedOctaves();
  std::vector<Texel> out(errorPoints);
  cached.sample(at.x, at.y, interpolation, detail, out);
  std::size_t next = 0;
  const auto truth = [&](glm::dvec2) { return exact[next++]; };
  return {rms(heightsOf(out), at, truth), cachedResidual(), cached.memoryBytes()};
}

}  // namespace

std::map<std::string, Accuracy> measureAccuracy() {
  const BenchPoints at(errorPoints);
  std::map<std::string, Accuracy> result;
  const Accuracy group = ofField(OctaveKind::group, at);
  for (const char* name : {"group/12/64", "group/12/1024", "group/12/65536", "single/12",
                           "group_samples/12/1024", "group_orbital/12/1024",
                           "group_avx2/12/1024", "two_threads/65536"}) {
    result[std::string("field/") + name] = group;
  }
  result["field/scalar/12/1024"] = {0.0, group.spectralResidual, group.memoryBytes};
  result["field/perlin/12/1024"] = result["field/perlin_avx2/12/1024"] =
      ofField(OctaveKind::perlin, at);
  result["field/regular/12/1024"] = ofField(OctaveKind::regular, at);
  for (const int count : {50, 200, 1000}) {
    result["field/sines/" + std::to_string(count) + "/1024"] = ofSines(count, at);
  }
  result["field/sines_avx2/200/1024"] = result["field/sines/200/1024"];
  for (const std::uint32_t size : {256u, 512u}) {
    const std::string name = "field/fft" + std::to_string(size);
    result[name + "_bilinear/1024"] = ofTile(size, Interpolation::bilinear, at);
    result[name + "_bicubic/1024"] = ofTile(size, Interpolation::cubic, at);
  }
  const std::vector<double> exact = cachedOctaves().exactHeights(at.points, benchTime);
  result["field/cached_bilinear/1024"] = ofCached(Interpolation::bilinear, 0.0, at, exact);
  result["field/cached_trilinear/1024"] = ofCached(Interpolation::bilinear, 0.5, at, exact);
  result["field/cached_cubic/1024"] = ofCached(Interpolation::cubic, 0.0, at, exact);
  return result;
}

}  // namespace seaway::bench
