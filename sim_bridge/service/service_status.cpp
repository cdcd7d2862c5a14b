#include "sim_bridge/service/service_status.h"

#include <algorithm>
#include <utility>

#include "sim_bridge/service/service_log.h"

namespace seaway::bridge {
namespace {

constexpr std::size_t moments = 11;

EndpointLoad loadOf(const std::string& name, const MeterCounts& now, const MeterCounts& before,
                    double seconds) {
  EndpointLoad load{.name = name, .total = now};
  const LatencyCounts lately = now.requests.since(before.requests);
  const auto rate = [&](double count) { return seconds > 0.0 ? count / seconds : 0.0; };
  load.requestsPerSecond = rate(static_cast<double>(lately.total()));
  load.pointsPerSecond = rate(static_cast<double>(now.points - before.points));
  load.framesPerSecond = rate(static_cast<double>(now.frames.since(before.frames).total()));
  const LatencyCounts& shown = lately.total() > 0 ? lately : now.requests;
  load.median = shown.quantile(0.5);
  load.percentile99 = shown.quantile(0.99);
  return load;
}

VesselFigures figuresOf(const ServedHull& hull, const ServedMoment& moment,
                        const Geodesy& geodesy) {
  const GeodeticPosition at = geodesy.geodeticFromSeaPlane(hull.pose.position);
  return {moment.scene->scene.vessels[hull.vessel].name,
          hull.hull != 0,
          moment.scene->vessels[hull.vessel].free,
          hull.outOfTime,
          at.latitude_deg,
          at.longitude_deg,
          geodesy.trueHeadingFromDirection(hull.pose.position, hull.pose.direction),
          hull.pose.height};
}

}  // namespace

ServiceStatus::ServiceStatus(ServedSea& sea, FrameMaker& frames, const ServeClock& clock,
                             std::function<std::vector<std::string>()> descriptions)
    : sea_(sea), frames_(frames), clock_(clock), descriptions_(std::move(descriptions)) {
  note();
}

double ServiceStatus::time() const { return clock_.isHosts() ? sea_.lastTime() : clock_.now(); }

ServiceStatus::Moment ServiceStatus::now() const {
  Moment result{Clock::now(), time(), {}};
  for (auto& [name, counts] : sea_.meters().read()) result.counts[name] = counts;
  return result;
}

void ServiceStatus::note() {
  Moment moment = now();
  const std::lock_guard lock(mutex_);
  past_.push_back(std::move(moment));
  if (past_.size() > moments) past_.pop_front();
}

// Wakes and queries run beside the pictures, so that a picture's own account does not have them.
std::vector<EffectReport> ServiceStatus::effects() const {
  std::vector<EffectReport> all = frames_.effects();
  if (all.empty()) all = EffectLedger(sea_.scene()->effects).report();
  const auto scene = sea_.scene();
  const auto tell = [&](Effect effect, bool on, const char* why, const char* whyNot) {
    EffectReport& report = all[static_cast<std::size_t>(effect)];
    if (report.state == EffectState::off) return;
    report.state = on ? EffectState::on : EffectState::idle;
    report.reason = on ? why : whyNot;
  };
  const auto surface = sea_.surface();
  tell(Effect::waves, !surface->waves().octaves().empty(), "whoever asks is told of them",
       "flat water: the field has no octaves");
  all[static_cast<std::size_t>(Effect::waves)].memoryBytes = surface->waves().memoryBytes();
  tell(Effect::hullLoads, sea_.hasFreeVessels(), "free vessels sail to the time asked for",
       "no vessel's motion is free");
  tell(Effect::vesselMotion, !scene->vessels.empty(),
       "vessels lie on the water where no host places them", "the scene has no vessel");
  const std::vector<EffectReport> onWater = sea_.detailEffects();
  for (const Effect effect :
       {Effect::trail, Effect::oil, Effect::ripples, Effect::splash, Effect::rain}) {
    const auto i = static_cast<std::size_t>(effect);
    if (!onWater.empty()) all[i] = onWater[i];
  }
  EffectReport& wake = all[static_cast<std::size_t>(Effect::wake)];
  const ServedSea::WakeFigures wakes = sea_.wakeFigures();
  if (wake.state == EffectState::off) return all;
  wake.state = wakes.running > 0 ? EffectState::on : EffectState::idle;
  wake.memoryBytes = wakes.memoryBytes;
  wake.reason = wakes.running > 0 ? std::to_string(wakes.running) + " wakes near those who ask"
                                  : "no vessel under way is near anyone who asks";
  return all;
}

ServiceFigures ServiceStatus::read() {
  const Moment moment = now();
  Moment before;
  {
    const std::lock_guard lock(mutex_);
    before = past_.front();
  }
  const auto seconds = [](Clock::duration d) { return std::chrono::duration<double>(d).count(); };
  const double past = seconds(moment.when - before.when);
  ServiceFigures figures;
  figures.version = SEAWAY_VERSION;
  const ServedMoment seen = sea_.moment(moment.time);
  figures.scene = seen.scene->scene.file.string();
  figures.clock = clock_.isHosts() ? "host" : "own";
  figures.uptime = seconds(moment.when - begun_);
  figures.time = moment.time;
  figures.realTimeFactor = past > 0.0 ? (moment.time - before.time) / past : 0.0;
  figures.asked = askedSeaState(seen.scene->scene, seen.scene->sea);
  figures.realised = reading_.of(sea_);
  for (const auto& [name, counts] : moment.counts) {
    figures.endpoints.push_back(loadOf(name, counts, before.counts[name], past));
  }
  figures.events = sea_.meters().readEvents();
  figures.effects = effects();
  figures.wakes = sea_.wakeFigures();
  figures.wakeSpan = sea_.wakeSpan();
  for (const ServedHull& hull : seen.hulls) {
    figures.vessels.push_back(figuresOf(hull, seen, sea_.geodesy()));
  }
  figures.cameras = frames_.cameras();
  figures.descriptions = descriptions_();
  const LogCounts log = logCounts();
  figures.warnings = log.warnings;
  figures.errors = log.errors;
  return figures;
}

}  // namespace seaway::bridge
