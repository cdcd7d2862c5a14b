#include "sim_bridge/vessel/prescribed_vessel.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/camera.h"
#include "surface/constants.h"
#include "surface/state_archive.h"

namespace seaway::bridge {
namespace {

constexpr double subStepPhase = 0.1;  // rad of the fastest natural oscillation

}  // namespace

PrescribedVessel::PrescribedVessel(const BoxHull& hull, const Course& course)
    : hull_(hull), course_(course), columns_(hullColumns(hull)) {
  for (const HullColumn& column : columns_) {
    secondMomentAlong_ += column.area * column.place.x * column.place.x;
    secondMomentAcross_ += column.area * column.place.y * column.place.y;
  }
  waterBefore_.resize(columns_.size());
  waterAfter_.resize(columns_.size());
  submergedVolume_ = hull_.mass() / seaWaterDensity;
}

VesselPose PrescribedVessel::pose() const {
  const CoursePoint course = course_.at(time_);
  return {course.position, course.direction, heave_.value, pitch_.value, roll_.value};
}

void PrescribedVessel::displace(double heave, double roll, double pitch) {
  heave_.value += heave;
  roll_.value += roll;
  pitch_.value += pitch;
}

void PrescribedVessel::samplePoints(double t, std::span<glm::dvec2> out) const {
  const CoursePoint course = course_.at(t);
  const glm::dquat worldFromBody = render::attitude(course.direction, pitch_.value, roll_.value);
  out[0] = course.position;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const glm::dvec3 arm = worldFromBody * glm::dvec3(columns_[i].place, 0.0);
    out[i + 1] = course.position + glm::dvec2(arm);
  }
}

void PrescribedVessel::takeWater(std::span<const SurfaceSample> water) {
  waterBefore_.swap(waterAfter_);
  waterHeight_ = water[0].height;
  std::copy(water.begin() + 1, water.end(), waterAfter_.begin());
}

void PrescribedVessel::settle(double t, std::span<const SurfaceSample> water) {
  time_ = t;
  takeWater(water);
  waterBefore_ = waterAfter_;
  double mean = 0.0;
  double tiltAlong = 0.0;
  double tiltAcross = 0.0;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const HullColumn& column = columns_[i];
    mean += column.area * waterAfter_[i].height / hull_.waterplaneArea();
    tiltAlong += column.area * column.place.x * waterAfter_[i].height / secondMomentAlong_;
    tiltAcross += column.area * column.place.y * waterAfter_[i].height / secondMomentAcross_;
  }
  heave_.value = mean;
  pitch_.value = std::atan(tiltAlong);
  roll_.value = std::atan(tiltAcross);
  const CoursePoint course = course_.at(t);
  const Flow carried = flow(course, 1.0);
  heave_.rate = carried.heave;
  pitch_.rate = carried.pitch;
  roll_.rate = carried.roll;
  submergedVolume_ = buoyancy(course.direction, 1.0).volume;
}

// Buoyancy of every column: ρg A ℓ (−∇η, 1) at the middle of its wet length ℓ, moments about the
// centre of gravity. Either end of a column may be the lower one, so a capsized box floats too.
PrescribedVessel::Loads PrescribedVessel::buoyancy(double direction, double part) const {
  const glm::dquat worldFromBody = render::attitude(direction, pitch_.value, roll_.value);
  const glm::dvec3 rollAxis = worldFromBody * glm::dvec3(1.0, 0.0, 0.0);
  const glm::dvec3 pitchAxis(std::sin(direction), -std::cos(direction), 0.0);  // to starboard
  const glm::dvec3 up = worldFromBody * glm::dvec3(0.0, 0.0, 1.0);
  const double rise = std::max(std::abs(up.z), 1e-3);  // height of a column per metre of it
  const double keel = -hull_.draft();
  const double lowEnd = up.z >= 0.0 ? keel : keel + hull_.depth;
  const double inward = up.z >= 0.0 ? 1.0 : -1.0;
  const double centreOfGravity = keel + hull_.centreOfGravityAboveKeel;
  Loads loads;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const HullColumn& column = columns_[i];
    const glm::dvec3 low = worldFromBody * glm::dvec3(column.place, lowEnd);
    const double height = glm::mix(waterBefore_[i].height, waterAfter_[i].height, part);
    const glm::dvec2 slope = glm::mix(waterBefore_[i].slope, waterAfter_[i].slope, part);
    const double under = height - (heave_.value + low.z);
    const double wet = std::clamp(under / rise, 0.0, hull_.depth);
    const double volume = column.area * wet;
    const glm::dvec3 arm =
        worldFromBody * glm::dvec3(column.place, lowEnd + 0.5 * inward * wet - centreOfGravity);
    const glm::dvec3 force = seaWaterDensity * standardGravity * volume * glm::dvec3(-slope, 1.0);
    const glm::dvec3 moment = glm::cross(arm, force);
    loads.volume += volume;
    loads.force += force.z;
    loads.roll += glm::dot(moment, rollAxis);
    loads.pitch += glm::dot(moment, pitchAxis);
  }
  return loads;
}

// The rates at which the hull would move with the water. A hull that goes ahead while its bow
// points up rises without any flow along its own vertical axis: hence the term with the velocity.
PrescribedVessel::Flow PrescribedVessel::flow(const CoursePoint& course, double part) const {
  Flow result;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const HullColumn& column = columns_[i];
    const double rise =
        glm::mix(waterBefore_[i].verticalVelocity, waterAfter_[i].verticalVelocity, part);
    result.heave += column.area * rise / hull_.waterplaneArea();
    result.pitch += column.area * column.place.x * rise / secondMomentAlong_;
    result.roll += column.area * column.place.y * rise / secondMomentAcross_;
  }
  const glm::dvec3 up =
      render::attitude(course.direction, pitch_.value, roll_.value) * glm::dvec3(0.0, 0.0, 1.0);
  result.heave -= glm::dot(course.velocity - current_, glm::dvec2(up));
  return result;
}

void PrescribedVessel::subStep(double t, double dt, double part) {
  const CoursePoint course = course_.at(t);
  const Loads loads = buoyancy(course.direction, part);
  const Flow water = flow(course, part);
  const double mass = hull_.mass();
  const double wetPart = std::min(1.0, loads.volume * seaWaterDensity / mass);
  const auto integrate = [&](Motion& motion, double acceleration, double frequency,
                             double dampingRatio, double waterRate) {
    const double damping = 2.0 * dampingRatio * frequency * wetPart;
    motion.rate = (motion.rate + dt * (acceleration + damping * waterRate)) / (1.0 + dt * damping);
    motion.value += dt * motion.rate;
  };
  const double rollInertia = mass * hull_.rollGyradius() * hull_.rollGyradius();
  const double pitchInertia = mass * hull_.pitchGyradius() * hull_.pitchGyradius();
  integrate(heave_, loads.force / mass - standardGravity, hull_.heaveFrequency(),
            hull_.heaveDamping, water.heave);
  integrate(roll_, loads.roll / rollInertia, hull_.rollFrequency(), hull_.rollDamping, water.roll);
  integrate(pitch_, loads.pitch / pitchInertia, hull_.pitchFrequency(), hull_.pitchDamping,
            water.pitch);
}

void PrescribedVessel::advance(double t, std::span<const SurfaceSample> water) {
  takeWater(water);
  const double fastest =
      std::max({hull_.heaveFrequency(), hull_.rollFrequency(), hull_.pitchFrequency()});
  const double span = t - time_;
  const int count = std::max(1, static_cast<int>(std::ceil(span * fastest / subStepPhase)));
  for (int i = 1; i <= count; ++i) {
    const double part = static_cast<double>(i) / count;
    subStep(time_ + part * span, span / count, part);
  }
  time_ = t;
  submergedVolume_ = buoyancy(course_.at(t).direction, 1.0).volume;
}

void PrescribedVessel::advanceUpright(double t, std::span<const SurfaceSample> water) {
  takeWater(water);
  time_ = t;
  heave_ = roll_ = pitch_ = {};
  submergedVolume_ = buoyancy(course_.at(t).direction, 1.0).volume;
}

template <class Archive>
void PrescribedVessel::archive(Archive& archive) {
  archivePlain(archive, time_);
  for (Motion* motion : {&heave_, &roll_, &pitch_}) archivePlain(archive, *motion);
  archiveRow(archive, waterBefore_);
  archiveRow(archive, waterAfter_);
  archivePlain(archive, waterHeight_);
  archivePlain(archive, submergedVolume_);
}

template void PrescribedVessel::archive(StateWriter&);
template void PrescribedVessel::archive(StateReader&);

}  // namespace seaway::bridge
