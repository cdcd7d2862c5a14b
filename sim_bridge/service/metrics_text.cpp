#include "sim_bridge/service/metrics_text.h"

#include <prometheus/metric_family.h>
#include <prometheus/text_serializer.h>

#include <utility>
#include <vector>

namespace seaway::bridge {
namespace {

using prometheus::ClientMetric;
using prometheus::MetricFamily;
using prometheus::MetricType;
using Labels = std::vector<ClientMetric::Label>;

class Families {
 public:
  void begin(const std::string& name, const std::string& help, MetricType type) {
    all_.push_back({"seaway_" + name, help, type, {}});
  }
  void counter(Labels labels, std::uint64_t value) {
    add(std::move(labels)).counter.value = static_cast<double>(value);
  }
  void gauge(Labels labels, double value) { add(std::move(labels)).gauge.value = value; }
  void histogram(Labels labels, const LatencyCounts& counts) {
    ClientMetric::Histogram& histogram = add(std::move(labels)).histogram;
    for (std::size_t i = 0; i < LatencyCounts::buckets; ++i) {
      histogram.sample_count += counts.counts[i];
      histogram.bucket.push_back({histogram.sample_count, LatencyCounts::upperEnd(i)});
    }
    histogram.sample_sum = counts.sum;
  }
  const std::vector<MetricFamily>& all() const { return all_; }

 private:
  ClientMetric& add(Labels labels) {
    ClientMetric& metric = all_.back().metric.emplace_back();
    metric.label = std::move(labels);
    return metric;
  }
  std::vector<MetricFamily> all_;
};

void addEndpoints(Families& families, const ServiceFigures& figures) {
  families.begin("request_duration_seconds", "Requests answered, by the time they took",
                 MetricType::Histogram);
  for (const EndpointLoad& load : figures.endpoints) {
    families.histogram({{"endpoint", load.name}}, load.total.requests);
  }
  families.begin("points_total", "Points answered", MetricType::Counter);
  for (const EndpointLoad& load : figures.endpoints) {
    families.counter({{"endpoint", load.name}}, load.total.points);
  }
  families.begin(
      "refused_requests_total",
      "Requests not answered, by reason. Not among them: what is no HTTP/2, and calls with "
      "headers beyond 8 KiB, which gRPC drops by itself",
      MetricType::Counter);
  for (const EndpointLoad& load : figures.endpoints) {
    for (std::size_t i = 0; i < load.total.refusals.size(); ++i) {
      families.counter({{"endpoint", load.name}, {"reason", refusalName(static_cast<Refusal>(i))}},
                       load.total.refusals[i]);
    }
  }
  families.begin("frame_duration_seconds", "Pictures sent, by the time they took",
                 MetricType::Histogram);
  for (const EndpointLoad& load : figures.endpoints) {
    families.histogram({{"endpoint", load.name}}, load.total.frames);
  }
  families.begin(
      "endpoint_events_total",
      "What an endpoint counts of its own; of the sea, poses that leave no trail since they "
      "are before the epoch",
      MetricType::Counter);
  for (const Meters::Event& event : figures.events) {
    families.counter({{"endpoint", event.endpoint}, {"event", event.name}}, event.count);
  }
}

void addSea(Families& families, const ServiceFigures& figures) {
  const auto single = [&](const char* name, const char* help, double value) {
    families.begin(name, help, MetricType::Gauge);
    families.gauge({}, value);
  };
  families.begin("build_info", "1, with the version", MetricType::Gauge);
  families.gauge({{"version", figures.version}}, 1.0);
  single("uptime_seconds", "Since the service began", figures.uptime);
  single("time_seconds", "Of the clock, or asked for last, since the scene's epoch", figures.time);
  single("real_time_factor", "Seconds of that time a second, over ten seconds",
         figures.realTimeFactor);
  single("significant_wave_height_asked_metres", "H_m0 that the scene asks for",
         figures.asked.significantWaveHeight.value_or(0.0));
  single("significant_wave_height_metres", "H_m0 of the waves served",
         figures.realised.significantWaveHeight.value_or(0.0));
  single("vessels", "Vessels that are there", static_cast<double>(figures.vessels.size()));
  std::size_t hosted = 0;
  for (const VesselFigures& vessel : figures.vessels) hosted += vessel.hosted ? 1 : 0;
  single("hosted_hulls", "Of those, sailed by hosts", static_cast<double>(hosted));
  single("wakes_running", "Wakes with windows", static_cast<double>(figures.wakes.running));
  single("wake_memory_bytes", "Of wakes", static_cast<double>(figures.wakes.memoryBytes));
  families.begin("effect_active", "1: ran in the picture drawn last, or runs now",
                 MetricType::Gauge);
  for (const EffectReport& effect : figures.effects) {
    const auto name = effectName(effect.effect);
    families.gauge({{"effect", std::string(name)}}, effect.state == EffectState::on ? 1.0 : 0.0);
  }
  families.begin("log_messages_total", "Messages logged, by level", MetricType::Counter);
  families.counter({{"level", "warning"}}, figures.warnings);
  families.counter({{"level", "error"}}, figures.errors);
}

}  // namespace

std::string metricsText(const ServiceFigures& figures) {
  Families families;
  addEndpoints(families, figures);
  addSea(families, figures);
  return prometheus::TextSerializer().Serialize(families.all());
}

}  // namespace seaway::bridge
