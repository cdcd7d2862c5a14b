#include "sim_bridge/service/status_json.h"

#include <nlohmann/json.hpp>

namespace seaway::bridge {
namespace {

using nlohmann::ordered_json;

ordered_json asJson(const std::optional<double>& value) {
  return value ? ordered_json(*value) : ordered_json(nullptr);
}

ordered_json asJson(const SeaStateFigures& state) {
  return {{"hm0_m", asJson(state.significantWaveHeight)},
          {"tp_s", asJson(state.peakPeriod)},
          {"from_deg", asJson(state.from_deg)}};
}

ordered_json asJson(const EndpointLoad& load) {
  ordered_json refusals = ordered_json::object();
  for (std::size_t i = 0; i < load.total.refusals.size(); ++i) {
    refusals[refusalName(static_cast<Refusal>(i))] = load.total.refusals[i];
  }
  return {{"name", load.name},
          {"requests", load.total.requests.total()},
          {"requests_per_s", load.requestsPerSecond},
          {"points", load.total.points},
          {"points_per_s", load.pointsPerSecond},
          {"frames", load.total.frames.total()},
          {"frames_per_s", load.framesPerSecond},
          {"median_s", load.median},
          {"p99_s", load.percentile99},
          {"refused", refusals}};
}

ordered_json asJson(const EffectReport& effect) {
  return {{"name", effectName(effect.effect)},
          {"state", effectStateName(effect.state)},
          {"memory_bytes", effect.memoryBytes},
          {"cost_us", effect.costMicroseconds},
          {"reason", effect.reason}};
}

ordered_json asJson(const VesselFigures& vessel) {
  return {{"name", vessel.name},
          {"hosted", vessel.hosted},
          {"free", vessel.free},
          {"out_of_time", vessel.outOfTime},
          {"latitude_deg", vessel.latitude_deg},
          {"longitude_deg", vessel.longitude_deg},
          {"heading_deg", vessel.heading_deg},
          {"height_m", vessel.height}};
}

template <class T>
ordered_json listOf(const std::vector<T>& all) {
  ordered_json list = ordered_json::array();
  for (const T& each : all) list.push_back(asJson(each));
  return list;
}

}  // namespace

std::string statusJson(const ServiceFigures& figures) {
  ordered_json events = ordered_json::object();
  for (const Meters::Event& event : figures.events)
    events[event.endpoint][event.name] = event.count;
  ordered_json wakes{{"running", figures.wakes.running},
                     {"memory_bytes", figures.wakes.memoryBytes},
                     {"from_s", nullptr},
                     {"to_s", nullptr}};
  if (figures.wakeSpan) {
    wakes["from_s"] = figures.wakeSpan->first;
    wakes["to_s"] = figures.wakeSpan->second;
  }
  return ordered_json{
             {"version", figures.version},
             {"scene", figures.scene},
             {"clock", figures.clock},
             {"uptime_s", figures.uptime},
             {"time_s", figures.time},
             {"real_time_factor", figures.realTimeFactor},
             {"sea", {{"asked", asJson(figures.asked)}, {"realised", asJson(figures.realised)}}},
             {"endpoints", figures.descriptions},
             {"load", listOf(figures.endpoints)},
             {"events", events},
             {"effects", listOf(figures.effects)},
             {"wakes", wakes},
             {"vessels", listOf(figures.vessels)},
             {"cameras", figures.cameras},
             {"warnings", figures.warnings},
             {"errors", figures.errors}}
             .dump(2, ' ', false, ordered_json::error_handler_t::replace) +
         '\n';
}

}  // namespace seaway::bridge
