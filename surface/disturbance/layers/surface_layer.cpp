#include "surface/disturbance/layers/surface_layer.h"

#include <openvdb/tools/Count.h>
#include <openvdb/tree/Tree.h>

#include <algorithm>
#include <cmath>

#include "surface/input_error.h"
#include "surface/state_archive.h"

namespace seaway {
namespace {

using Leaf = openvdb::tree::LeafNode<std::uint32_t, 3>;
using Tree = openvdb::tree::Tree<openvdb::tree::RootNode<openvdb::tree::InternalNode<Leaf, 3>>>;

constexpr double ticksPerSecond = 8.0;
constexpr std::int64_t lastStamp = 0xFFFF;
constexpr int fineBits = 6;

// A tile has 8 × 8 leaves of 16 × 32 cells.
constexpr int tileBitsX = 7, tileBitsY = 8, leafBitsX = 4, leafBitsY = 5;

/// Where a cell of a tile lies in its tree: the plane folded so that it fills leaves.
openvdb::Coord folded(int i, int j) {
  return {(i >> 4) * 8 | (i & 7), (j >> 5) * 8 | (j & 7), ((i >> 3) & 1) | (((j >> 3) & 3) << 1)};
}

/// The same within a leaf.
std::size_t offsetInLeaf(std::int64_t i, std::int64_t j) {
  const auto x = static_cast<unsigned>(i & 15), y = static_cast<unsigned>(j & 31);
  return (x & 7) << 6 | (y & 7) << 3 | (x >> 3) | (y >> 3) << 1;
}

constexpr std::size_t bytesPerLeaf = Leaf::SIZE * sizeof(std::uint32_t) + sizeof(Leaf);

std::int64_t keyOf(std::int64_t tileX, std::int64_t tileY) {
  return tileX * (std::int64_t{1} << 32) + tileY;
}

std::uint32_t packed(float cover, std::int64_t stamp) {
  return static_cast<std::uint32_t>(cover * 65535.0f + 0.5f) << 16 |
         static_cast<std::uint32_t>(stamp);
}

bool near(glm::dvec2 point) {
  return std::abs(point.x) <= SurfaceLayer::farthest && std::abs(point.y) <= SurfaceLayer::farthest;
}

void check(const LayerSettings& settings) {
  if (!(settings.cellSize >= 0.01 && settings.cellSize <= 100.0)) {
    throw InputError("layer: a cell size of " + std::to_string(settings.cellSize) +
                     " m is not allowed; must be in [0.01, 100]");
  }
  const bool endless = std::isinf(settings.decayTime) && settings.decayTime > 0.0;
  if (!endless && !(settings.decayTime > 0.0 && settings.decayTime <= 86400.0)) {
    throw InputError("layer: a decay time of " + std::to_string(settings.decayTime) +
                     " s is not allowed; must be in (0, 86400] or infinite");
  }
  if (!std::isfinite(settings.drift.x) || !std::isfinite(settings.drift.y)) {
    throw InputError("layer: the drift must be finite");
  }
}

}  // namespace

struct SurfaceLayer::Tile {
  Tile(std::int64_t column, std::int64_t row) : x(column), y(row) {}
  Tile(const Tile&) = default;

  std::int64_t x, y;
  Tree tree{0u};
};

SurfaceLayer::SurfaceLayer(const LayerSettings& settings) : settings_(settings) {
  check(settings_);
}

SurfaceLayer::SurfaceLayer(const SurfaceLayer& other)
    : settings_(other.settings_),
      tiles_(other.tiles_),
      shared_(true),
      base_(other.base_),
      leaves_(other.leaves_),
      decayCoarse_(other.decayCoarse_),
      decayFine_(other.decayFine_) {
  other.shared_ = true;
}

SurfaceLayer& SurfaceLayer::operator=(const SurfaceLayer& other) {
  if (this == &other) return *this;
  settings_ = other.settings_;
  tiles_ = other.tiles_;
  base_ = other.base_;
  leaves_ = other.leaves_;
  decayCoarse_ = other.decayCoarse_;
  decayFine_ = other.decayFine_;
  shared_ = true;
  other.shared_ = true;
  return *this;
}

SurfaceLayer::~SurfaceLayer() = default;

double SurfaceLayer::ticksAt(double t) const { return (t - base_) * ticksPerSecond; }

// Ages beyond the tables have gone; what never goes grows no older than they reach.
double SurfaceLayer::latestTicks() const {
  return std::isinf(settings_.decayTime) ? static_cast<double>(lastStamp) : 1e15;
}

void SurfaceLayer::forgetSharing() {
  if (!shared_.exchange(false)) return;
  for (Entry& entry : tiles_) entry.owned = false;
}

SurfaceLayer::Tile& SurfaceLayer::tileToPaint(std::int64_t tileX, std::int64_t tileY) {
  const std::int64_t key = keyOf(tileX, tileY);
  const auto at = std::lower_bound(tiles_.begin(), tiles_.end(), key,
                                   [](const Entry& e, std::int64_t k) { return e.key < k; });
  if (at == tiles_.end() || at->key != key) {
    return *tiles_.insert(at, {key, std::make_shared<Tile>(tileX, tileY), true})->tile;
  }
  if (!at->owned) {
    at->tile = std::make_shared<Tile>(*at->tile);
    at->owned = true;
  }
  return *at->tile;
}

// Decay by ticks of age as a product of two tables: a multiple of 2^fineBits and the rest.
float SurfaceLayer::decayed(std::uint32_t cell, std::int64_t ticks, float part) const noexcept {
  const std::int64_t age = ticks - static_cast<std::int64_t>(cell & 0xFFFFu);
  const float cover = static_cast<float>(cell >> 16) * (part / 65535.0f);
  if (age < 0) return 0.0f;
  const auto coarse = static_cast<std::size_t>(age >> fineBits);
  if (coarse >= decayCoarse_.size()) return 0.0f;
  return cover * decayCoarse_[coarse] * decayFine_[static_cast<std::size_t>(age) & 63u];
}

void SurfaceLayer::rebase(double t) {
  if (tiles_.empty()) {
    base_ = std::floor(t);
    if (!decayFine_.empty()) return;
    const double perTick = 1.0 / (settings_.decayTime * ticksPerSecond);
    const double ticksToGone = perTick > 0.0 ? -std::log(0.5 * leastCover) / perTick : lastStamp;
    const auto coarse = static_cast<std::size_t>(ticksToGone / 64.0) + 1;
    for (std::size_t i = 0; i < 64; ++i) {
      decayFine_.push_back(static_cast<float>(std::exp(-perTick * static_cast<double>(i))));
    }
    for (std::size_t i = 0; i < coarse; ++i) {
      decayCoarse_.push_back(
          static_cast<float>(std::exp(-perTick * 64.0 * static_cast<double>(i))));
    }
    return;
  }
  if (ticksAt(t) < static_cast<double>(lastStamp) - 1.0) return;
  // What is older than the new base counts as left then, as much as is left.
  const double newBase = std::floor(t - 0.5 * lastStamp / ticksPerSecond);
  const auto shift = static_cast<std::int64_t>((newBase - base_) * ticksPerSecond);
  for (Entry& entry : tiles_) {
    Tile& tile = tileToPaint(entry.tile->x, entry.tile->y);
    for (auto leaf = tile.tree.beginLeaf(); leaf; ++leaf) {
      std::uint32_t* cells = leaf->buffer().data();
      for (std::size_t i = 0; i < Leaf::SIZE; ++i) {
        const std::int64_t stamp = static_cast<std::int64_t>(cells[i] & 0xFFFFu) - shift;
        if (stamp >= 0) {
          cells[i] = (cells[i] & 0xFFFF0000u) | static_cast<std::uint32_t>(stamp);
        } else {
          cells[i] = packed(decayed(cells[i], shift, 1.0f), 0);
        }
      }
    }
  }
  base_ = newBase;
}

Painted SurfaceLayer::paint(glm::dvec2 lower, glm::dvec2 upper, double t,
                            const std::function<float(glm::dvec2)>& cover) {
  const glm::dvec2 drift = settings_.drift * t;
  if (!std::isfinite(t) || !near(lower - drift) || !near(upper - drift)) return Painted::notFinite;
  const double perCell = 1.0 / settings_.cellSize;
  const auto first = [&](double x) {
    return static_cast<std::int64_t>(std::ceil(x * perCell - 0.5));
  };
  const auto last = [&](double x) {
    return static_cast<std::int64_t>(std::floor(x * perCell - 0.5));
  };
  const std::int64_t i0 = first(lower.x - drift.x), i1 = last(upper.x - drift.x);
  const std::int64_t j0 = first(lower.y - drift.y), j1 = last(upper.y - drift.y);
  if (i1 < i0 || j1 < j0) return Painted::done;
  // In double: the product may not fit.
  if (static_cast<double>(i1 - i0 + 1) * static_cast<double>(j1 - j0 + 1) > mostCellsAtOnce) {
    return Painted::tooLarge;
  }
  if (!tiles_.empty() && t < base_) return Painted::tooEarly;
  forgetSharing();
  rebase(t);
  const double ticks = ticksAt(t);
  const auto stamp = static_cast<std::int64_t>(ticks);
  for (std::int64_t tileX = i0 >> tileBitsX; tileX <= i1 >> tileBitsX; ++tileX) {
    for (std::int64_t tileY = j0 >> tileBitsY; tileY <= j1 >> tileBitsY; ++tileY) {
      Tile* tile = nullptr;  // made by the first cell that is covered
      Leaf* leaf = nullptr;
      std::int64_t leafKey = -1;
      const std::int64_t fromX = std::max(i0, tileX << tileBitsX);
      const std::int64_t toX = std::min(i1, ((tileX + 1) << tileBitsX) - 1);
      const std::int64_t fromY = std::max(j0, tileY << tileBitsY);
      const std::int64_t toY = std::min(j1, ((tileY + 1) << tileBitsY) - 1);
      for (std::int64_t i = fromX; i <= toX; ++i) {
        for (std::int64_t j = fromY; j <= toY; ++j) {
          const glm::dvec2 centre =
              glm::dvec2(static_cast<double>(i) + 0.5, static_cast<double>(j) + 0.5) *
                  settings_.cellSize +
              drift;
          const float asked = cover(centre);
          if (!(asked >= leastCover)) continue;
          if (!tile) tile = &tileToPaint(tileX, tileY);
          const int x = static_cast<int>(i - (tileX << tileBitsX));
          const int y = static_cast<int>(j - (tileY << tileBitsY));
          const std::int64_t key = (x >> leafBitsX) * 8 + (y >> leafBitsY);
          if (key != leafKey) {
            leaf = tile->tree.probeLeaf(folded(x, y));
            if (!leaf && leaves_ * bytesPerLeaf >= settings_.mostBytes) return Painted::full;
            if (!leaf) leaf = tile->tree.touchLeaf(folded(x, y)), ++leaves_;
            leafKey = key;
          }
          const auto offset = static_cast<openvdb::Index>(offsetInLeaf(i, j));
          const float wanted = std::min(asked, 1.0f);
          if (wanted >= decayed(leaf->getValue(offset), stamp, 1.0f)) {
            leaf->setValueOn(offset, packed(wanted, stamp));
          }
        }
      }
    }
  }
  return Painted::done;
}

/// Finds cells, remembering the leaf that the last one was in.
class SurfaceLayer::Reader {
 public:
  explicit Reader(const SurfaceLayer& layer) : layer_(layer) {}

  std::uint32_t cell(std::int64_t i, std::int64_t j) noexcept {
    const std::int64_t leafX = i >> leafBitsX, leafY = j >> leafBitsY;
    if (leafX != leafX_ || leafY != leafY_) find(leafX, leafY, i, j);
    return cells_ ? cells_[offsetInLeaf(i, j)] : 0u;
  }

 private:
  void find(std::int64_t leafX, std::int64_t leafY, std::int64_t i, std::int64_t j) noexcept {
    leafX_ = leafX, leafY_ = leafY;
    const std::int64_t tileX = i >> tileBitsX, tileY = j >> tileBitsY;
    const std::int64_t key = keyOf(tileX, tileY);
    if (!tile_ || key != key_) {
      const auto& tiles = layer_.tiles_;
      const auto at = std::lower_bound(tiles.begin(), tiles.end(), key,
                                       [](const Entry& e, std::int64_t k) { return e.key < k; });
      tile_ = at != tiles.end() && at->key == key ? at->tile.get() : nullptr;
      key_ = key;
    }
    cells_ = nullptr;
    if (!tile_) return;
    const Leaf* leaf = tile_->tree.probeConstLeaf(folded(
        static_cast<int>(i - (tileX << tileBitsX)), static_cast<int>(j - (tileY << tileBitsY))));
    if (leaf) cells_ = leaf->buffer().data();
  }

  const SurfaceLayer& layer_;
  const Tile* tile_ = nullptr;
  std::int64_t key_ = 0;
  std::int64_t leafX_ = std::numeric_limits<std::int64_t>::min(), leafY_ = 0;
  const std::uint32_t* cells_ = nullptr;
};

void SurfaceLayer::sample(std::span<const glm::dvec2> points, double t,
                          std::span<float> out) const noexcept {
  std::fill_n(out.begin(), points.size(), 0.0f);
  if (tiles_.empty() || !std::isfinite(t) || t < base_) return;
  const double exact = std::min(ticksAt(t), latestTicks());
  const auto ticks = static_cast<std::int64_t>(exact);
  const auto part = static_cast<float>(
      std::exp(-(exact - static_cast<double>(ticks)) / (settings_.decayTime * ticksPerSecond)));
  const double perCell = 1.0 / settings_.cellSize;
  const glm::dvec2 drift = settings_.drift * t;
  Reader reader(*this);
  for (std::size_t p = 0; p < points.size(); ++p) {
    const glm::dvec2 place = points[p] - drift;
    if (!near(place)) continue;
    const double x = place.x * perCell - 0.5, y = place.y * perCell - 0.5;
    const double left = std::floor(x), low = std::floor(y);
    const auto i = static_cast<std::int64_t>(left), j = static_cast<std::int64_t>(low);
    const auto u = static_cast<float>(x - left), v = static_cast<float>(y - low);
    const auto value = [&](std::int64_t di, std::int64_t dj) {
      const std::uint32_t cell = reader.cell(i + di, j + dj);
      return cell == 0u ? 0.0f : decayed(cell, ticks, part);
    };
    const float a = value(0, 0), b = value(0, 1), c = value(1, 0), d = value(1, 1);
    const float west = a + v * (b - a), east = c + v * (d - c);
    out[p] = west + u * (east - west);
  }
}

bool SurfaceLayer::mayCover(glm::dvec2 lower, glm::dvec2 upper, double t) const noexcept {
  if (tiles_.empty()) return false;
  const glm::dvec2 drift = settings_.drift * t;
  const double width = settings_.cellSize * (1 << tileBitsX);
  const double length = settings_.cellSize * (1 << tileBitsY);
  const double margin = settings_.cellSize;  // of the interpolation
  for (const Entry& entry : tiles_) {
    const double x = static_cast<double>(entry.tile->x) * width + drift.x;
    const double y = static_cast<double>(entry.tile->y) * length + drift.y;
    if (lower.x < x + width + margin && upper.x > x - margin && lower.y < y + length + margin &&
        upper.y > y - margin) {
      return true;
    }
  }
  return false;
}

void SurfaceLayer::prune(double t) {
  if (tiles_.empty() || !std::isfinite(t) || std::isinf(settings_.decayTime)) return;
  forgetSharing();
  const auto ticks = static_cast<std::int64_t>(std::clamp(ticksAt(t), 0.0, 1e15));
  const auto gone = [&](const Leaf& leaf) {
    const std::uint32_t* cells = leaf.buffer().data();
    return std::all_of(cells, cells + Leaf::SIZE, [&](std::uint32_t cell) {
      // What is to come stays.
      const bool later = static_cast<std::int64_t>(cell & 0xFFFFu) > ticks;
      return cell == 0u || (!later && decayed(cell, ticks, 1.0f) < leastCover);
    });
  };
  for (Entry& entry : tiles_) {
    std::vector<openvdb::Coord> old;
    for (auto leaf = entry.tile->tree.cbeginLeaf(); leaf; ++leaf) {
      if (gone(*leaf)) old.push_back(leaf->origin());
    }
    if (old.empty()) continue;
    Tile& tile = tileToPaint(entry.tile->x, entry.tile->y);
    for (const openvdb::Coord& origin : old) tile.tree.addTile(1, origin, 0u, false);
  }
  std::erase_if(tiles_, [](const Entry& entry) { return entry.tile->tree.leafCount() == 0; });
  leaves_ = 0;
  for (const Entry& entry : tiles_) leaves_ += entry.tile->tree.leafCount();
}

void SurfaceLayer::visit(double t, const std::function<void(const Cell&)>& see) const {
  if (!std::isfinite(t)) return;
  const auto ticks = static_cast<std::int64_t>(std::clamp(ticksAt(t), -1.0, latestTicks()));
  for (const Entry& entry : tiles_) {
    const std::int64_t originX = entry.tile->x << tileBitsX, originY = entry.tile->y << tileBitsY;
    for (auto leaf = entry.tile->tree.cbeginLeaf(); leaf; ++leaf) {
      const std::int64_t x = originX + leaf->origin().x() * 2, y = originY + leaf->origin().y() * 4;
      for (std::int64_t i = x; i < x + 16; ++i) {
        for (std::int64_t j = y; j < y + 32; ++j) {
          const std::uint32_t cell =
              leaf->getValue(static_cast<openvdb::Index>(offsetInLeaf(i, j)));
          const float cover = cell == 0u ? 0.0f : decayed(cell, ticks, 1.0f);
          if (cover < leastCover) continue;
          const std::int64_t age = ticks - static_cast<std::int64_t>(cell & 0xFFFFu);
          see({i, j, cover, static_cast<float>(age) / static_cast<float>(ticksPerSecond)});
        }
      }
    }
  }
}

std::size_t SurfaceLayer::cellCount() const {
  std::size_t cells = 0;
  for (const Entry& entry : tiles_) cells += entry.tile->tree.activeVoxelCount();
  return cells;
}

std::size_t SurfaceLayer::nodeCount() const {
  std::size_t nodes = 0;
  for (const Entry& entry : tiles_) {
    nodes += entry.tile->tree.leafCount() + entry.tile->tree.nonLeafCount();
  }
  return nodes;
}

std::size_t SurfaceLayer::memoryBytes() const {
  std::size_t bytes = (decayCoarse_.capacity() + decayFine_.capacity()) * sizeof(float) +
                      tiles_.capacity() * sizeof(Entry);
  for (const Entry& entry : tiles_) bytes += sizeof(Tile) + entry.tile->tree.memUsage();
  return bytes;
}

template <class Archive>
void SurfaceLayer::archiveTile(Archive& archive, Tile& tile) {
  std::vector<openvdb::Coord> origins;
  for (auto leaf = tile.tree.cbeginLeaf(); leaf; ++leaf) origins.push_back(leaf->origin());
  archiveRow(archive, origins, 64);
  for (const openvdb::Coord& origin : origins) {
    Leaf& leaf = *tile.tree.touchLeaf(origin);
    std::vector<std::uint32_t> cells(Leaf::SIZE);
    std::vector<std::uint8_t> covered(Leaf::SIZE);
    for (openvdb::Index i = 0; i < Leaf::SIZE; ++i) {
      cells[i] = leaf.getValue(i);
      covered[i] = leaf.isValueOn(i);
    }
    archiveRow(archive, cells, Leaf::SIZE);
    archiveRow(archive, covered, Leaf::SIZE);
    if constexpr (isReader<Archive>) {
      cells.resize(Leaf::SIZE);
      covered.resize(Leaf::SIZE);
      for (openvdb::Index i = 0; i < Leaf::SIZE; ++i) {
        covered[i] ? leaf.setValueOn(i, cells[i]) : leaf.setValueOff(i, cells[i]);
      }
    }
  }
}

template <class Archive>
void SurfaceLayer::archive(Archive& archive) {
  std::uint64_t count = tiles_.size();
  archivePlain(archive, count);
  if constexpr (isReader<Archive>) tiles_.clear();
  for (std::uint64_t i = 0; i < count; ++i) {
    std::int64_t x = 0, y = 0;
    if constexpr (!isReader<Archive>) x = tiles_[i].tile->x, y = tiles_[i].tile->y;
    archivePlain(archive, x);
    archivePlain(archive, y);
    if constexpr (isReader<Archive>) {
      tiles_.push_back({keyOf(x, y), std::make_shared<Tile>(x, y), true});
    }
    archiveTile(archive, *tiles_[i].tile);
  }
  archivePlain(archive, base_);
  archivePlain(archive, leaves_);
  archiveRow(archive, decayCoarse_);
  archiveRow(archive, decayFine_);
}

template void SurfaceLayer::archive(StateWriter&);
template void SurfaceLayer::archive(StateReader&);

}  // namespace seaway
