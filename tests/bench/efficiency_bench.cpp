#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include "render/ordinary_views.h"
#include "render/projector.h"
#include "render/sea_grid.h"
#include "sim_bridge/report/plot.h"
#include "tests/render/seas.h"

/// Vertex efficiency of the projected grid over ordinary views (render/ordinary_views.h), 64x128
/// vertices, with the thesis' rectangle and with rows that end where the picture does:
///
///   efficiency_bench [VIEWS] [FILE.svg]     a histogram of 1000 views; the same drawn
namespace {

using namespace seaway;
using namespace seaway::render;

std::vector<double> efficiencies(RowEnds rowEnds, unsigned views) {
  std::vector<double> result;
  SeaGrid grid;
  for (unsigned i = 0; i < views; ++i) {
    const OrdinaryView view = ordinaryView(i);
    const double height = view.significantWaveHeight;
    const WaterSurface water = test::windSea(height, 30.0 + 12.0 * height);
    const auto projector =
        Projector::aimedAt(view.camera, water.heightBound(), {.rowEnds = rowEnds});
    if (!projector) continue;
    grid.fill(water.at(1.0), view.camera, projectedLayout(*projector, water.waves(), {64, 128}));
    result.push_back(static_cast<double>(grid.verticesInFrustum(view.camera)) /
                     static_cast<double>(grid.vertexCount()));
  }
  std::sort(result.begin(), result.end());
  return result;
}

constexpr int bins = 20;

std::vector<double> histogram(const std::vector<double>& values) {
  std::vector<double> shares(bins, 0.0);
  for (const double value : values) {
    shares[std::min(static_cast<int>(value * bins), bins - 1)] +=
        100.0 / static_cast<double>(values.size());
  }
  return shares;
}

double quantile(const std::vector<double>& sorted, double share) {
  return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
}

void print(const char* name, const std::vector<double>& sorted) {
  std::printf("%s: median %.3f, a tenth below %.3f, a tenth above %.3f (%zu views)\n", name,
              quantile(sorted, 0.5), quantile(sorted, 0.1), quantile(sorted, 0.9), sorted.size());
  const std::vector<double> shares = histogram(sorted);
  for (int i = 0; i < bins; ++i) {
    const std::string bar(static_cast<std::size_t>(shares[i] + 0.5), '#');
    std::printf("  %3d..%3d %%  %5.1f %% %s\n", 5 * i, 5 * (i + 1), shares[i], bar.c_str());
  }
}

void draw(const std::vector<double>& rectangle, const std::vector<double>& fitted,
          const std::string& file) {
  std::vector<double> middles(bins);
  for (int i = 0; i < bins; ++i) middles[i] = 100.0 * (i + 0.5) / bins;
  const bridge::Plot plot{
      "Vertex efficiency over ordinary views",
      {.label = "vertices in the picture (%)", .low = 0.0, .high = 100.0},
      {.label = "views (%)"},
      {{"rows to the sides of the view", middles, histogram(fitted), bridge::CurveStyle::boxes},
       {"rectangle", middles, histogram(rectangle), bridge::CurveStyle::line}}};
  std::ofstream(file) << bridge::svgOf(plot);
}

}  // namespace

int main(int argc, char** argv) {
  const int views = argc > 1 ? std::max(std::atoi(argv[1]), 1) : 1000;
  const auto rectangle = efficiencies(RowEnds::rectangle, static_cast<unsigned>(views));
  const auto fitted = efficiencies(RowEnds::visible, static_cast<unsigned>(views));
  print("rectangle", rectangle);
  print("rows to the sides of the view", fitted);
  if (argc > 2) draw(rectangle, fitted, argv[2]);
  return 0;
}
