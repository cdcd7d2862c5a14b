#include "sim_bridge/commands/performance_json.h"

namespace seaway::bridge {

nlohmann::ordered_json performanceJson(const Performance& performance) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  const auto add = [&](const char* key, const std::optional<double>& value) {
    if (value) json[key] = *value;
  };
  add("height_m", performance.height);
  add("pixel", performance.position);
  add("query_ns", performance.query);
  add("frame_ms", performance.frame);
  add("step_us", performance.step);
  return json;
}

}  // namespace seaway::bridge
