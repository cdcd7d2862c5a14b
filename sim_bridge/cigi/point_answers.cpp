#include "sim_bridge/cigi/point_answers.h"

#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <limits>

#include "surface/angles.h"

namespace seaway::bridge::cigi {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr std::uint8_t clampAltitude = 1;
constexpr std::uint8_t clampAttitudeToo = 2;

glm::dvec3 upwardNormal(const WaterHeight& water) {
  return glm::normalize(glm::dvec3(-water.slopeEast, -water.slopeNorth, 1.0));
}

/// A clamped entity set on the water: its altitude becomes one above mean sea level, and its
/// attitude, where that is clamped too, one relative to the surface's normal.
std::optional<EntityPlace> setOnWater(EntityPlace place, const FrameMoment& moment, Water& water) {
  WaterHeight surface;
  water.heights(moment.time, std::span(&place.place, 1), std::span(&surface, 1));
  if (!surface.valid) return {};
  place.altitude += moment.waterLevel + surface.elevation;
  if (place.clamp == clampAttitudeToo) {
    const glm::dquat tilt(glm::dvec3(0, 0, 1), upwardNormal(surface));
    place.enuFromBody = glm::mat3_cast(tilt) * place.enuFromBody;
  }
  return place;
}

/// Entities are mostly asked about many times in a row: the last one is kept.
class EntityFinder {
 public:
  EntityFinder(const Entities& entities, const FrameMoment& moment, Water& water)
      : entities_(entities), moment_(moment), water_(water) {}

  const std::optional<EntityPlace>& find(std::uint16_t entity) {
    if (known_ && entity == entity_) return place_;
    entity_ = entity;
    known_ = true;
    place_ = entities_.place(entity);
    const bool clamped =
        place_ && (place_->clamp == clampAltitude || place_->clamp == clampAttitudeToo);
    if (clamped) place_ = setOnWater(*place_, moment_, water_);
    return place_;
  }

 private:
  const Entities& entities_;
  const FrameMoment& moment_;
  Water& water_;
  bool known_ = false;
  std::uint16_t entity_ = 0;
  std::optional<EntityPlace> place_;
};

/// NaN, which no water serves, where there is no such entity.
WaterPoint pointOf(const PointRequest& request, EntityFinder& finder, std::uint32_t host,
                   double& altitude) {
  altitude = request.z;
  if (!request.entityAxes) return {request.x, request.y};
  const std::optional<EntityPlace>& entity = finder.find(request.entity);
  if (!entity) return {nan, nan};
  const glm::dvec3 offset = entity->enuFromBody * glm::dvec3(request.x, request.y, request.z);
  WaterPoint point = entity->place;
  point.east += offset.x;
  point.north += offset.y;
  point.host = host;
  altitude = entity->altitude + offset.z;
  return point;
}

Packet heightAnswer(const PointRequest& request, bool valid, double above, double of,
                    std::uint8_t frame) {
  const bool ofTerrain = request.question == PointQuestion::ofTerrain;
  return HatHotResponse{request.request, valid, ofTerrain, frame, ofTerrain ? of : above};
}

Packet extendedAnswer(const PointRequest& request, const WaterHeight& water, bool valid,
                      double above, double of, std::uint8_t frame) {
  HatHotExtendedResponse answer{request.request, valid, frame, above, of};
  if (!valid) return answer;
  const glm::dvec3 normal = upwardNormal(water);
  answer.material = waterMaterial;
  answer.normalAzimuth = static_cast<float>(degreesFromRadians(std::atan2(normal.x, normal.y)));
  answer.normalElevation = static_cast<float>(degreesFromRadians(std::asin(normal.z)));
  return answer;
}

std::uint8_t lowBits(std::uint32_t frame) { return static_cast<std::uint8_t>(frame & 0xF); }

}  // namespace

void PointAnswers::locate(std::span<const PointRequest> requests, const Entities& entities,
                          const FrameMoment& moment, Water& water) {
  heightsAsked_.clear();
  velocitiesAsked_.clear();
  heightPoints_.clear();
  velocityPoints_.clear();
  EntityFinder finder(entities, moment, water);
  for (const PointRequest& request : requests) {
    double altitude = 0.0;
    WaterPoint point = pointOf(request, finder, moment.host, altitude);
    const bool velocity = request.question == PointQuestion::velocity;
    if (velocity) point.height = altitude - moment.waterLevel;
    (velocity ? velocityPoints_ : heightPoints_).push_back(point);
    (velocity ? velocitiesAsked_ : heightsAsked_).push_back({request, altitude});
  }
}

void PointAnswers::answerHeights(const FrameMoment& moment, MessageWriter& out,
                                 Counts& counts) const {
  const std::uint8_t frame = lowBits(moment.hostFrame);
  for (std::size_t i = 0; i < heights_.size(); ++i) {
    const PointRequest& request = heightsAsked_[i].request;
    const WaterHeight& water = heights_[i];
    const bool height = request.question == PointQuestion::ofTerrain;
    const bool valid = water.valid && (height || std::isfinite(heightsAsked_[i].altitude));
    if (!valid) counts.add(Count::invalidPoints);
    const double of = valid ? moment.waterLevel + water.elevation : 0.0;
    const double above = valid ? heightsAsked_[i].altitude - of : 0.0;
    out.add(request.question == PointQuestion::extended
                ? extendedAnswer(request, water, valid, above, of, frame)
                : heightAnswer(request, valid, above, of, frame));
  }
}

void PointAnswers::answerVelocities(const FrameMoment& moment, MessageWriter& out,
                                    Counts& counts) const {
  for (std::size_t i = 0; i < velocities_.size(); ++i) {
    const WaterVelocity& water = velocities_[i];
    WaterVelocityResponse answer{velocitiesAsked_[i].request.request, water.valid,
                                 lowBits(moment.hostFrame)};
    if (water.valid) {
      answer.heightOf = moment.waterLevel + water.elevation;
      answer.east = static_cast<float>(water.velocity.x);
      answer.north = static_cast<float>(water.velocity.y);
      answer.up = static_cast<float>(water.velocity.z);
    } else {
      counts.add(Count::invalidPoints);
    }
    out.add(answer);
  }
}

void PointAnswers::answer(std::span<const PointRequest> requests, const Entities& entities,
                          const FrameMoment& moment, Water& water, MessageWriter& out,
                          Counts& counts) {
  locate(requests, entities, moment, water);
  heights_.resize(heightPoints_.size());
  velocities_.resize(velocityPoints_.size());
  if (!heightPoints_.empty()) water.heights(moment.time, heightPoints_, heights_);
  if (!velocityPoints_.empty()) water.velocities(moment.time, velocityPoints_, velocities_);
  counts.add(Count::heights, heights_.size());
  counts.add(Count::velocities, velocities_.size());
  answerHeights(moment, out, counts);
  answerVelocities(moment, out, counts);
}

}  // namespace seaway::bridge::cigi
