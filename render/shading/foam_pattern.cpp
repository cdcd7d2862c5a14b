#include "render/shading/foam_pattern.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "surface/field/lattice_hash.h"

namespace seaway::render {
namespace {

constexpr LatticeSeeds seeds{0x0F0A3u, 0x51DE5u};

std::uint32_t wrapped(int cell, int cells) {
  return static_cast<std::uint32_t>((cell % cells + cells) % cells);
}

std::uint32_t cellHash(int i, int j, int cells, std::uint32_t which) {
  return cornerHash(wrapped(i, cells), wrapped(j, cells), {seeds.x + which, seeds.y});
}

double unit(std::uint32_t bits) { return static_cast<double>(bits & 0xFFFFu) / 65536.0; }

/// Smooth lattice noise of `cells` cells across the tile, [0, 1].
double valueNoise(double u, double v, int cells, std::uint32_t which) {
  const double x = u * cells, y = v * cells;
  const int i = static_cast<int>(std::floor(x)), j = static_cast<int>(std::floor(y));
  const auto fade = [](double f) { return f * f * f * (f * (f * 6.0 - 15.0) + 10.0); };
  const double fx = fade(x - i), fy = fade(y - j);
  const auto corner = [&](int di, int dj) { return unit(cellHash(i + di, j + dj, cells, which)); };
  const double low = corner(0, 0) + fx * (corner(1, 0) - corner(0, 0));
  const double high = corner(0, 1) + fx * (corner(1, 1) - corner(0, 1));
  return low + fy * (high - low);
}

/// 1 on the borders of random cells, falling towards their middles.
double borders(double u, double v, int cells, std::uint32_t which) {
  const double x = u * cells, y = v * cells;
  const int i = static_cast<int>(std::floor(x)), j = static_cast<int>(std::floor(y));
  double nearest = 9.0, second = 9.0;
  for (int dj = -2; dj <= 2; ++dj) {
    for (int di = -2; di <= 2; ++di) {
      const std::uint32_t hash = cellHash(i + di, j + dj, cells, which);
      const double offX = i + di + unit(hash) - x, offY = j + dj + unit(hash >> 16) - y;
      const double distance = std::sqrt(offX * offX + offY * offY);
      second = std::min(second, std::max(distance, nearest));
      nearest = std::min(nearest, distance);
    }
  }
  return 1.0 - (second - nearest);
}

}  // namespace

std::vector<float> foamPattern(int side) {
  std::vector<double> raw;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      double u = (x + 0.5) / side, v = (y + 0.5) / side;
      const double warpU = valueNoise(u, v, 6, 1) - 0.5, warpV = valueNoise(u, v, 6, 2) - 0.5;
      u += 0.10 * warpU, v += 0.10 * warpV;
      raw.push_back(0.9 * borders(u, v, 7, 3) + 0.6 * borders(u, v, 17, 4) +
                    1.0 * valueNoise(u, v, 4, 5) + 0.35 * valueNoise(u, v, 40, 6));
    }
  }
  // By rank: every number as frequent as any other.
  std::vector<std::size_t> order(raw.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return raw[a] < raw[b]; });
  std::vector<float> pattern(raw.size());
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    pattern[order[rank]] =
        static_cast<float>((static_cast<double>(rank) + 0.5) / static_cast<double>(order.size()));
  }
  return pattern;
}

}  // namespace seaway::render
