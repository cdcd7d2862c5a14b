#include "render/software/object_edges.h"

#include <algorithm>
#include <cmath>

namespace seaway::render {
namespace {

constexpr int samples = ObjectEdges::samples;

/// Places of the samples from the pixel's centre. No two lie in one eighth of the pixel's rows or
/// columns: a bar of an eighth of a pixel along either is seen.
constexpr float acrossOffset[samples] = {0.0625f,  -0.0625f, 0.3125f, -0.1875f,
                                         -0.3125f, -0.4375f, 0.1875f, 0.4375f};
constexpr float downOffset[samples] = {-0.1875f, 0.1875f,  0.0625f, -0.3125f,
                                       0.3125f,  -0.0625f, 0.4375f, -0.4375f};

/// How far outside its edges, in pixels, a triangle still covers: neighbours leave no gap by the
/// rounding of their common edge.
constexpr double slack = 1e-3;
constexpr int readPastEnd = 16;  // elements, by those who shade

/// Columns [from, to] of a row in which each sample is inside.
struct Inside {
  int from[samples], to[samples];
};

}  // namespace

/// Edges and depth of a triangle in pixels from a corner of the strip.
class ObjectEdges::Planes {
 public:
  Planes(const ScreenTriangle& t, double left, double top) {
    const double area =
        (t.x[1] - t.x[0]) * (t.y[2] - t.y[0]) - (t.y[1] - t.y[0]) * (t.x[2] - t.x[0]);
    const double turn = area < 0.0 ? -1.0 : 1.0;
    for (int k = 0; k < 3; ++k) {
      const int next = (k + 1) % 3;
      const double across = (t.y[k] - t.y[next]) * turn, down = (t.x[next] - t.x[k]) * turn;
      across_[k] = static_cast<float>(across);
      down_[k] = static_cast<float>(down);
      edge_[k] = static_cast<float>(-across * (t.x[k] - left) - down * (t.y[k] - top) +
                                    slack * (std::abs(across) + std::abs(down)));
    }
    const double perArea = std::abs(area) > 1e-12 ? 1.0 / area : 0.0;
    const double d1 = t.inverse[1] - t.inverse[0], d2 = t.inverse[2] - t.inverse[0];
    const double across = (d1 * (t.y[2] - t.y[0]) - d2 * (t.y[1] - t.y[0])) * perArea;
    const double down = (d2 * (t.x[1] - t.x[0]) - d1 * (t.x[2] - t.x[0])) * perArea;
    acrossDepth_ = static_cast<float>(across);
    downDepth_ = static_cast<float>(down);
    depth_ = static_cast<float>(t.inverse[0] - across * (t.x[0] - left) - down * (t.y[0] - top));
    least_ = static_cast<float>(std::min({t.inverse[0], t.inverse[1], t.inverse[2]}));
    most_ = static_cast<float>(std::max({t.inverse[0], t.inverse[1], t.inverse[2]}));
  }

  /// Within columns [0, last].
  Inside inside(float row, int last) const {
    float from[samples], to[samples];
    std::fill_n(from, samples, 0.0f);
    std::fill_n(to, samples, static_cast<float>(last));
    for (int k = 0; k < 3; ++k) {
      float start[samples];
      for (int s = 0; s < samples; ++s) {
        start[s] = edge_[k] + across_[k] * acrossOffset[s] + down_[k] * (row + downOffset[s]);
      }
      if (across_[k] > 0.0f) {
        const float perAcross = -1.0f / across_[k];
        for (int s = 0; s < samples; ++s) from[s] = std::max(from[s], start[s] * perAcross);
      } else if (across_[k] < 0.0f) {
        const float perAcross = -1.0f / across_[k];
        for (int s = 0; s < samples; ++s) to[s] = std::min(to[s], start[s] * perAcross);
      } else {
        for (int s = 0; s < samples; ++s) to[s] = start[s] < 0.0f ? -1.0f : to[s];
      }
    }
    Inside result;
    for (int s = 0; s < samples; ++s) {
      const float first = std::min(from[s], static_cast<float>(last) + 1.0f);
      const int whole = static_cast<int>(first);
      result.from[s] = whole + (static_cast<float>(whole) < first);
      const float end = std::max(to[s], -1.0f);
      const int down = static_cast<int>(end);
      result.to[s] = down - (static_cast<float>(down) > end);
    }
    return result;
  }
  struct Line {
    float start, step;
  };
  /// Depth along a row, right inside the triangle.
  Line depthAlong(float row) const { return {depth_ + downDepth_ * row, acrossDepth_}; }
  float depthAt(float column, float row) const {
    return std::clamp(depth_ + acrossDepth_ * column + downDepth_ * row, least_, most_);
  }

 private:
  float edge_[3], across_[3], down_[3], depth_, acrossDepth_, downDepth_, least_, most_;
};

namespace {

std::uint8_t samplesAt(const Inside& inside, int column) {
  unsigned bits = 0;
  for (int s = 0; s < samples; ++s) {
    bits |= static_cast<unsigned>(column >= inside.from[s] && column <= inside.to[s]) << s;
  }
  return static_cast<std::uint8_t>(bits);
}

}  // namespace

void ObjectEdges::fill(const ObjectTriangles& objects, const Strip& sea) {
  const PixelBox box = objects.boxIn(sea);
  left_ = box.least.x;
  right_ = box.end.x;
  top_ = sea.top;
  rows_ = sea.rows;
  stride_ = right_ - left_;
  if (stride_ == 0) return;
  const std::size_t count = static_cast<std::size_t>(stride_) * rows_ + readPastEnd;
  sea_.assign(count, 0.0f);
  inverse_.assign(count, 0.0f);
  covering_.assign(count, 0);
  object_.assign(count, 0);
  for (int line = 0; line < rows_; ++line) {
    std::copy_n(sea.inverse.data() + static_cast<std::size_t>(line) * sea.stride + left_, stride_,
                sea_.data() + static_cast<std::size_t>(line) * stride_);
  }
  for (const ScreenTriangle& triangle : objects.triangles()) cover(triangle);
}

void ObjectEdges::cover(const ScreenTriangle& t) {
  const auto [high, low] = std::minmax({t.y[0], t.y[1], t.y[2]});
  const double first = std::max(0.0, std::ceil(high - 0.5) - top_);
  const double last = std::min(rows_ - 1.0, std::floor(low + 0.5) - top_);
  if (!(first <= last)) return;
  const Planes planes(t, left_, top_);
  for (int line = static_cast<int>(first); line <= static_cast<int>(last); ++line) {
    coverRow(planes, line, t.object);
  }
}

void ObjectEdges::coverRow(const Planes& planes, int line, std::uint32_t object) {
  const auto row = static_cast<float>(line);
  const Inside inside = planes.inside(row, stride_ - 1);
  int from = inside.from[0], wholeFrom = from, to = inside.to[0], wholeTo = to;
  for (int s = 1; s < samples; ++s) {
    from = std::min(from, inside.from[s]);
    wholeFrom = std::max(wholeFrom, inside.from[s]);
    to = std::max(to, inside.to[s]);
    wholeTo = std::min(wholeTo, inside.to[s]);
  }
  wholeFrom = std::clamp(wholeFrom, from, to + 1);
  wholeTo = std::clamp(wholeTo, wholeFrom - 1, to);
  const std::size_t at = static_cast<std::size_t>(line) * stride_;
  const auto coverPart = [&](int first, int last) {
    for (int column = first; column <= last; ++column) {
      const std::size_t i = at + column;
      const float inverse = planes.depthAt(static_cast<float>(column), row);
      const std::uint8_t covering = samplesAt(inside, column);
      if (covering == 0 || inverse <= sea_[i]) continue;
      covering_[i] |= covering;
      if (inverse <= inverse_[i]) continue;
      inverse_[i] = inverse;
      object_[i] = object;
    }
  };
  coverPart(from, wholeFrom - 1);
  // Here nobody will ask which object it is.
  const Planes::Line depth = planes.depthAlong(row);
  for (int column = wholeFrom; column <= wholeTo; ++column) {
    const float inverse = depth.start + depth.step * static_cast<float>(column);
    covering_[at + column] |= inverse > sea_[at + column] ? 0xFF : 0;
  }
  coverPart(wholeTo + 1, to);
}

ObjectEdges::Row ObjectEdges::row(int line) const {
  const std::size_t at = static_cast<std::size_t>(line) * stride_;
  return {&sea_[at], &covering_[at], &object_[at], &inverse_[at]};
}

std::size_t ObjectEdges::memoryBytes() const {
  return (sea_.capacity() + inverse_.capacity()) * sizeof(float) + covering_.capacity() +
         object_.capacity() * sizeof(std::uint32_t);
}

}  // namespace seaway::render
