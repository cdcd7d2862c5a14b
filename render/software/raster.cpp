#include "render/software/raster.h"

#include <algorithm>
#include <cmath>

#include "render/software/raster_kernels.h"

namespace seaway::render {
namespace {

/// How far outside its edges, in pixels, a triangle still draws, so that neighbours leave no gap:
/// for the sea as in raster_kernels.cpp; for objects, all in double, as little as rounding asks,
/// since what an edge draws too much may lie before the face that it ends at.
double slackOf(const ScreenTriangle& t) { return t.object == 0 ? 1.0 / 1024.0 : 1e-7; }

constexpr int padding = 32;  // floats that kernels may touch past a row

/// Planes in double, from which each row's start is worked out: exact for triangles of any size.
class LargeTriangle {
 public:
  explicit LargeTriangle(const ScreenTriangle& t) {
    const double area =
        (t.x[1] - t.x[0]) * (t.y[2] - t.y[0]) - (t.y[1] - t.y[0]) * (t.x[2] - t.x[0]);
    const double turn = area < 0.0 ? -1.0 : 1.0;
    const double slack = slackOf(t);
    for (int k = 0; k < 3; ++k) {
      const int next = (k + 1) % 3;
      across_[k] = (t.y[k] - t.y[next]) * turn;
      down_[k] = (t.x[next] - t.x[k]) * turn;
      edge_[k] = -across_[k] * t.x[k] - down_[k] * t.y[k] +
                 slack * (std::abs(across_[k]) + std::abs(down_[k]));
    }
    const double perArea = std::abs(area) > 1e-12 ? 1.0 / area : 0.0;
    const double d1 = t.inverse[1] - t.inverse[0], d2 = t.inverse[2] - t.inverse[0];
    acrossDepth_ = (d1 * (t.y[2] - t.y[0]) - d2 * (t.y[1] - t.y[0])) * perArea;
    downDepth_ = (d2 * (t.x[1] - t.x[0]) - d1 * (t.x[2] - t.x[0])) * perArea;
    depth_ = t.inverse[0] - acrossDepth_ * t.x[0] - downDepth_ * t.y[0];
    least_ = static_cast<float>(std::min({t.inverse[0], t.inverse[1], t.inverse[2]}));
    most_ = static_cast<float>(std::max({t.inverse[0], t.inverse[1], t.inverse[2]}));
  }

  /// Pixels [left, right] of row y that may be inside, from the edges; empty: left > right.
  void narrow(int y, int& left, int& right) const {
    for (int k = 0; k < 3 && left <= right; ++k) {
      const double start = edge_[k] + down_[k] * y;
      if (across_[k] > 0.0) {
        left =
            static_cast<int>(std::clamp<double>(std::ceil(-start / across_[k]), left, right + 1));
      } else if (across_[k] < 0.0) {
        right =
            static_cast<int>(std::clamp<double>(std::floor(-start / across_[k]), left - 1, right));
      } else if (start < 0.0) {
        right = left - 1;
      }
    }
  }

  /// Depth alone from pixel (x, y) on: `narrow` has seen to the edges.
  TrianglePlanes depthFrom(int x, int y) const {
    TrianglePlanes planes{};
    planes.depth = static_cast<float>(depth_ + acrossDepth_ * x + downDepth_ * y);
    planes.acrossDepth = static_cast<float>(acrossDepth_);
    planes.least = least_;
    planes.most = most_;
    return planes;
  }

 private:
  double edge_[3], across_[3], down_[3], depth_, acrossDepth_, downDepth_;
  float least_, most_;
};

}  // namespace

void Strip::clear(int firstRow, int rowCount, int pixelsAcross, bool withObjects) {
  top = firstRow;
  rows = rowCount;
  width = pixelsAcross;
  stride = (pixelsAcross + padding + 15) / 16 * 16;
  const std::size_t count = static_cast<std::size_t>(stride) * rows + padding;
  inverse.assign(count, 0.0f);
  object.assign(withObjects ? count : 0, 0u);
}

void rasterSea(const ScreenGrid& screen, Strip& strip) {
  const StripPixels pixels{strip.inverse.data(), strip.stride, strip.top, strip.rows, strip.width};
  const auto top = static_cast<float>(strip.top) - 1.0f;
  const auto bottom = static_cast<float>(strip.top + strip.rows);
  const glm::ivec2 size = screen.size();
  for (int row = 0; row + 1 < size.y; ++row) {
    for (int batch = 0; batch < screen.batchesPerRow(); ++batch) {
      const ScreenGrid::Extent& extent = screen.extent(row, batch);
      if (extent.bottom < top || extent.top > bottom || extent.top > extent.bottom) continue;
      const int first = batch * quadsPerBatch, last = std::min(first + quadsPerBatch, size.x - 1);
      const std::size_t at = static_cast<std::size_t>(row) * size.x + first;
      drawQuads(screen.x() + at, screen.y() + at, screen.inverse() + at, size.x, last - first,
                pixels);
    }
  }
  for (const ScreenTriangle& triangle : screen.clipped()) rasterTriangle(triangle, strip);
}

void rasterTriangle(const ScreenTriangle& t, Strip& strip) {
  const double slack = slackOf(t);
  // Most triangles lie above or below most strips.
  const double lowY = std::min(std::min(t.y[0], t.y[1]), t.y[2]);
  const double highY = std::max(std::max(t.y[0], t.y[1]), t.y[2]);
  if (highY + slack < strip.top || lowY - slack > strip.top + strip.rows - 1) return;
  const double lowX = std::min(std::min(t.x[0], t.x[1]), t.x[2]);
  const double highX = std::max(std::max(t.x[0], t.x[1]), t.x[2]);
  const double right = std::min<double>(strip.width - 1, std::floor(highX + slack));
  const double left = std::max(0.0, std::ceil(lowX - slack));
  const double top = std::max<double>(strip.top, std::ceil(lowY - slack));
  const double bottom = std::min<double>(strip.top + strip.rows - 1, std::floor(highY + slack));
  if (!(left <= right && top <= bottom)) return;
  const LargeTriangle planes(t);
  for (int y = static_cast<int>(top); y <= static_cast<int>(bottom); ++y) {
    int from = static_cast<int>(left), to = static_cast<int>(right);
    planes.narrow(y, from, to);
    if (from > to) continue;
    const std::size_t at = static_cast<std::size_t>(y - strip.top) * strip.stride + from;
    drawSpan(planes.depthFrom(from, y), to - from + 1, strip.inverse.data() + at,
             strip.object.empty() ? nullptr : strip.object.data() + at, t.object);
  }
}

}  // namespace seaway::render
