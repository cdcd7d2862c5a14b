#include "sim_bridge/service/served_sea.h"

#include <utility>

#include "surface/disturbance/hull_footprint.h"

namespace seaway::bridge {

ServedSea::ServedSea(const Scene& scene, Sea sea) : scene_(&scene), sea_(std::move(sea)) {
  publish(sea_.surface);
}

void ServedSea::publish(WaterSurface surface) {
  if (wakes_) surface.setDisturbances(wakes_->feed());
  surface_.publish(std::make_shared<const WaterSurface>(std::move(surface)));
}

void ServedSea::setOctaves(std::vector<Octave> octaves) {
  WaterSurface surface(WaveField(std::move(octaves), sea_.surface.waves().settings()));
  surface.setOutline(sea_.surface.sharedOutline());
  const std::lock_guard lock(writing_);
  publish(std::move(surface));
}

void ServedSea::restoreOctaves() {
  const std::lock_guard lock(writing_);
  publish(sea_.surface);
}

std::uint32_t ServedSea::addHull(std::size_t index) {
  const EffectSetting setting = scene_->effects[static_cast<std::size_t>(Effect::wake)];
  if (index >= scene_->vessels.size() || setting == EffectSetting::off) return 0;
  const std::lock_guard lock(writing_);
  if (!wakes_) {
    WakeSystemSettings settings;
    settings.depth = scene_->sea.depth;
    settings.current = sea_.surface.waves().settings().current;
    wakes_ = std::make_unique<WakeSystem>(settings);
    publish(*surface());
  }
  const BoxHull& hull = scene_->vessels[index].model.hull;
  ++hulls_;
  return wakes_->addVessel(HullFootprint::box(hull.length, hull.beam, hull.draft()));
}

void ServedSea::removeHull(std::uint32_t hull) {
  const std::lock_guard lock(writing_);
  if (!wakes_ || hull == 0) return;
  wakes_->removeVessel(hull);
  --hulls_;
}

void ServedSea::record(std::uint32_t hull, const WakePose& pose) {
  const std::lock_guard lock(writing_);
  if (wakes_ && hull != 0) wakes_->record(hull, pose);
}

void ServedSea::advanceWakes(double t, std::span<const WakeListener> listeners) {
  const std::lock_guard lock(writing_);
  if (wakes_ && (hulls_ > 0 || wakes_->running() > 0)) wakes_->advance(t, listeners);
}

}  // namespace seaway::bridge
