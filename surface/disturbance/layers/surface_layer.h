#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <limits>
#include <memory>
#include <span>
#include <vector>

namespace seaway {

struct LayerSettings {
  double cellSize = 0.25;  ///< m, [0.01, 100]
  /// Cover falls to 1/e in this time, s, (0, 86400]; infinite: it stays.
  double decayTime = std::numeric_limits<double>::infinity();
  /// How the layer is carried over the sea plane, m/s (east, north): the current, and for oil a
  /// part of the wind.
  glm::dvec2 drift{0.0};
  std::size_t mostBytes = std::size_t{256} << 20;  ///< more is not painted
};

/// What became of a stroke.
enum class Painted {
  done,
  notFinite,  ///< NaN or infinite place or time, or farther than SurfaceLayer::farthest
  tooEarly,   ///< before what the layer still remembers
  tooLarge,   ///< more than SurfaceLayer::mostCellsAtOnce
  full,       ///< LayerSettings::mostBytes is reached
};

/// What floats on the sea for long: foam, smoothed water, oil. A sparse raster of cover in [0, 1]
/// with the time it was left, cell (i, j) centred at (i + ½, j + ½) · cellSize in the drifting
/// water's frame.
///
/// OpenVDB trees in a folded layout: a leaf of 8³ voxels holds 16 × 32 cells of the plane, so that
/// none is wasted on height. Trees cover tiles of 128 × 256 cells which copies share until one of
/// them paints: a copy is a snapshot, at the price of a pointer a tile. Cover decays as it is
/// read. Four bytes a cell, some 20 % more in all where cells lie close
/// (tests/surface/disturbance/layers). Without paint nothing is allocated.
///
/// Const calls are thread-safe, on a snapshot while another is painted on.
class SurfaceLayer {
 public:
  /// Throws InputError for a setting outside the range stated beside it.
  explicit SurfaceLayer(const LayerSettings& settings = {});
  SurfaceLayer(const SurfaceLayer& other);
  SurfaceLayer& operator=(const SurfaceLayer& other);
  ~SurfaceLayer();

  static constexpr double farthest = 1e8;  ///< m, along each axis
  static constexpr std::size_t mostCellsAtOnce = 1u << 24;
  /// Cover below this counts as none: it is not seen and is pruned.
  static constexpr float leastCover = 1.0f / 512.0f;

  const LayerSettings& settings() const { return settings_; }
  bool empty() const { return tiles_.empty(); }

  /// Covers cells with centres between `lower` and `upper` (m, sea plane) at time `t` (s) where
  /// `cover(centre)` is more than is left there; it is asked once a cell and held to [0, 1], NaN
  /// leaves the cell alone.
  Painted paint(glm::dvec2 lower, glm::dvec2 upper, double t,
                const std::function<float(glm::dvec2)>& cover);

  /// Cover at `points` and time `t` into `out`, bilinear between cells' centres; 0 where a point or
  /// the time is not finite, and before the cover was left. Steps of 1/65535 in cover and 1/8 s in
  /// age. No allocation.
  void sample(std::span<const glm::dvec2> points, double t, std::span<float> out) const noexcept;
  float coverAt(glm::dvec2 point, double t) const noexcept {
    float cover = 0.0f;
    sample(std::span(&point, 1), t, std::span(&cover, 1));
    return cover;
  }
  /// Whether anything may cover a box of the sea plane at time `t`: false is certain.
  bool mayCover(glm::dvec2 lower, glm::dvec2 upper, double t) const noexcept;

  /// Lets go of what has decayed below `leastCover` by time `t`.
  void prune(double t);

  struct Cell {
    std::int64_t i, j;
    float cover;  ///< at the time asked for
    float age;    ///< s since it was left; 2¼ hours at most
  };
  /// Every covered cell at time `t`, in an order that depends on the cells alone.
  void visit(double t, const std::function<void(const Cell&)>& see) const;

  std::size_t cellCount() const;  ///< that hold cover, decayed or not
  std::size_t nodeCount() const;  ///< of all OpenVDB trees
  std::size_t memoryBytes() const;

  /// Writes or reads the state: see surface/state_archive.h.
  template <class Archive>
  void archive(Archive& archive);

 private:
  struct Tile;
  struct Entry {
    std::int64_t key;
    std::shared_ptr<Tile> tile;
    bool owned;  // by nobody else: may be painted on
  };
  class Reader;
  template <class Archive>
  static void archiveTile(Archive& archive, Tile& tile);

  Tile& tileToPaint(std::int64_t tileX, std::int64_t tileY);
  void rebase(double t);
  double ticksAt(double t) const;
  double latestTicks() const;
  void forgetSharing();
  float decayed(std::uint32_t cell, std::int64_t ticks, float part) const noexcept;

  LayerSettings settings_;
  std::vector<Entry> tiles_;                    // by key
  mutable std::atomic<bool> shared_{false};     // a copy was made since the last stroke
  double base_ = 0.0;                           // s: stamps count from here
  std::size_t leaves_ = 0;                      // of all tiles
  std::vector<float> decayCoarse_, decayFine_;  // e^(−age/decayTime)
};

/// What of a sea's surface is covered, as readers hold it: null layers hold nothing.
struct SurfaceCover {
  std::shared_ptr<const SurfaceLayer> foam;    ///< white water
  std::shared_ptr<const SurfaceLayer> smooth;  ///< short waves damped, as behind a hull
  std::shared_ptr<const SurfaceLayer> oil;     ///< short waves damped, and another colour

  bool empty() const { return !foam && !smooth && !oil; }
};

}  // namespace seaway
