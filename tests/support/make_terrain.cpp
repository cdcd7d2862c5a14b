// Writes configs/terrain/island.png, the map of heights of configs/scenes/island.yaml: a made-up
// island of 2 km with hills, cliffs, a bay with a beach, and a reef around it.
//
//   g++ -std=c++20 -O2 tests/support/make_terrain.cpp -lpng -o /tmp/make_terrain
//   /tmp/make_terrain configs/terrain/island.png
//
// Grey 0 is 40 m below the sea, 65535 is 120 m above it.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <vector>

#include "terrain_noise.h"

namespace {

constexpr int side = 513;        // heights
constexpr double spacing = 4.0;  // m
constexpr double black = -40.0, white = 120.0;
constexpr double step = 0.04;  // m: finer steps would only make the file larger

double smoothLeast(double a, double b, double width) {
  const double part = glm::clamp(0.5 + 0.5 * (b - a) / width, 0.0, 1.0);
  return glm::mix(b, a, part) - width * part * (1.0 - part);
}

/// Distance within the island's outline but for its bay, about, m.
double withinIsland(glm::dvec2 p) {
  const double angle = std::atan2(p.y, p.x), away = glm::length(p * glm::dvec2(0.86, 1.1));
  const double reach =
      500.0 * (1.0 + 0.13 * std::cos(2.0 * angle + 0.7) + 0.08 * std::cos(3.0 * angle - 1.1)) +
      34.0 * noise(p, 170.0) + 11.0 * noise(p, 55.0);
  return reach - away;
}

/// Distance inland of the water's edge, about, m; negative at sea.
double inland(glm::dvec2 p) {
  const double bay = glm::length(p - glm::dvec2(-110.0, -420.0)) - 285.0 + 18.0 * noise(p, 120.0);
  return smoothLeast(withinIsland(p), bay, 90.0);
}

double ground(glm::dvec2 p, double d) {
  const double beach = 0.07 * std::min(d, 36.0) + 0.012 * std::max(d - 36.0, 0.0);
  const double rise = glm::smoothstep(34.0, 330.0, d);
  // The north is steep to the water.
  const double north = glm::smoothstep(60.0, 330.0, p.y + 60.0 * noise(p, 150.0));
  const double cliff = 27.0 * north * glm::smoothstep(2.0, 26.0, d);
  return beach + 125.0 * rise * (0.15 + ridges(p, 260.0) * ridges(p, 260.0)) +
         cliff * (0.7 + 0.5 * ridges(p, 260.0));
}

double bed(glm::dvec2 p, double away) {
  const double beyond = -withinIsland(p);  // of the island without its bay
  const double lagoon = -0.075 * std::min(away, 40.0) - 0.012 * std::max(away - 40.0, 0.0);
  const double crest = 190.0 + 40.0 * noise(p, 240.0);
  const double near = (beyond - crest) / 34.0;
  const double gaps = glm::smoothstep(0.1, 0.45, noise(p + 900.0, 310.0));  // passages
  const double lumps = 0.55 * noise(p, 15.0) + 0.35 * noise(p + 70.0, 9.0);
  const double reef = (1.0 - gaps) * std::exp(-near * near) * (4.6 + 1.6 * lumps);
  const double inLagoon = glm::smoothstep(60.0, 120.0, away) *
                          (1.0 - glm::smoothstep(crest - 20.0, crest + 60.0, beyond));
  const double heads = 2.4 * glm::smoothstep(0.5, 0.8, noise(p + 40.0, 21.0)) * inLagoon;
  const double deep = -30.0 * glm::smoothstep(crest + 10.0, crest + 200.0, beyond);
  const double sand = 0.05 * noise(p, 12.0) + 0.15 * noise(p, 60.0);
  const double sum = lagoon + reef + heads + deep + sand * std::min(away / 30.0, 1.0);
  // Corals do not grow out of the water.
  return away > 30.0 ? std::min(sum, -0.7 + 0.35 * lumps) : sum;
}

double height(glm::dvec2 p) {
  const double d = inland(p);
  return d > 0.0 ? ground(p, d) : bed(p, -d);
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) return std::fprintf(stderr, "usage: make_terrain FILE.png\n"), 2;
  std::vector<std::uint16_t> grey;
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) {
      const glm::dvec2 p = spacing * (glm::dvec2(column, side - 1 - row) - 0.5 * (side - 1));
      const double z = std::clamp(std::round(height(p) / step) * step, black, white);
      grey.push_back(
          static_cast<std::uint16_t>(std::lround((z - black) / (white - black) * 65535)));
    }
  }
  return writeGrey(arguments[1], side, grey);
}
