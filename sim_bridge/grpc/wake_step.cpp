#include "sim_bridge/grpc/wake_step.h"

#include <cmath>
#include <vector>

namespace seaway::bridge::rpc {

void WakeStep::call(const v1::StepRequest& request) {
  time_ = host_->timeOf(request);
  if (!WaveField::serves({}, time_)) throw badValue("time_s", time_, "must be in [-1e12, 1e12]");
  const auto count = static_cast<std::size_t>(request.places_size());
  if (count > host_->limits.places) {
    throw RpcFault(grpc::StatusCode::RESOURCE_EXHAUSTED, Refusal::tooLarge,
                   "places: " + std::to_string(count) + " are not allowed; at most " +
                       std::to_string(host_->limits.places));
  }
  std::vector<WakeListener> listeners;
  for (int i = 0; i < request.places_size(); ++i) {
    const v1::Place& place = request.places(i);
    const std::string field = "places[" + std::to_string(i) + "]";
    if (!WaveField::serves({place.x_m(), place.y_m()}, time_)) {
      throw badValue(field + ".x_m, y_m", "a place that far", "must be finite, within 1e12 m");
    }
    if (!(place.radius_m() >= 0.0) || std::isinf(place.radius_m())) {
      throw badValue(field + ".radius_m", place.radius_m(), "must be >= 0 and finite");
    }
    listeners.push_back({{place.x_m(), place.y_m()},
                         place.radius_m(),
                         host_->ownWakeOf(place.hull(), (field + ".hull").c_str())});
  }
  host_->sea.attend(time_, listeners);
}

bool WakeStep::isThere(const v1::StepRequest& request, v1::StepResponse& response) {
  if (!called_) call(request);
  called_ = true;
  if (request.wait() && !host_->sea.awaitWakes(0.0)) return false;
  response.set_time_s(time_);
  if (const auto span = host_->sea.wakeSpan()) {
    response.set_wakes_from_s(span->first);
    response.set_wakes_to_s(span->second);
  }
  return true;
}

}  // namespace seaway::bridge::rpc
