#include "sim_bridge/service/served_sea.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <utility>

#include "sim_bridge/vessel/prescribed_vessel.h"
#include "surface/angles.h"
#include "surface/input_error.h"

namespace seaway::bridge {

ServedSea::ServedSea(const Scene& scene, Sea sea) : geodesy_(sea.geodesy) {
  composed_ = noted_ = std::make_shared<const ServedScene>(scene, std::move(sea));
  scene_.publish(noted_);
  publish();
  meters_.addEvents("sea", [this] {
    return std::vector<std::pair<std::string, std::uint64_t>>{
        {"poses_before_epoch", posesBeforeEpoch_}};
  });
  thread_ = std::jthread([this](const std::stop_token& stop) { keepWakes(stop); });
  detailThread_ = std::jthread([this](const std::stop_token& stop) { keepDetail(stop); });
  sailingThread_ = std::jthread([this](const std::stop_token& stop) { keepSailing(stop); });
}

ServedSea::~ServedSea() = default;

std::shared_ptr<const Scene> ServedSea::scene() const noexcept {
  const auto served = scene_.latest();
  return {served, &served->scene};
}

// Under composing_.
void ServedSea::publish() {
  const WaterSurface& own = composed_->sea.surface;
  WaterSurface surface = hostWaves_ ? withWaves(own, *hostWaves_) : own;
  if (feed_) surface.setDisturbances(feed_);
  if (detail_) surface.setDetail(detail_);
  surface_.publish(std::make_shared<const WaterSurface>(std::move(surface)));
}

void ServedSea::setOctaves(std::vector<Octave> octaves) {
  const auto settings = surface()->waves().settings();
  auto waves = std::make_shared<const WaveField>(std::move(octaves), settings);
  const std::lock_guard lock(composing_);
  hostWaves_ = std::move(waves);
  ++wavesVersion_;
  publish();
}

void ServedSea::restoreOctaves() {
  const std::lock_guard lock(composing_);
  hostWaves_ = nullptr;
  ++wavesVersion_;
  publish();
}

void ServedSea::setFeed(std::shared_ptr<const DisturbanceFeed> feed, const ServedScene& of) {
  const std::lock_guard lock(composing_);
  if (composed_.get() != &of) return;  // a scene of before
  feed_ = std::move(feed);
  publish();
}

void ServedSea::replaceScene(const Scene& scene, Sea sea) {
  auto next = std::make_shared<const ServedScene>(scene, std::move(sea));
  const GeodeticPosition& here = geodesy_.anchor();
  const GeodeticPosition& there = next->sea.geodesy.anchor();
  if (here.latitude_deg != there.latitude_deg || here.longitude_deg != there.longitude_deg) {
    throw InputError(scene.file.string(), 0,
                     "key 'sea.anchor': a scene that is served keeps its anchor; end the service "
                     "and begin anew");
  }
  const std::lock_guard noting(noting_);
  const std::lock_guard composing(composing_);
  std::vector<std::optional<std::size_t>> numbers;
  for (const SceneVessel& old : noted_->scene.vessels) {
    numbers.emplace_back();
    for (std::size_t i = 0; i < next->scene.vessels.size(); ++i) {
      if (next->scene.vessels[i].name == old.name) numbers.back() = i;
    }
  }
  if (hostWaves_) {
    hostWaves_ = std::make_shared<const WaveField>(
        std::vector<Octave>(hostWaves_->octaves().begin(), hostWaves_->octaves().end()),
        next->sea.surface.waves().settings());
  }
  fleet_.renumber(numbers);
  fleet_.retell();
  composed_ = noted_ = next;
  feed_ = nullptr;
  detail_ = nullptr;
  detailAsked_.time = -std::numeric_limits<double>::infinity();
  detailAsked_.brought.reset();
  detailAsked_.effects.clear();
  detailAsked_.anyGuests = false;
  fleet_.retellTrails();
  voyage_ = nullptr;
  sailingAsked_.time = -std::numeric_limits<double>::infinity();
  tooFarToSail_ = false;
  ++wavesVersion_;
  publish();
  scene_.publish(next);
  coveredFrom_ = 1.0, coveredTo_ = 0.0;
  wanted_ = true;
  ++calls_;
  called_.notify_all();
}

std::uint32_t ServedSea::addHull(std::size_t index) {
  const std::lock_guard lock(noting_);
  if (index >= noted_->vessels.size()) return 0;
  called_.notify_all();  // threads that slept take the hull's news from now on
  return fleet_.add(index);
}

void ServedSea::removeHull(std::uint32_t hull) {
  const std::lock_guard lock(noting_);
  fleet_.remove(hull);
}

bool ServedSea::place(std::uint32_t hull, double t, const HostedPose& pose) {
  const SeaPlanePoint point = geodesy_.seaPlaneFromGeodetic(pose.latitude_deg, pose.longitude_deg);
  VesselPose placed;
  placed.position = point.position;
  placed.direction = towardFromCompassToward(pose.heading_deg) + point.convergence;
  placed.height = pose.height;
  placed.pitch = radiansFromDegrees(pose.pitch_deg);
  placed.roll = radiansFromDegrees(pose.roll_deg);
  const bool sane = point.inRange && WaveField::serves(placed.position, t) &&
                    std::isfinite(placed.direction + placed.height + placed.pitch + placed.roll);
  if (!sane) return false;
  const std::lock_guard lock(noting_);
  if (!fleet_.place(hull, t, placed)) return false;
  if (t < 0.0) ++posesBeforeEpoch_;
  detailAsked_.anyGuests = detailAsked_.anyGuests || noted_->trailsAllowed;
  return true;
}

std::uint32_t ServedSea::ownWake(std::uint32_t hull) const {
  const std::lock_guard lock(noting_);
  const auto found = fleet_.hulls().find(hull);
  if (found == fleet_.hulls().end()) return 0;
  const VesselWake& wake = noted_->scene.vessels[found->second.vessel].model.wake;
  return wake.feltByItself ? 0 : hull;
}

std::vector<bool> ServedSea::hostedVessels() const {
  std::vector<bool> hosted(noted_->vessels.size());
  for (const auto& [number, hull] : fleet_.hulls()) {
    if (hull.isPlaced()) hosted[hull.vessel] = true;
  }
  return hosted;
}

namespace {

/// At rest somewhere.
Course resting(const CoursePoint& place) {
  return Course(place.position, place.direction, 0.0, 0.0);
}

VesselPose afloatOn(const WaterSurface& surface, const ServedScene& scene, std::size_t vessel,
                    const Course& course, double t, std::uint32_t own) {
  const VesselModel& model = scene.scene.vessels[vessel].model;
  PrescribedVessel floating(model.hull, course);
  std::vector<glm::dvec2> points(floating.sampleCount());
  std::vector<SurfaceSample> water(points.size());
  floating.samplePoints(t, points);
  surface.sample(points, t, water, {.excludeVessel = model.wake.feltByItself ? 0 : own});
  for (SurfaceSample& sample : water) {
    // Ashore it lies at still-water level.
    if (!std::isfinite(sample.height)) sample = SurfaceSample{};
  }
  const bool moves =
      scene.scene.effects[static_cast<std::size_t>(Effect::vesselMotion)] != EffectSetting::off;
  moves ? floating.settle(t, water) : floating.advanceUpright(t, water);
  VesselPose pose = floating.pose();
  const CoursePoint place = course.at(t);
  pose.position = place.position;
  pose.direction = place.direction;
  return pose;
}

}  // namespace

ServedMoment ServedSea::moment(double t) const {
  ServedMoment result;
  result.time = t;
  std::vector<bool> hosted;
  std::shared_ptr<const FreeVoyage> voyage;
  {
    const std::lock_guard lock(noting_);
    voyage = voyage_;
    result.scene = noted_;
    result.surface = surface();
    hosted = hostedVessels();
    for (const auto& [number, hull] : fleet_.hulls()) {
      if (const auto pose = fleet_.at(number, t)) {
        result.hulls.push_back({{hull.vessel, *pose}, number});
      }
    }
  }
  for (std::size_t i = 0; i < hosted.size(); ++i) {
    if (hosted[i]) continue;
    const ServedVessel& vessel = result.scene->vessels[i];
    const bool free = vessel.free && t >= 0.0;
    if (free && voyage) {
      result.hulls.push_back({{i, voyage->poseAt(i, t)}, 0, !voyage->covers(t)});
      continue;
    }
    const Course course = free ? resting(vessel.course.at(0.0)) : vessel.course;
    result.hulls.push_back(
        {{i, afloatOn(*result.surface, *result.scene, i, course, t, ServedScene::handleOf(i))},
         0,
         free});
  }
  std::stable_sort(result.hulls.begin(), result.hulls.end(),
                   [](const auto& a, const auto& b) { return a.vessel < b.vessel; });
  return result;
}

VesselPose ServedSea::afloat(std::size_t vessel, glm::dvec2 position, double direction,
                             double t) const {
  const auto scene = scene_.latest();
  if (vessel >= scene->vessels.size()) return {};
  return afloatOn(*surface(), *scene, vessel, Course(position, direction, 0.0, 0.0), t, 0);
}

}  // namespace seaway::bridge
