// Writes configs/terrain/crater_lake.png, the map of heights of configs/scenes/crater_lake.yaml:
// made-up walls about the lake of an outline, and its bed.
//
//   g++ -std=c++20 -O2 tests/support/make_crater.cpp -lpng -o /tmp/make_crater
//   /tmp/make_crater configs/outlines/crater_lake.geojson configs/terrain/crater_lake.png
//
// Even in longitude and latitude over 0.15 by 0.11 degrees about the scene's anchor. Grey 0 is 80 m
// below the lake, 65535 is 420 m above it.
#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "terrain_noise.h"

namespace {

constexpr int side = 401;  // heights
constexpr double black = -80.0, white = 420.0;
constexpr double step = 0.5;                                            // m
constexpr glm::dvec2 middle(-122.11, 42.94), halfExtent(0.075, 0.055);  // degrees
constexpr glm::dvec2 metres(81500.0, 111100.0);                         // a degree, there

using Ring = std::vector<glm::dvec2>;  // m from the middle

std::vector<Ring> ringsOf(const char* file) {
  std::ifstream stream(file);
  std::vector<Ring> rings;
  const nlohmann::json outline = nlohmann::json::parse(stream);
  for (const auto& ring : outline["geometry"]["coordinates"]) {
    Ring& corners = rings.emplace_back();
    for (const auto& at : ring) {
      corners.push_back((glm::dvec2(at[0].get<double>(), at[1].get<double>()) - middle) * metres);
    }
  }
  return rings;
}

/// Distance from a ring, m; negative outside.
double within(const Ring& ring, glm::dvec2 p) {
  double nearest = 1e9;
  bool inside = false;
  for (std::size_t i = 0; i + 1 < ring.size(); ++i) {
    const glm::dvec2 a = ring[i], along = ring[i + 1] - a;
    const double part = glm::clamp(glm::dot(p - a, along) / glm::dot(along, along), 0.0, 1.0);
    nearest = std::min(nearest, glm::length(p - a - part * along));
    if ((a.y > p.y) != (ring[i + 1].y > p.y) && p.x < a.x + along.x * (p.y - a.y) / along.y) {
      inside = !inside;
    }
  }
  return inside ? nearest : -nearest;
}

/// Walls of the crater, by the distance from the lake, m: a strand, cliffs and screes up to the
/// rim, and from there down to the map's edge.
double wall(glm::dvec2 p, double away) {
  const double rim = 260.0 + 90.0 * noise(p, 2100.0);
  const double foot = 150.0 + 60.0 * noise(p, 700.0);
  const double rise = glm::smoothstep(foot, foot + 620.0, away);
  const double cut = ridges(p, 420.0) - 0.55;
  const double outwards = std::max(std::abs(p.x) / 6100.0, std::abs(p.y) / 6100.0);
  const double ends = 1.0 - glm::smoothstep(0.8, 0.99, outwards);
  const double strand = 0.035 * std::min(away, 150.0);
  return strand + ends * rise * (rim + 150.0 * cut + 14.0 * noise(p, 90.0));
}

double island(glm::dvec2 p, double in) {
  return 0.06 * std::min(in, 60.0) +
         190.0 * glm::smoothstep(30.0, 420.0, in) * (0.4 + 0.6 * ridges(p, 300.0));
}

double height(const std::vector<Ring>& rings, glm::dvec2 p) {
  const double in = within(rings[0], p);
  if (in <= 0.0) return wall(p, -in);
  double shore = in;
  for (std::size_t i = 1; i < rings.size(); ++i) {
    const double ashore = within(rings[i], p);
    if (ashore > 0.0) return island(p, ashore);
    shore = std::min(shore, -ashore);
  }
  return -0.05 * std::min(shore, 90.0) - 0.45 * std::max(shore - 90.0, 0.0);
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 3) return std::fprintf(stderr, "usage: make_crater OUTLINE.geojson FILE.png\n"), 2;
  const std::vector<Ring> rings = ringsOf(arguments[1]);
  std::vector<std::uint16_t> grey;
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) {
      const glm::dvec2 part = glm::dvec2(column, side - 1 - row) * (2.0 / (side - 1)) - 1.0;
      const double z = height(rings, part * halfExtent * metres);
      const double held = std::clamp(std::round(z / step) * step, black, white);
      grey.push_back(
          static_cast<std::uint16_t>(std::lround((held - black) / (white - black) * 65535)));
    }
  }
  return writeGrey(arguments[2], side, grey);
}
