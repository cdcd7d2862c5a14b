#include "render/wake_pyramid.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "render/wake_pyramid_kernels.h"
#include "surface/disturbance/wake_sampling.h"

namespace seaway::render {
namespace {

constexpr int fewestCells = 16;

/// Half-band filter: 1/2 and these for cells ±1, ±3, ±5. Passes 97.5 % of waves of eight cells.
constexpr std::array<float, 3> halfBand{150.0f / 512, -25.0f / 512, 3.0f / 512};

/// Inverse of a cubic B-spline's values (1/6, 2/3, 1/6) at cells 0, ±1 …: √3 (√3 − 2)^|k|.
constexpr int inverseReach = 6;
std::array<float, inverseReach + 1> inverseSpline() {
  std::array<float, inverseReach + 1> taps;
  double sum = 0.0;
  for (int k = 0; k <= inverseReach; ++k) {
    const double tap = std::sqrt(3.0) * std::pow(std::sqrt(3.0) - 2.0, k);
    taps[k] = static_cast<float>(tap);
    sum += k == 0 ? tap : 2.0 * tap;
  }
  // Still water stays what it is.
  for (float& tap : taps) tap = static_cast<float>(tap / sum);
  return taps;
}

/// Cells of a row with what lies beyond its ends.
class WrappedRow {
 public:
  explicit WrappedRow(int cells) : values_(static_cast<std::size_t>(cells) + 16) {}
  float* take(const float* row, int cells) {
    for (int i = 0; i < 8; ++i) {
      values_[i] = row[cells - 8 + i];
      values_[8 + cells + i] = row[i];
    }
    std::copy_n(row, cells, values_.data() + 8);
    return values_.data() + 8;
  }

 private:
  std::vector<float> values_;
};

/// For each of `rows` rows, in parallel, with a wrapped row of `cells` to work with.
template <class Work>
void forRows(int rows, int cells, Work work) {
  tbb::parallel_for(tbb::blocked_range<int>(0, rows, 16), [&](const tbb::blocked_range<int>& some) {
    WrappedRow wrapped(cells);
    for (int j = some.begin(); j != some.end(); ++j) work(j, wrapped);
  });
}

/// Every second cell of what the half-band filter makes of rows of `cells`.
void halveRows(const std::vector<float>& from, int cells, std::vector<float>& to) {
  to.resize(static_cast<std::size_t>(cells) * cells / 2);
  forRows(cells, cells, [&](int j, WrappedRow& wrapped) {
    const float* const in = wrapped.take(&from[static_cast<std::size_t>(j) * cells], cells);
    float* const out = &to[static_cast<std::size_t>(j) * cells / 2];
    for (int i = 0; i < cells / 2; ++i) {
      const float* const at = in + 2 * i;
      out[i] = 0.5f * at[0] + halfBand[0] * (at[-1] + at[1]) + halfBand[1] * (at[-3] + at[3]) +
               halfBand[2] * (at[-5] + at[5]);
    }
  });
}

/// Sums of the rows at `offsets` either side of `centre` (periodic), with weights.
template <std::size_t count>
void addRows(const std::vector<float>& from, int width, int rows, int centre, float own,
             const std::array<int, count>& offsets, const std::array<float, count>& weights,
             float* out) {
  const auto row = [&](int j) {
    return &from[static_cast<std::size_t>((j + rows) % rows) * width];
  };
  const float* const middle = row(centre);
  for (int i = 0; i < width; ++i) out[i] = own * middle[i];
  for (std::size_t k = 0; k < count; ++k) {
    const float *const a = row(centre - offsets[k]), *const b = row(centre + offsets[k]);
    const float weight = weights[k];
    for (int i = 0; i < width; ++i) out[i] += weight * (a[i] + b[i]);
  }
}

void halveColumns(const std::vector<float>& from, int width, int rows, std::vector<float>& to) {
  to.resize(static_cast<std::size_t>(width) * rows / 2);
  forRows(rows / 2, 0, [&](int j, WrappedRow&) {
    addRows(from, width, rows, 2 * j, 0.5f, std::array{1, 3, 5}, halfBand,
            &to[static_cast<std::size_t>(j) * width]);
  });
}

/// Repeats rows and columns at a level's rim.
void wrap(WakePyramid::Level& level) {
  const int n = level.cells;
  for (int j = 0; j < n; ++j) {
    float* const row = level.row(j);
    row[-1] = row[n - 1];
    row[n] = row[0];
    row[n + 1] = row[1];
  }
  const std::size_t width = static_cast<std::size_t>(n) + 3;
  std::copy_n(level.row(n - 1) - 1, width, level.row(-1) - 1);
  std::copy_n(level.row(0) - 1, width, level.row(n) - 1);
  std::copy_n(level.row(1) - 1, width, level.row(n + 1) - 1);
}

void shape(WakePyramid::Level& level, int cells) {
  level.cells = cells;
  level.stride = static_cast<std::size_t>(cells) + 8;
  level.spline.resize(level.stride * (static_cast<std::size_t>(cells) + 3));
}

/// Coefficients of the spline through values.
void splineThrough(const std::vector<float>& values, WakePyramid::Level& level,
                   std::vector<float>& scratch) {
  static const auto taps = inverseSpline();
  const int n = level.cells;
  scratch.resize(values.size());
  forRows(n, n, [&](int j, WrappedRow& wrapped) {
    const float* const in = wrapped.take(&values[static_cast<std::size_t>(j) * n], n);
    float* const out = &scratch[static_cast<std::size_t>(j) * n];
    for (int i = 0; i < n; ++i) {
      float sum = taps[0] * in[i];
      for (int k = 1; k <= inverseReach; ++k) sum += taps[k] * (in[i - k] + in[i + k]);
      out[i] = sum;
    }
  });
  std::array<float, inverseReach> aside;
  std::copy_n(taps.begin() + 1, inverseReach, aside.begin());
  forRows(n, 0, [&](int j, WrappedRow&) {
    addRows(scratch, n, n, j, taps[0], std::array{1, 2, 3, 4, 5, 6}, aside, level.row(j));
  });
  wrap(level);
}

/// Values of a spline at its cells.
void valuesOf(const WakePyramid::Level& level, std::vector<float>& values) {
  const int n = level.cells;
  values.resize(static_cast<std::size_t>(n) * n);
  forRows(n, 0, [&](int j, WrappedRow&) {
    const float *const a = level.row(j - 1), *const b = level.row(j), *const c = level.row(j + 1);
    const auto column = [&](int i) { return a[i] + 4.0f * b[i] + c[i]; };
    for (int i = 0; i < n; ++i) {
      values[static_cast<std::size_t>(j) * n + i] =
          (column(i - 1) + 4.0f * column(i) + column(i + 1)) * (1.0f / 36.0f);
    }
  });
}

/// Mean-square slope of a level by blocks of the window; `steepest` is the largest slope found.
std::vector<float> slopeOf(const WakePyramid::Level& level, double cell, double& steepest) {
  constexpr int blocks = WakePyramid::blocks;
  const int n = level.cells, across = std::max(1, n / blocks);
  const auto scale = static_cast<float>(1.0 / (12.0 * cell));
  std::vector<float> squares(static_cast<std::size_t>(blocks) * blocks), most(blocks);
  tbb::parallel_for(0, blocks, [&](int by) {
    for (int bx = 0; bx < blocks; ++bx) {
      const int first = bx * n / blocks, low = by * n / blocks;
      float sum = 0.0f;
      for (int j = low; j < low + across; ++j) {
        const float *const a = level.row(j - 1), *const b = level.row(j),
                           *const c = level.row(j + 1);
        for (int i = first; i < first + across; ++i) {
          const float x =
              (a[i + 1] - a[i - 1]) + 4.0f * (b[i + 1] - b[i - 1]) + (c[i + 1] - c[i - 1]);
          const float y = (c[i - 1] - a[i - 1]) + 4.0f * (c[i] - a[i]) + (c[i + 1] - a[i + 1]);
          sum += x * x + y * y;
          most[by] = std::max(most[by], x * x + y * y);
        }
      }
      squares[static_cast<std::size_t>(by) * blocks + bx] =
          sum * scale * scale / static_cast<float>(across * across);
    }
  });
  steepest = scale * std::sqrt(*std::max_element(most.begin(), most.end()));
  return squares;
}

}  // namespace

void WakePyramid::takeTime(const WakeSheet& sheet, double t) {
  wake::SheetSampling weights{};
  wake::setTime(weights, sheet.start, sheet.end, std::clamp(t, sheet.start, sheet.end));
  const WakeGrid &before = *sheet.before, &after = *sheet.after;
  Level& level = levels_.front();
  shape(level, before.cells);
  forRows(level.cells, 0, [&](int j, WrappedRow&) {
    const std::size_t first = 2 * ((static_cast<std::size_t>(j) + 1) * before.stride + 1);
    const float *const a = &before.surface[first], *const b = &after.surface[first];
    float* const out = level.row(j);
    for (int i = 0; i < level.cells; ++i) {
      out[i] = weights.heightBefore[0] * a[2 * i] + weights.heightBefore[1] * a[2 * i + 1] +
               weights.heightAfter[0] * b[2 * i] + weights.heightAfter[1] * b[2 * i + 1];
    }
  });
  wrap(level);
}

void WakePyramid::fill(const WakeSheet& sheet, double t) {
  cellSize_ = sheet.cellSize;
  centre_ = sheet.centre;
  int count = 1;
  for (int cells = sheet.before->cells; cells > fewestCells; cells /= 2) ++count;
  levels_.resize(static_cast<std::size_t>(count) + 1);
  takeTime(sheet, t);
  valuesOf(levels_[0], values_);
  std::vector<float> whole = slopeOf(levels_[0], cellSize_, steepest_);
  steepest_ *= 1.5;
  levels_[0].missing.assign(whole.size(), 0.0f);
  for (int l = 1; l < count; ++l) {
    const int cells = levels_[l - 1].cells;
    halveRows(values_, cells, scratch_);
    halveColumns(scratch_, cells / 2, cells, values_);
    shape(levels_[l], cells / 2);
    splineThrough(values_, levels_[l], scratch_);
    double ignored = 0.0;
    levels_[l].missing = slopeOf(levels_[l], std::ldexp(cellSize_, l), ignored);
    for (std::size_t i = 0; i < whole.size(); ++i) {
      levels_[l].missing[i] = std::max(whole[i] - levels_[l].missing[i], 0.0f);
    }
  }
  levels_.back().cells = 0;
  levels_.back().missing = std::move(whole);
}

float WakePyramid::levelFor(double spacing) const {
  const double level = std::log2(std::max(spacing / cellSize_, 1.0));
  return static_cast<float>(std::min(level, static_cast<double>(levels_.size() - 1)));
}

void WakePyramid::addTo(std::span<const double> x, std::span<const double> y, float level,
                        const Arrays& out) const {
  const int finer = std::min(static_cast<int>(level), static_cast<int>(levels_.size()) - 1);
  const float share = level - static_cast<float>(finer);
  const WakeSums sums{out.height.data(), out.slopeX.data(), out.slopeY.data(),
                      out.missing.empty() ? nullptr : out.missing.data()};
  const auto add = [&](int number, float part) {
    const Level& from = levels_[number];
    addWakeLevel({from.spline.data(), from.stride, from.cells,
                  number > 0 ? from.missing.data() : nullptr, blocks, centre_.x, centre_.y, size()},
                 part, x, y, sums);
  };
  add(finer, 1.0f - share);
  if (share > 0.0f) add(finer + 1, share);
}

std::size_t WakePyramid::memoryBytes() const {
  std::size_t floats = values_.capacity() + scratch_.capacity();
  for (const Level& level : levels_) floats += level.spline.capacity() + level.missing.capacity();
  return floats * sizeof(float);
}

}  // namespace seaway::render
