#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "render/compare_frames.h"
#include "tests/render/random_views.h"

/// The projected grid against a ray-cast of the same sea, from cameras anywhere:
///
///   compare_views COUNT WIDTH HEIGHT     512x1024 vertices; prints worst and typical figures
namespace {

using namespace seaway::render;

struct Figures {
  std::vector<double> rms, percentile, mismatch, efficiency;
  std::size_t far = 0, broken = 0;
};

void compare(std::uint64_t number, glm::ivec2 size, Figures& figures) {
  const test::RandomView random = test::randomView(number, size);
  seaway::EffectLedger effects;
  View view;
  view.water = &random.water;
  view.time = random.time;
  view.camera = random.camera;
  view.effects = &effects;
  view.wantsNormals = true;
  const ProjectedGridOptions options{.grid = {512, 1024}};
  const Frame drawn = makeSoftwareGrid(options)->draw(view);
  const FrameComparison c =
      compareFrames(view.camera, drawn, makeReference(options)->draw(view));
  for (const float depth : drawn.depth.metres) figures.broken += !(depth > 0.0f);
  figures.far += c.misplaced;
  figures.mismatch.push_back(static_cast<double>(c.missing + c.extra) / (size.x * size.y));
  if (c.compared > 0) {
    figures.rms.push_back(c.positionRms);
    figures.percentile.push_back(c.positionPercentile99);
  }
  if (drawn.stats.vertices > 0) figures.efficiency.push_back(drawn.stats.vertexEfficiency);
}

void print(const char* what, std::vector<double> values) {
  if (values.empty()) return;
  std::sort(values.begin(), values.end());
  const auto at = [&](double share) {
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
  };
  std::printf("%-28s median %.5f, 99 %% %.5f, worst %.5f (%zu views)\n", what, at(0.5), at(0.99),
              at(1.0), values.size());
}

}  // namespace

int main(int argc, char** argv) {
  const int count = argc > 1 ? std::atoi(argv[1]) : 20;
  const glm::ivec2 size{argc > 2 ? std::atoi(argv[2]) : 160, argc > 3 ? std::atoi(argv[3]) : 100};
  Figures figures;
  for (int i = 0; i < count; ++i) compare(static_cast<std::uint64_t>(i), size, figures);
  print("position rms, px", figures.rms);
  print("position 99th percentile, px", figures.percentile);
  print("pixels of another class", figures.mismatch);
  print("vertex efficiency", figures.efficiency);
  std::printf("%zu pixels of another class away from silhouettes, %zu not a number\n", figures.far,
              figures.broken);
  return 0;
}
