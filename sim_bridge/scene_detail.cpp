#include "sim_bridge/scene_detail.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "sim_bridge/scene/sea.h"
#include "sim_bridge/scene/vessel_course.h"
#include "sim_bridge/scene/vessel_launch.h"
#include "surface/angles.h"
#include "surface/disturbance/layers/layer_file.h"
#include "surface/field/lattice_hash.h"
#include "surface/input_error.h"
#include "surface/state_archive.h"

namespace seaway::bridge {
namespace {

constexpr double strokeLength = 0.25;  // s
constexpr double strokesPerPrune = 32.0;
constexpr double longestTrail = 600.0;  // s

EffectSetting settingOf(const Scene& scene, Effect effect) {
  return scene.effects[static_cast<std::size_t>(effect)];
}
bool isOff(const Scene& scene, Effect effect) {
  return settingOf(scene, effect) == EffectSetting::off;
}

glm::dvec2 inSeaPlane(const Place& place, const Geodesy& geodesy) {
  return geodesy.seaPlaneFromGeodetic(place.latitude_deg, place.longitude_deg).position;
}

Splash splashOf(const SceneSplash& splash, const Geodesy& geodesy) {
  const bool burst = splash.kind == SplashKind::explosion;
  return {.place = inSeaPlane(splash.place, geodesy),
          .time = splash.time,
          .height = splash.height.value_or(burst ? 2.5 : 0.3),
          .wavelength = splash.wavelength.value_or(burst ? 9.0 : 1.5),
          .reach = splash.reach.value_or(burst ? 18.0 : 3.0),
          .duration = splash.duration.value_or(burst ? 5.0 : 1.5)};
}

double foamRadius(const SceneSplash& splash) {
  return splash.foamRadius.value_or(splash.kind == SplashKind::explosion ? 9.0 : 0.5);
}

/// How long a layer shows what was left on it, s.
double memoryOf(double life) {
  return -std::log(static_cast<double>(SurfaceLayer::leastCover)) * life;
}

/// Whether a host has put a vessel elsewhere meanwhile: faster than 100 m/s is no sailing.
bool leaps(const Vessel& vessel, double from, double to) {
  return glm::distance(vessel.placeAt(from).position, vessel.placeAt(to).position) >
         100.0 * (to - from);
}

bool isUnderWay(const SceneVessel& vessel, const Sea& sea) {
  return vessel.speed != 0.0 || sea.surface.waves().settings().current != glm::dvec2(0.0);
}

}  // namespace

std::shared_ptr<const SurfaceEvents> sceneEvents(const Scene& scene, const Geodesy& geodesy,
                                                 const SurfaceEvents::Water& water) {
  std::vector<Splash> splashes;
  if (!isOff(scene, Effect::splash)) {
    for (const SceneSplash& splash : scene.splashes) splashes.push_back(splashOf(splash, geodesy));
  }
  Rain rain;
  if (!isOff(scene, Effect::rain)) {
    rain = Rain::ofRate(scene.rain.rate, static_cast<std::uint64_t>(scene.sea.seed));
    rain.from = scene.rain.from;
    rain.to = scene.rain.to;
  }
  if (splashes.empty() && !rain.falls()) return nullptr;
  return std::make_shared<const SurfaceEvents>(splashes, rain, water);
}

RippleSource rippleSource(const SceneRipples& ripples, const Geodesy& geodesy) {
  return {.place = inSeaPlane(ripples.place, geodesy),
          .time = ripples.time,
          .duration = ripples.duration,
          .height = ripples.height,
          .period = ripples.period,
          .wavelength = ripples.wavelength,
          .side = ripples.side};
}

SceneDetail::SceneDetail(const Scene& scene, const Sea& sea) : scene_(&scene), sea_(&sea) {
  addPatches();
  for (std::size_t i = 0; i < scene.vessels.size(); ++i) {
    const SceneVessel& vessel = scene.vessels[i];
    if (isOff(scene, Effect::trail) || !isUnderWay(vessel, sea)) continue;
    trails_.push_back({{vessel.model.hull.length, vessel.model.hull.beam},
                       courseOf(vessel, sea.geodesy),
                       i,
                       sailsFreely(scene, vessel)});
  }
  if (isOff(scene, Effect::ripples)) return;
  for (const SceneRipples& ripples : scene.ripples) {
    pools_.emplace_back(rippleSource(ripples, sea.geodesy), sea.surface.waves().settings().current);
  }
}

void SceneDetail::addPatches() {
  if (!isOff(*scene_, Effect::splash)) {
    for (const SceneSplash& splash : scene_->splashes) {
      const double radius = foamRadius(splash);
      if (radius == 0.0) continue;
      const glm::dvec2 place = inSeaPlane(splash.place, sea_->geodesy);
      patches_.push_back({splash.time, [=](SceneDetail& detail) {
                            paintPatch(place, radius, 0.9, splash.time,
                                       detail.layer(LayerKind::foam));
                          }});
    }
  }
  for (const SceneLayer& each : scene_->layers) {
    if (each.kind == LayerKind::oil && isOff(*scene_, Effect::oil)) continue;
    if (each.kind != LayerKind::oil && isOff(*scene_, Effect::trail)) continue;
    if (each.place) {
      const glm::dvec2 place = inSeaPlane(*each.place, sea_->geodesy);
      patches_.push_back({each.time, [=](SceneDetail& detail) {
                            paintPatch(place, each.radius, each.cover, each.time,
                                       detail.layer(each.kind));
                          }});
      continue;
    }
    // Read now, so that a fault in the file shows before anything runs; the layer that is painted
    // on takes it over cell by cell.
    const LayerAccuracy& accuracy = scene_->accuracy.layers;
    auto read = std::make_shared<SurfaceLayer>(LayerSettings{.cellSize = accuracy.cell});
    readLayer(each.file, each.grid, 0.0, *read);
    patches_.push_back(
        {each.time, [=](SceneDetail& detail) {
           SurfaceLayer& to = detail.layer(each.kind);
           const double cell = accuracy.cell, half = 0.5 * cell;
           read->visit(0.0, [&](const SurfaceLayer::Cell& from) {
             const glm::dvec2 centre =
                 glm::dvec2(static_cast<double>(from.i), static_cast<double>(from.j)) * cell + half;
             to.paint(centre - half, centre + half, each.time,
                      [&](glm::dvec2) { return from.cover; });
           });
         }});
  }
  std::stable_sort(patches_.begin(), patches_.end(),
                   [](const Patch& a, const Patch& b) { return a.time < b.time; });
}

SurfaceLayer& SceneDetail::layer(LayerKind kind) {
  const LayerAccuracy& accuracy = scene_->accuracy.layers;
  LayerSettings settings{.cellSize = accuracy.cell, .decayTime = accuracy.oilLife};
  settings.drift = sea_->surface.waves().settings().current;
  auto* which = &oil_;
  if (kind == LayerKind::foam) which = &foam_, settings.decayTime = accuracy.foamLife;
  if (kind == LayerKind::smooth) which = &smooth_, settings.decayTime = accuracy.smoothLife;
  if (!*which) which->emplace(settings);
  return **which;
}

// Vessels that the scene has at rest leave trails once a host moves them.
void SceneDetail::followHosted(std::span<const Vessel> vessels) {
  if (isOff(*scene_, Effect::trail)) return;
  for (std::size_t i = 0; i < vessels.size(); ++i) {
    const bool known = std::any_of(trails_.begin(), trails_.end(),
                                   [=](const Trail& trail) { return trail.vessel == i; });
    if (!vessels[i].hosted() || known) continue;
    const SceneVessel& vessel = scene_->vessels[i];
    trails_.push_back({{vessel.model.hull.length, vessel.model.hull.beam},
                       courseOf(vessel, sea_->geodesy),
                       i,
                       true});
  }
}

void SceneDetail::paintStroke(long long stroke, std::span<const Vessel> vessels) {
  const double from = static_cast<double>(stroke) * strokeLength, to = from + strokeLength;
  const glm::dvec2 current = sea_->surface.waves().settings().current;
  for (const Trail& trail : trails_) {
    if (trail.free && vessels.empty() && from >= 0.0) continue;
    if (trail.vessel < away_.size() && away_[trail.vessel]) continue;
    const bool hosted = !vessels.empty() && vessels[trail.vessel].hosted();
    const bool follows = (trail.free && !vessels.empty()) || hosted;
    if (hosted && leaps(vessels[trail.vessel], from, to)) continue;
    const auto poseAt = [&](double t) {
      const CoursePoint place = follows ? vessels[trail.vessel].placeAt(t) : trail.course.at(t);
      return TrailPose{place.position, place.direction, place.velocity - current};
    };
    paintTrail(trail.hull, poseAt, from, to, layer(LayerKind::foam), layer(LayerKind::smooth));
  }
}

// What is older shows no more, or, of smoothed water, a twentieth: neither where all begins nor
// after a leap in time.
double SceneDetail::memory() const {
  const LayerAccuracy& accuracy = scene_->accuracy.layers;
  return std::min(std::max(memoryOf(accuracy.foamLife), 3.0 * accuracy.smoothLife), longestTrail);
}

double SceneDetail::leaveTrail(const Guest& guest) {
  auto stroke = static_cast<long long>(std::ceil(guest.from / strokeLength));
  const auto end = static_cast<long long>(std::floor(guest.to / strokeLength));
  if (isOff(*scene_, Effect::trail) || stroke >= end) return guest.from;
  const glm::dvec2 current = sea_->surface.waves().settings().current;
  const auto poseAt = [&](double t) {
    const CoursePoint place = guest.placeAt(t);
    return TrailPose{place.position, place.direction, place.velocity - current};
  };
  for (; stroke < end; ++stroke) {
    const double from = static_cast<double>(stroke) * strokeLength;
    paintTrail(guest.hull, poseAt, from, from + strokeLength, layer(LayerKind::foam),
               layer(LayerKind::smooth));
  }
  guestsPainted_ = true;
  return static_cast<double>(end) * strokeLength;
}

bool SceneDetail::paint(double t, std::span<const Vessel> vessels, EffectLedger* ledger) {
  followHosted(vessels);
  const auto last = static_cast<long long>(std::floor(t / strokeLength));
  const bool trails = !trails_.empty();
  EffectTimer timer(trails ? ledger : nullptr, Effect::trail);
  const long long first =
      trails ? last - static_cast<long long>(std::ceil(memory() / strokeLength)) : last;
  long long next = std::max(nextStroke_.value_or(first), first);
  bool changed = std::exchange(guestsPainted_, false);
  const auto paintPatches = [&](double before) {
    for (; nextPatch_ < patches_.size() && patches_[nextPatch_].time <= before; ++nextPatch_) {
      patches_[nextPatch_].paint(*this);
      changed = true;
    }
  };
  for (; next < last; ++next) {
    paintPatches(static_cast<double>(next) * strokeLength);
    if (trails) paintStroke(next, vessels), changed = true;
  }
  paintPatches(t);
  nextStroke_ = std::max(next, last);
  if (changed && std::fmod(static_cast<double>(last), strokesPerPrune) == 0.0) {
    for (auto* each : {&foam_, &smooth_, &oil_}) {
      if (*each) (*each)->prune(t);
    }
  }
  return changed;
}

bool SceneDetail::advancePools(double t, EffectLedger* ledger) {
  const bool any = std::any_of(pools_.begin(), pools_.end(), [&](const RipplePool& pool) {
    const RippleSource& source = pool.source();
    return pool.memoryBytes() > 0 || (t > source.time && t < source.end());
  });
  if (!any) return false;
  EffectTimer timer(ledger, Effect::ripples);
  for (RipplePool& pool : pools_) pool.advance(t);
  return true;
}

void SceneDetail::advance(double t, std::span<const Vessel> vessels, EffectLedger* ledger) {
  time_ = t;
  const bool painted = paint(t, vessels, ledger);
  const bool rippled = advancePools(t, ledger);
  if (painted || rippled || !detail_) detail_ = snapshot();
  if (ledger) report(t, ledger);
}

bool SceneDetail::mayRipple(glm::dvec2 place, double radius) const {
  return std::any_of(pools_.begin(), pools_.end(), [&](const RipplePool& pool) {
    const RippleSource& source = pool.source();
    const glm::dvec2 current = sea_->surface.waves().settings().current;
    const double drift = glm::length(current) * (source.end() - source.time);
    return glm::distance(place, source.place) < radius + source.side + drift;
  });
}

SceneDetail::Span SceneDetail::span() const {
  const auto about = [&](double step) {
    const double index = std::floor(time_ / step);
    return Span{index * step, (index + 1.0) * step};
  };
  Span span = about(strokeLength);
  const auto narrow = [&](double from, double to) {
    span = {std::max(span.from, from), std::min(span.to, to)};
  };
  if (!pools_.empty()) narrow(about(RipplePool::step).from, about(RipplePool::step).to);
  if (nextPatch_ > 0) narrow(patches_[nextPatch_ - 1].time, span.to);
  if (nextPatch_ < patches_.size()) narrow(span.from, patches_[nextPatch_].time);
  return span;
}

std::shared_ptr<const SurfaceDetail> SceneDetail::snapshot() const {
  SurfaceDetail made;
  const auto take = [](const std::optional<SurfaceLayer>& from,
                       std::shared_ptr<const SurfaceLayer>& to) {
    if (from && !from->empty()) to = std::make_shared<const SurfaceLayer>(*from);
  };
  take(foam_, made.cover.foam);
  take(smooth_, made.cover.smooth);
  take(oil_, made.cover.oil);
  for (const RipplePool& pool : pools_) {
    if (auto sheet = pool.sheet()) made.ripples.push_back(std::move(sheet));
  }
  if (made.empty()) return nullptr;
  return std::make_shared<const SurfaceDetail>(std::move(made));
}

void SceneDetail::report(double t, EffectLedger* ledger) const {
  const auto decide = [&](Effect effect, bool on, const char* why, const char* whyNot,
                          std::size_t bytes) {
    if (ledger->decide(effect, on, on ? why : whyNot)) ledger->holdMemory(effect, bytes);
  };
  const auto bytesOf = [](const std::optional<SurfaceLayer>& each) {
    return each ? each->memoryBytes() : 0;
  };
  const bool trails = (foam_ && !foam_->empty()) || (smooth_ && !smooth_->empty());
  decide(Effect::trail, trails, "foam or smoothed water lies on the sea",
         "no vessel is under way, and nothing was left", bytesOf(foam_) + bytesOf(smooth_));
  const bool oils = oil_ && !oil_->empty();
  decide(Effect::oil, oils, "oil lies on the sea", "the scene has no oil at this time",
         bytesOf(oil_));
  const SurfaceEvents* events = sea_->surface.extras().events.get();
  const auto splashes = events ? events->splashesAbout(t) : std::span<const SplashRings>();
  const bool splashing = std::any_of(splashes.begin(), splashes.end(),
                                     [&](const SplashRings& each) { return each.isActive(t); });
  decide(Effect::splash, splashing, "a splash is alive", "no splash at this time",
         events ? events->memoryBytes() : 0);
  const bool rains = events && events->rain().falls(t);
  decide(Effect::rain, rains, "it rains", "no rain at this time", 0);
  std::size_t pools = 0;
  for (const RipplePool& pool : pools_) pools += pool.memoryBytes();
  decide(Effect::ripples, pools > 0, "a source of ripples is alive",
         "no source of ripples at this time", pools);
}

template <class Archive>
void SceneDetail::archive(Archive& archive, double t) {
  if constexpr (isReader<Archive>) {
    for (auto* each : {&foam_, &smooth_, &oil_}) each->reset();
    nextStroke_.reset();
  }
  archivePlain(archive, nextPatch_);
  bool began = nextStroke_.has_value();
  archivePlain(archive, began);
  long long next = nextStroke_.value_or(0);
  archivePlain(archive, next);
  if (began) nextStroke_ = next;
  for (const LayerKind kind : {LayerKind::foam, LayerKind::smooth, LayerKind::oil}) {
    const auto& held = kind == LayerKind::foam ? foam_ : kind == LayerKind::smooth ? smooth_ : oil_;
    bool there = held.has_value();
    archivePlain(archive, there);
    if (there) layer(kind).archive(archive);
  }
  if constexpr (isReader<Archive>) {
    for (RipplePool& pool : pools_) pool.advance(t);  // functions of time
    detail_ = snapshot();
  }
}

template void SceneDetail::archive(StateWriter&, double);
template void SceneDetail::archive(StateReader&, double);

}  // namespace seaway::bridge
