#include "sim_bridge/cigi/point_requests.h"

namespace seaway::bridge::cigi {

PointRequest pointRequest(const HatHotRequest& request) {
  return {request.request,    static_cast<PointQuestion>(request.type),
          request.entityAxes, request.period,
          request.entity,     request.latitude,
          request.longitude,  request.altitude};
}

PointRequest pointRequest(const WaterVelocityRequest& request) {
  return {request.request, PointQuestion::velocity, request.entityAxes, request.period,
          request.entity,  request.latitude,        request.longitude,  request.altitude};
}

bool PointRequests::take(const PointRequest& request) {
  const bool velocity = request.question == PointQuestion::velocity;
  const std::uint32_t key = (velocity ? 0x10000u : 0u) | request.request;
  if (request.period == 0) {
    if (once_.size() >= most_) return false;
    periodic_.erase(key);
    once_.push_back(request);
    return true;
  }
  const auto found = periodic_.find(key);
  if (found == periodic_.end() && periodic_.size() >= most_) return false;
  periodic_[key] = {request, 0};
  return true;
}

std::span<const PointRequest> PointRequests::nextFrame() {
  due_.clear();
  for (auto& [key, periodic] : periodic_) {
    if (periodic.wait == 0) {
      due_.push_back(periodic.request);
      periodic.wait = periodic.request.period;
    }
    --periodic.wait;
  }
  due_.insert(due_.end(), once_.begin(), once_.end());
  once_.clear();
  return due_;
}

void PointRequests::clear() {
  periodic_.clear();
  once_.clear();
}

}  // namespace seaway::bridge::cigi
