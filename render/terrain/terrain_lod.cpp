#include "render/terrain/terrain_lod.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <span>

#include "render/fresnel.h"
#include "surface/constants.h"
#include "surface/curvature.h"

namespace seaway::render {
namespace {

constexpr float shoreWeight = 8.0f;
constexpr int largestBlock = 256;
constexpr float curtainFoot = -20.0f;  // m
/// Radius of all that a height's triangles may be divided into, in units of their longest side:
/// steps of √2/4 of it, each time 1/√2 as long.
constexpr double reachPerSide = 1.21;

/// Walks down the halved triangles of a view.
class Walk {
 public:
  Walk(const TerrainMap& map, const TerrainLod& lod, std::span<const float> error,
       std::span<const float> top, const Camera& camera, const TerrainSelection& selection,
       std::vector<glm::vec3>& corners)
      : grid_(map.grid()),
        error_(error),
        top_(top),
        camera_(camera),
        selection_(selection),
        corners_(corners),
        forward_(camera.forward()),
        left_(camera.left()),
        up_(camera.up()),
        half_(camera.halfPicture()),
        middle_(camera.pictureMiddle()) {
    const glm::dvec2 corner = glm::abs(middle_) + half_;
    // A pixel at the picture's corner is seen at the smallest angle.
    perDistance_ = selection.tolerance * std::min(camera.pixelExtent().x, camera.pixelExtent().y) /
                   std::sqrt(1.0 + glm::dot(corner, corner));
    widest_ = std::max(grid_.spacing.x, grid_.spacing.y);
    const int block = lod.block();
    for (int y = 0; y + 1 < grid_.count.y; y += block) {
      for (int x = 0; x + 1 < grid_.count.x; x += block) square({x, y}, block);
    }
  }

 private:
  struct Range {
    double low, high;
  };

  std::size_t index(glm::ivec2 at) const {
    return static_cast<std::size_t>(at.y) * grid_.count.x + at.x;
  }
  double height(glm::ivec2 at) const { return grid_.heights[index(at)]; }
  glm::dvec2 off(glm::dvec2 at) const {
    return grid_.origin + at * grid_.spacing - glm::dvec2(camera_.position);
  }

  void square(glm::ivec2 at, int side) {
    const glm::ivec2 far = at + side, right(far.x, at.y), upper(at.x, far.y);
    const bool rises = ((at.x / side + at.y / side) & 1) == 0;
    if (rises) {
      descend(right, at, far);
      descend(upper, at, far);
    } else {
      descend(at, right, upper);
      descend(far, right, upper);
    }
  }

  /// A triangle with the right angle at `apex`.
  void descend(glm::ivec2 apex, glm::ivec2 a, glm::ivec2 b) {
    const glm::ivec2 sum = a + b, middle = sum / 2;
    const bool finest = ((sum.x | sum.y) & 1) != 0;
    const auto [low, high] = std::minmax({height(apex), height(a), height(b)});
    const double error = finest ? 0.0 : error_[index(middle)];
    const Range range{low - error, finest ? high : std::max<double>(high, top_[index(middle)])};
    if (range.high < selection_.lowest || range.low > selection_.highest) return;
    if (selection_.side == TerrainSide::mirrored && range.high <= 0.0) return;
    const double longest = glm::length(glm::dvec2(b - a)) * widest_;
    const glm::dvec2 centre = off(0.5 * glm::dvec2(sum));
    if (!mayShow(centre, 0.5 * longest, range)) return;
    if (!finest && isNeeded(centre, longest, error, top_[index(middle)])) {
      descend(middle, apex, a);
      descend(middle, b, apex);
      return;
    }
    put(apex, a, b);
  }

  bool isNeeded(glm::dvec2 centre, double longest, double error, double top) const {
    const double level = std::max(glm::length(centre) - reachPerSide * longest, 0.0);
    const double above = std::max(camera_.position.z - top, 0.0);
    // A flat triangle leaves the curved sea too.
    const double bulge = longest * longest / (8.0 * earthMeanRadius);
    return error + bulge > perDistance_ * std::hypot(level, above);
  }

  double shown(double height) const {
    if (selection_.side == TerrainSide::mirrored) return -height;
    const bool scaled = selection_.side == TerrainSide::below && height < 0.0;
    return scaled ? height / seaWaterIndex : height;
  }

  bool mayShow(glm::dvec2 centre, double radius, Range range) const {
    double low = shown(range.low), high = shown(range.high);
    if (low > high) std::swap(low, high);
    const double away = glm::length(centre);
    const double drop = seaDrop(away);
    const double slack = radius * (2.0 * away + radius) / (2.0 * earthMeanRadius);
    const double half = 0.5 * (high - low) + slack;
    const glm::dvec3 place(centre, 0.5 * (low + high) - drop - camera_.position.z);
    const double ball = std::hypot(radius, half);
    const double axial = glm::dot(place, forward_);
    if (axial < camera_.nearDistance - ball) return false;
    const auto reaches = [&](double outwards, double tangent) {
      return outwards - axial * tangent <= ball * std::sqrt(1.0 + tangent * tangent);
    };
    const double right = -glm::dot(place, left_), up = glm::dot(place, up_);
    return reaches(right, half_.x + middle_.x) && reaches(-right, half_.x - middle_.x) &&
           reaches(up, half_.y + middle_.y) && reaches(-up, half_.y - middle_.y);
  }

  void put(glm::ivec2 apex, glm::ivec2 a, glm::ivec2 b) {
    const std::array<glm::ivec2, 3> all{apex, a, b};
    for (const glm::ivec2 at : all) add(at, height(at));
    if (selection_.side == TerrainSide::mirrored) return;
    const glm::ivec2 last = grid_.count - 1;
    for (int i = 0; i < 3; ++i) {
      const glm::ivec2 p = all[i], q = all[(i + 1) % 3];
      const bool edge = (p.x == q.x && (p.x == 0 || p.x == last.x)) ||
                        (p.y == q.y && (p.y == 0 || p.y == last.y));
      if (edge && std::max(height(p), height(q)) > curtainFoot) putCurtain(p, q);
    }
  }

  void putCurtain(glm::ivec2 p, glm::ivec2 q) {
    const double footP = std::min<double>(height(p), curtainFoot);
    const double footQ = std::min<double>(height(q), curtainFoot);
    add(p, height(p));
    add(q, height(q));
    add(q, footQ);
    add(p, height(p));
    add(q, footQ);
    add(p, footP);
  }

  void add(glm::ivec2 at, double z) {
    corners_.emplace_back(glm::vec2(off(glm::dvec2(at))), static_cast<float>(shown(z)));
  }

  const TerrainMap::Grid& grid_;
  std::span<const float> error_, top_;
  const Camera& camera_;
  const TerrainSelection& selection_;
  std::vector<glm::vec3>& corners_;
  glm::dvec3 forward_, left_, up_;
  glm::dvec2 half_, middle_;
  double perDistance_ = 0.0, widest_ = 1.0;
};

/// Most that heights are off the two triangles with the longest side between middle ± half, m.
float largestError(const TerrainMap::Grid& grid, glm::ivec2 middle, glm::ivec2 half) {
  const auto height = [&](glm::ivec2 at) {
    return grid.heights[static_cast<std::size_t>(at.y) * grid.count.x + at.x];
  };
  const auto isIn = [&](glm::ivec2 at) {
    return at.x >= 0 && at.y >= 0 && at.x < grid.count.x && at.y < grid.count.y;
  };
  const glm::ivec2 across(-half.y, half.x);
  const float a = height(middle - half), b = height(middle + half), mean = 0.5f * (a + b);
  const int reach = std::max(std::abs(half.x), std::abs(half.y));
  const int squared = half.x * half.x + half.y * half.y;
  const float perSquare = 1.0f / static_cast<float>(squared);
  float worst = 0.0f;
  for (const int side : {-1, 1}) {
    const glm::ivec2 apex = middle + side * across;
    if (!isIn(apex)) continue;
    const float rise = height(apex) - mean, along = 0.5f * (b - a);
    for (int y = -reach; y <= reach; ++y) {
      for (int x = -reach; x <= reach; ++x) {
        const int u = x * half.x + y * half.y, v = side * (x * across.x + y * across.y);
        if (v < 0 || std::abs(u) + v > squared) continue;
        const float plane =
            mean + perSquare * (static_cast<float>(u) * along + static_cast<float>(v) * rise);
        worst = std::max(worst, std::abs(height(middle + glm::ivec2(x, y)) - plane));
      }
    }
  }
  return worst;
}

}  // namespace

TerrainLod::TerrainLod(const TerrainMap& map)
    : error_(map.grid().heights.size(), 0.0f), top_(map.grid().heights) {
  const glm::ivec2 cells = map.grid().count - 1;
  while (block_ < largestBlock && cells.x % (2 * block_) == 0 && cells.y % (2 * block_) == 0) {
    block_ *= 2;
  }
  std::vector<std::uint8_t> shore(error_.size(), 0);
  for (int side = 2; side <= block_; side *= 2) gatherLevel(map, side, shore);
  for (std::size_t i = 0; i < error_.size(); ++i) {
    if (shore[i]) error_[i] *= shoreWeight;
  }
}

/// Heights that halve squares of `side` cells and their edges; those of half the side are known.
void TerrainLod::gatherLevel(const TerrainMap& map, int side, std::vector<std::uint8_t>& shore) {
  const glm::ivec2 count = map.grid().count;
  const int half = side / 2;
  tbb::parallel_for(0, (count.y - 1) / half + 1, [&](int line) {
    const int y = line * half;
    for (int x = (line & 1) ? 0 : half; x < count.x; x += side) {
      const glm::ivec2 along = (line & 1) ? glm::ivec2(0, half) : glm::ivec2(half, 0);
      gather(map, {x, y}, along, half / 2, true, shore);
    }
  });
  tbb::parallel_for(0, (count.y - 1) / side, [&](int row) {
    for (int column = 0; column < (count.x - 1) / side; ++column) {
      const int turn = ((row + column) & 1) == 0 ? 1 : -1;
      gather(map, glm::ivec2(column, row) * side + half, {half, turn * half}, half, false, shore);
    }
  });
}

/// The height between two others, `half` away either way, and those that follow it.
void TerrainLod::gather(const TerrainMap& map, glm::ivec2 middle, glm::ivec2 half, int childSide,
                        bool childrenAreDiagonal, std::vector<std::uint8_t>& shore) {
  const TerrainMap::Grid& grid = map.grid();
  const auto index = [&](glm::ivec2 at) {
    return static_cast<std::size_t>(at.y) * grid.count.x + at.x;
  };
  const std::size_t here = index(middle);
  const float a = grid.heights[index(middle - half)], b = grid.heights[index(middle + half)];
  const float height = grid.heights[here];
  float follows = 0.0f;
  // The water's edge passes.
  bool isShore = std::min({a, b, height}) < 0.0f && std::max({a, b, height}) >= 0.0f;
  const glm::ivec2 first = childrenAreDiagonal ? glm::ivec2(1, 1) : glm::ivec2(1, 0);
  for (int i = 0; childSide > 0 && i < 4; ++i) {
    const glm::ivec2 turned = i & 1 ? glm::ivec2(-first.y, first.x) : first;
    const glm::ivec2 child = middle + (i & 2 ? -turned : turned) * childSide;
    if (child.x < 0 || child.y < 0 || child.x >= grid.count.x || child.y >= grid.count.y) continue;
    const std::size_t at = index(child);
    follows = std::max(follows, error_[at]);
    top_[here] = std::max(top_[here], top_[at]);
    isShore = isShore || shore[at];
  }
  error_[here] = std::max(largestError(grid, middle, half), follows);
  shore[here] = isShore;
}

void TerrainLod::select(const TerrainMap& map, const Camera& camera,
                        const TerrainSelection& selection, std::vector<glm::vec3>& corners) const {
  Walk(map, *this, error_, top_, camera, selection, corners);
}

void bendToSea(const Camera& camera, std::vector<glm::vec3>& corners) {
  for (glm::vec3& p : corners) {
    const double drop = seaDrop(glm::length(glm::dvec2(p)));
    p.z = static_cast<float>(static_cast<double>(p.z) - drop - camera.position.z);
  }
}

}  // namespace seaway::render
