#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <memory>
#include <span>
#include <vector>

#include "surface/surface_sample.h"

namespace seaway {

/// Something that bobs in the water at one place and sends out ripples.
struct RippleSource {
  glm::dvec2 place{0.0};    ///< m, sea plane; carried along by the current
  double time = 0.0;        ///< when it starts, s since the scene's epoch
  double duration = 10.0;   ///< s, [0, 3600]
  double height = 0.05;     ///< of its motion, m, [0, 5]
  double period = 0.8;      ///< of its motion, s, [0.2, 60]
  double wavelength = 1.0;  ///< of the ripples, m, [0.1, 100]
  double side = 20.0;       ///< of the square of water that ripples, m: 2…25 wavelengths
  /// Ripples left alone fall to e^(−lingering · decay) in this time, s.
  static constexpr double lingering = 10.0, decay = 0.5;

  double end() const { return time + duration + lingering; }
};

/// A pool's water between two of its steps. Immutable; const calls are thread-safe and allocate
/// nothing.
class RippleSheet {
 public:
  RippleSheet(const RippleSource& source, glm::dvec2 current, int cells, std::vector<float> before,
              std::vector<float> after, double start, double end);

  /// Adds heights, slopes and ∂η/∂t: cubic B-splines in space, linear in time; at times before and
  /// after the two steps the nearer one's, and still water outside the source's life. Ripples have
  /// no orbital velocity but the vertical one.
  void addTo(std::span<const glm::dvec2> points, double t, std::span<SurfaceSample> out,
             const SampleOptions& options) const noexcept;

  /// As arrays; see SurfaceEvents::addSplashes.
  struct Arrays {
    std::span<float> height, slopeX, slopeY, rate;
  };
  void addTo(std::span<const double> x, std::span<const double> y, double t, double kept,
             const Arrays& out) const noexcept;

  const RippleSource& source() const { return source_; }
  glm::dvec2 centre(double t) const { return source_.place + current_ * (t - source_.time); }
  double heightBound() const { return largest_; }  ///< m
  std::size_t memoryBytes() const { return (before_.size() + after_.size()) * sizeof(float); }

 private:
  struct Value {
    float height = 0.0f, slopeX = 0.0f, slopeY = 0.0f, rate = 0.0f;
  };
  bool lives(double t) const { return t > source_.time && t < source_.end(); }
  /// At `offset` m from the pool's lower corner, at `part` of the way between the two steps.
  Value at(glm::dvec2 offset, float part) const noexcept;
  float partAt(double t) const noexcept;

  RippleSource source_;
  glm::dvec2 current_;
  int cells_;
  std::vector<float> before_, after_;
  double start_, end_;
  float largest_ = 0.0f;
};

/// Kryachko's dynamic displacement (GPU Gems 2, chapter 18): a cellular automaton of the wave
/// equation on a square of water around a source, all waves of one speed, absorbed at the border.
/// Steps lie on a grid of times of its own, so that the same life gives the same bits. A copy is a
/// snapshot.
class RipplePool {
 public:
  static constexpr double step = 1.0 / 60.0;  ///< s
  static constexpr int mostCells = 256;       ///< along a side

  /// Throws InputError for a source outside the ranges stated beside it, and for ripples that
  /// outrun the cells: faster than a third of a cell a step.
  explicit RipplePool(const RippleSource& source, glm::dvec2 current = glm::dvec2(0.0));

  const RippleSource& source() const { return source_; }
  int cells() const { return cells_; }

  /// Brings the pool to the step at or before `t`, from its start where `t` is earlier than now.
  /// Nothing happens before the source starts and after its end.
  void advance(double t);

  /// The water about the time of the last `advance`; null while all is still.
  std::shared_ptr<const RippleSheet> sheet() const;

  /// ∑η² a cell, m².
  double energy() const;
  std::size_t memoryBytes() const { return (before_.size() + after_.size()) * sizeof(float); }

 private:
  void stepOnce();
  void reset();

  RippleSource source_;
  glm::dvec2 current_;
  int cells_;
  long long done_ = 0;  // steps
  std::vector<float> before_, after_;
};

}  // namespace seaway
