#include "render/visible_shadow.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "surface/curvature.h"

namespace seaway::render {
namespace {

using Interval = VisibleShadow::Interval;

constexpr double endless = std::numeric_limits<double>::infinity();
constexpr Interval nothing{endless, -endless};

bool isEmpty(Interval interval) { return !(interval.least <= interval.most); }

Interval joined(Interval a, Interval b) {
  return {std::min(a.least, b.least), std::max(a.most, b.most)};
}

}  // namespace

VisibleShadow::VisibleShadow(const Camera& camera, double heightBound, glm::dvec2 azimuth,
                             double reach)
    : eyeHeight_(camera.position.z), bound_(heightBound), reach_(reach) {
  const auto turned = [&](glm::dvec3 v) {
    return glm::dvec3(glm::dot(glm::dvec2(v), azimuth),
                      glm::dot(glm::dvec2(v), glm::dvec2(azimuth.y, -azimuth.x)), v.z);
  };
  const glm::dvec3 forward = turned(camera.forward()), middle = turned(camera.middleRay());
  const glm::dvec3 right = turned(camera.rightHalf()), up = turned(camera.upperHalf());
  const glm::dvec2 off = camera.pictureMiddle() / camera.halfPicture();
  planes_[0] = {forward, camera.nearDistance};
  // A ray middle + x·right + y·up is inside for x and y in [-1, 1].
  for (int side = 0; side < 2; ++side) {
    const double sign = side ? 1.0 : -1.0;
    planes_[1 + side] = {forward * (1.0 - sign * off.x) + right * (sign / glm::dot(right, right)),
                         0.0};
    planes_[3 + side] = {forward * (1.0 - sign * off.y) + up * (sign / glm::dot(up, up)), 0.0};
  }
  constexpr double x[] = {-1.0, 1.0, 1.0, -1.0}, y[] = {-1.0, -1.0, 1.0, 1.0};
  for (int i = 0; i < 4; ++i) {
    const int next = (i + 1) % 4;
    const glm::dvec3 ray = middle + right * x[i] + up * y[i];
    const glm::dvec3 beside = middle + right * x[next] + up * y[next];
    edges_[i] = {ray * camera.nearDistance, ray, endless};
    edges_[4 + i] = {ray * camera.nearDistance, (beside - ray) * camera.nearDistance, 1.0};
  }
}

/// Inside the frustum on a line at one height above the eye.
Interval VisibleShadow::level(double along, double height) const {
  Interval result{-endless, endless};
  for (const Plane& plane : planes_) {
    const double lacking = plane.offset - plane.normal.x * along - plane.normal.z * height;
    const double across = plane.normal.y;
    if (across > 1e-12) {
      result.least = std::max(result.least, lacking / across);
    } else if (across < -1e-12) {
      result.most = std::min(result.most, lacking / across);
    } else if (lacking > 0.0) {
      return nothing;
    }
  }
  return isEmpty(result) ? nothing : result;
}

/// A piece cut by the upright plane of a line: the corners of that convex polygon lie on the
/// heights or on the frustum's edges.
Interval VisibleShadow::cut(double along, const Piece& piece) const {
  Interval result = joined(level(along, piece.bottom), level(along, piece.top));
  for (const Edge& edge : edges_) {
    const double part = (along - edge.start.x) / edge.direction.x;
    if (!(part >= 0.0 && part <= edge.length)) continue;
    const double height = edge.start.z + part * edge.direction.z;
    if (!(height >= piece.bottom && height <= piece.top)) continue;
    const double across = edge.start.y + part * edge.direction.y;
    result = joined(result, {across, across});
  }
  return result;
}

/// A piece's corners that do not lie on its lines: ends of the frustum's edges, and where these
/// meet the heights.
template <typename Use>
void VisibleShadow::forCornersOf(const Piece& piece, Use use) const {
  const auto offer = [&](glm::dvec3 p) {
    if (p.x > piece.near && p.x < piece.far) use(p.x, p.y);
  };
  for (const Edge& edge : edges_) {
    if (edge.start.z >= piece.bottom && edge.start.z <= piece.top) offer(edge.start);
    for (const double height : {piece.bottom, piece.top}) {
      const double part = (height - edge.start.z) / edge.direction.z;
      if (part >= 0.0 && part <= edge.length) offer(edge.start + part * edge.direction);
    }
  }
}

std::optional<VisibleShadow::Strip> VisibleShadow::coverPiece(const Piece& piece) const {
  Strip strip{cut(piece.near, piece), cut(piece.far, piece)};
  const bool whole = !isEmpty(strip.near) && !isEmpty(strip.far);
  if (!whole) {
    // The shadow begins or ends within: a box.
    Interval box = joined(strip.near, strip.far);
    forCornersOf(piece, [&](double, double across) { box = joined(box, {across, across}); });
    if (isEmpty(box)) return std::nullopt;
    return Strip{box, box};
  }
  // Corners beyond the straight sides push them outwards.
  Interval push{0.0, 0.0};
  forCornersOf(piece, [&](double along, double across) {
    const double share = (along - piece.near) / (piece.far - piece.near);
    push.least = std::min(push.least, across - glm::mix(strip.near.least, strip.far.least, share));
    push.most = std::max(push.most, across - glm::mix(strip.near.most, strip.far.most, share));
  });
  for (Interval* line : {&strip.near, &strip.far}) {
    line->least += push.least;
    line->most += push.most;
  }
  return strip;
}

std::optional<VisibleShadow::Strip> VisibleShadow::cover(double near, double far) const {
  const double nearest = near > 0.0 ? near : far < 0.0 ? -far : 0.0;
  const double farthest = std::max(std::abs(near), std::abs(far));
  const double limit = std::sqrt(std::max(reach_ * reach_ - nearest * nearest, 0.0));
  Piece piece{near, far, 0.0, bound_ - seaDrop(nearest) - eyeHeight_};
  std::optional<Strip> strip;
  double radius = std::hypot(farthest, limit);
  // Within what was found the sea drops less than at the reach: what is found next is narrower and
  // still covers all.
  for (int i = 0; i < 4; ++i) {
    piece.bottom = -bound_ - seaDrop(radius) - eyeHeight_;
    strip = coverPiece(piece);
    if (!strip) return std::nullopt;
    const Interval both = joined(strip->near, strip->far);
    const double widest = std::max(std::abs(both.least), std::abs(both.most));
    const double nearer = std::hypot(farthest, std::min(widest, limit));
    const double saved = seaDrop(radius) - seaDrop(nearer);
    radius = nearer;
    if (saved < 1e-3 * (std::abs(eyeHeight_) + bound_)) break;
  }
  // Beyond the reach nothing counts; a side that leaves it within the strip is let out to it.
  if (std::min(strip->near.least, strip->far.least) < -limit) {
    strip->near.least = strip->far.least = -limit;
  }
  if (std::max(strip->near.most, strip->far.most) > limit) {
    strip->near.most = strip->far.most = limit;
  }
  for (Interval* line : {&strip->near, &strip->far}) {
    line->least = std::min(line->least, limit);
    line->most = std::max(line->most, -limit);
  }
  return strip;
}

}  // namespace seaway::render
