#include "render/projector.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "render/row_fit.h"
#include "render/visible_volume.h"
#include "surface/constants.h"

namespace seaway::render {
namespace {

/// Method 2 looks this many projector heights ahead. Not critical: over six views of moderate and
/// storm seas vertex efficiency was 0.47–0.83 with 3, 0.44–0.80 with 8, 0.41–0.80 with 20.
constexpr double aheadInHeights = 3.0;
/// Points may lie this near to the plane through the projector across its axis: cotangent of the
/// widest angle off axis. A camera of 170° and 16:9 sees to 0.044 itself.
constexpr double leastCotangent = 0.04;

/// Unit vector through the picture's middle.
glm::dvec3 viewDirection(const Camera& camera) {
  return camera.intrinsics ? glm::normalize(camera.middleRay()) : camera.forward();
}

/// Where the projector's axis points horizontally. The camera's view direction serves until it
/// looks nearly straight up or down; then the top of its picture does.
glm::dvec2 azimuthOf(const Camera& camera) {
  const glm::dvec3 forward = viewDirection(camera), up = camera.up();
  const glm::dvec2 ahead(forward), top = glm::dvec2(up) * (forward.z > 0.0 ? -1.0 : 1.0);
  return glm::normalize(glm::length(ahead) > 0.1 ? ahead : top);
}

/// Depression of the axis by methods 1 and 2, blended by |f·N|. The view direction is mirrored in
/// the plane where it looks away from it.
double depressionOf(const Camera& camera, double height) {
  const double down = std::min(std::abs(viewDirection(camera).z), 1.0);
  const double level = std::sqrt(1.0 - down * down);
  const double ahead = level * aheadInHeights * height;                     // method 2
  const double hit = std::min(level / std::max(down, 1e-9), 1e3) * height;  // method 1
  return std::atan2(height, glm::mix(ahead, hit, down));
}

}  // namespace

std::optional<Projector> Projector::aimedAt(const Camera& camera, double heightBound,
                                            const ProjectorOptions& options) {
  const std::optional<VisibleVolume> volume = visibleVolume(camera, heightBound);
  if (!volume) return std::nullopt;
  Projector projector;
  const double height = std::max(std::abs(camera.position.z), heightBound + options.elevation);
  projector.position_ = {0.0, 0.0, height};
  projector.azimuth_ = azimuthOf(camera);
  projector.depression_ = depressionOf(camera, height);
  projector.reach_ = volume->reach;
  projector.rowEnds_ = options.rowEnds;
  projector.shadow_ = VisibleShadow(camera, volume->bound, projector.azimuth_, volume->reach);
  projector.logarithmicRows_ = options.logarithmicRows * std::cos(projector.depression_);
  projector.rowScale_ = std::max(std::abs(camera.position.z), 0.5);
  std::vector<glm::dvec2> basePoints;
  for (const glm::dvec3& corner : volume->corners) {
    basePoints.push_back(projector.withinReach(glm::dvec2(corner)));
  }
  projector.standBack(basePoints);
  projector.fitRange(basePoints);
  return projector;
}

/// The box ahead that holds all within reach: the corners of a wide view's far plane lie beyond.
glm::dvec2 Projector::withinReach(glm::dvec2 point) const {
  const glm::dvec2 right(azimuth_.y, -azimuth_.x);
  return azimuth_ * std::clamp(glm::dot(point, azimuth_), -reach_, reach_) +
         right * std::clamp(glm::dot(point, right), -reach_, reach_);
}

/// Moves the projector backwards until all points are well in front of it. Needed where it was
/// raised far above a camera that sees sideways or behind its own foot.
void Projector::standBack(const std::vector<glm::dvec2>& basePoints) {
  const double lead = 0.9 * position_.z * std::tan(std::min(depression_, 0.4999 * pi));
  double back = 0.0;
  for (const glm::dvec2 point : basePoints) {
    const double along = glm::dot(point, azimuth_);
    const double across = std::abs(glm::dot(point, glm::dvec2(azimuth_.y, -azimuth_.x)));
    back = std::max(back, leastCotangent * across - along - lead);
  }
  position_ -= glm::dvec3(azimuth_ * back, 0.0);
}

glm::dvec2 Projector::projectorFromBase(glm::dvec2 point) const {
  const glm::dvec2 offset = point - glm::dvec2(position_);
  const double along = glm::dot(offset, azimuth_);
  const double across = glm::dot(offset, glm::dvec2(azimuth_.y, -azimuth_.x));
  const double c = std::cos(depression_), s = std::sin(depression_);
  const double axial = along * c + position_.z * s;
  return {across / axial, (along * s - position_.z * c) / axial};
}

glm::dvec3 Projector::rayThrough(glm::dvec2 p) const {
  const double c = std::cos(depression_), s = std::sin(depression_);
  const glm::dvec2 across(azimuth_.y, -azimuth_.x);
  return {azimuth_ * (c + p.y * s) + across * p.x, p.y * c - s};
}

void Projector::fitRange(const std::vector<glm::dvec2>& basePoints) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  range_ = {glm::dvec2(infinity), glm::dvec2(-infinity)};
  for (const glm::dvec2 point : basePoints) {
    const glm::dvec2 p = projectorFromBase(point);
    range_.least = glm::min(range_.least, p);
    range_.most = glm::max(range_.most, p);
  }
  // A hair more than the picture, so that rounding leaves no gap at its edges; never as far as the
  // projector's own horizon, where the plane is at infinity.
  const glm::dvec2 margin = 1e-4 * (range_.most - range_.least) + glm::dvec2(1e-9);
  range_.least -= margin;
  range_.most += margin;
  const double horizon = std::tan(std::min(depression_, 0.4999 * pi));
  const double farthest = range_.most.y - margin.y;
  range_.most.y = std::min(range_.most.y, farthest + 0.01 * (horizon - farthest));

  // A ray from the projector meets z = 0 at position + ray·height/−ray.z. As homogeneous
  // coordinates that is linear in the projector-space point, so corners are enough.
  for (int i = 0; i < 4; ++i) {
    const glm::dvec3 ray = rayThrough(
        {i & 1 ? range_.most.x : range_.least.x, i & 2 ? range_.most.y : range_.least.y});
    corners_[i] = {glm::dvec2(position_) * -ray.z + glm::dvec2(ray) * position_.z, -ray.z};
  }
}

glm::dvec2 Projector::basePoint(double u, double v) const {
  const glm::dvec3 point =
      glm::mix(glm::mix(corners_[0], corners_[1], u), glm::mix(corners_[2], corners_[3], u), v);
  return glm::dvec2(point) / point.z - origin_;
}

double Projector::along(double v) const {
  const double c = std::cos(depression_), s = std::sin(depression_);
  const double y = glm::mix(range_.least.y, range_.most.y, v);
  return position_.z * (c + y * s) / (s - y * c);
}

double Projector::logarithm(double v) const {
  return std::asinh((along(v) - glm::length(glm::dvec2(position_))) / rowScale_);
}

std::vector<double> Projector::rows(int count) const {
  const double c = std::cos(depression_), s = std::sin(depression_);
  const double back = glm::length(glm::dvec2(position_));
  const double first = logarithm(0.0), last = logarithm(1.0);
  const double perRange = 1.0 / (range_.most.y - range_.least.y);
  struct Place {
    double v, rate;  // by level
  };
  const auto placeAt = [&](double level) {  // v where the logarithm is `level`
    const double grown = std::exp(level), shrunk = 1.0 / grown;
    const double distance = back + rowScale_ * 0.5 * (grown - shrunk);
    const double axial = distance * c + position_.z * s;
    const double y = (distance * s - position_.z * c) / axial;
    return Place{(y - range_.least.y) * perRange,
                 rowScale_ * 0.5 * (grown + shrunk) * position_.z / (axial * axial) * perRange};
  };
  std::vector<double> result(count);
  double level = first;
  for (int i = 1; i + 1 < count; ++i) {
    const double wanted = static_cast<double>(i) / (count - 1);
    result[i] = wanted;
    if (!(last > first)) continue;
    // The share of rows nearer than a level grows with it: Newton's method from the row before,
    // halving where a step leaves what is left.
    double low = level, high = last;
    for (int step = 0; step < 60; ++step) {
      const Place place = placeAt(level);
      const double excess =
          glm::mix(place.v, (level - first) / (last - first), logarithmicRows_) - wanted;
      (excess < 0.0 ? low : high) = level;
      const double newton =
          level - excess / glm::mix(place.rate, 1.0 / (last - first), logarithmicRows_);
      const double next = newton > low && newton < high ? newton : 0.5 * (low + high);
      const double moved = std::abs(next - level);
      level = next;
      if (moved < 1e-8 * (1.0 + std::abs(level))) break;  // its square is left
    }
    result[i] = std::clamp(placeAt(level).v, 0.0, 1.0);
  }
  result.front() = 0.0;
  result.back() = 1.0;
  return result;
}

std::vector<Projector::Line> Projector::lines(int count) const {
  const std::vector<double> v = rows(count);
  std::vector<Line> result(v.size());
  if (rowEnds_ == RowEnds::rectangle) {
    for (std::size_t i = 0; i < v.size(); ++i)
      result[i] = {basePoint(0.0, v[i]), basePoint(1.0, v[i])};
    return result;
  }
  const double back = glm::length(glm::dvec2(position_));
  std::vector<double> ahead(v.size()), sight(v.size());
  for (std::size_t i = 0; i < v.size(); ++i) {
    const double distance = along(v[i]);
    ahead[i] = distance - back;
    sight[i] = std::hypot(distance, position_.z);
  }
  const std::vector<VisibleShadow::Interval> ends = fittedRows(shadow_, ahead, sight);
  const glm::dvec2 right(azimuth_.y, -azimuth_.x);
  for (std::size_t i = 0; i < v.size(); ++i) {
    const glm::dvec2 middle = azimuth_ * ahead[i] - origin_;
    result[i] = {middle + right * ends[i].least, middle + right * ends[i].most};
  }
  return result;
}

Projector::GridFromPlane Projector::gridFromPlane() const {
  const double c = std::cos(depression_), s = std::sin(depression_);
  const double first = logarithm(0.0), last = logarithm(1.0);
  GridFromPlane g;
  g.foot = glm::dvec2(position_) - origin_;
  g.azimuth = glm::dvec2(azimuth_);
  g.cosine = c;
  g.sine = s;
  g.heightSine = (position_.z * s);
  g.heightCosine = (position_.z * c);
  g.leastY = range_.least.y;
  g.perY = 1.0 / (range_.most.y - range_.least.y);
  g.back = glm::length(glm::dvec2(position_));
  g.perScale = 1.0 / rowScale_;
  g.first = first;
  g.perLog = last > first ? 1.0 / (last - first) : 0.0;
  g.logarithmic = last > first ? (logarithmicRows_) : 0.0;
  return g;
}

}  // namespace seaway::render
