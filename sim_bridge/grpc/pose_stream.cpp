#include "sim_bridge/grpc/pose_stream.h"

#include <cmath>
#include <set>
#include <utility>

#include "sim_bridge/scene/schema.h"

namespace seaway::bridge::rpc {
namespace {

using v1::HullPose;

void requireAngle(const std::string& field, double value, double most) {
  if (!(std::abs(value) <= most)) {
    const std::string bound = std::to_string(static_cast<int>(most));
    throw badValue(field, value, "must be in [-" + bound + ", " + bound + "]");
  }
}

void requireSound(const HullPose& pose, const std::string& field) {
  requireAngle(field + ".latitude_deg", pose.latitude_deg(), 90.0);
  requireAngle(field + ".longitude_deg", pose.longitude_deg(), 360.0);
  requireAngle(field + ".heading_deg", pose.heading_deg(), 360.0);
  requireAngle(field + ".pitch_deg", pose.pitch_deg(), 180.0);
  requireAngle(field + ".roll_deg", pose.roll_deg(), 180.0);
  if (!std::isfinite(pose.height_m())) {
    throw badValue(field + ".height_m", pose.height_m(), "must be finite");
  }
}

}  // namespace

std::size_t PoseStream::vesselOf(const HullPose& pose, const std::string& field) const {
  const auto scene = host_->sea.scene();
  std::vector<std::string> names;
  for (std::size_t i = 0; i < scene->vessels.size(); ++i) {
    if (scene->vessels[i].name == pose.vessel()) return i;
    names.push_back(scene->vessels[i].name);
  }
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
  throw RpcFault(
      grpc::StatusCode::NOT_FOUND, Refusal::notFound,
      field + ".vessel: '" + pose.vessel() + "' is no vessel of the scene; must be one of: " + all);
}

void PoseStream::check(const v1::PosesRequest& request) const {
  const double t = host_->timeOf(request);
  if (!WaveField::serves({}, t)) throw badValue("time_s", t, "must be in [-1e12, 1e12]");
  std::set<std::string> names;
  std::size_t count = hulls_.size();
  for (int i = 0; i < request.hulls_size(); ++i) {
    const HullPose& pose = request.hulls(i);
    const std::string field = "hulls[" + std::to_string(i) + "]";
    if (!names.insert(pose.name()).second) {
      throw badValue(field + ".name", "'" + pose.name() + "', a second time,",
                     "must be unique in a request");
    }
    if (pose.gone()) continue;
    requireSound(pose, field);
    if (hulls_.contains(pose.name())) continue;
    vesselOf(pose, field);
    ++count;
  }
  if (count > host_->limits.hulls) {
    throw RpcFault(grpc::StatusCode::RESOURCE_EXHAUSTED, Refusal::tooLarge,
                   "hulls: " + std::to_string(count) + " are not allowed in one stream; at most " +
                       std::to_string(host_->limits.hulls));
  }
}

std::uint32_t PoseStream::hullOf(const HullPose& pose) {
  const auto found = hulls_.find(pose.name());
  if (found != hulls_.end()) return found->second;
  const std::uint32_t hull = host_->sea.addHull(vesselOf(pose, "hulls"));
  hulls_[pose.name()] = hull;
  host_->hulls.add(hull);
  return hull;
}

void PoseStream::remove(const std::string& name) {
  const auto found = hulls_.find(name);
  if (found == hulls_.end()) return;
  host_->hulls.remove(found->second);
  host_->sea.removeHull(found->second);
  hulls_.erase(found);
}

void PoseStream::submit(const v1::PosesRequest& request, v1::PosesResponse& response) {
  check(request);
  const double t = host_->timeOf(request);
  for (const HullPose& pose : request.hulls()) {
    if (pose.gone()) {
      remove(pose.name());
      continue;
    }
    const bool placed =
        host_->sea.place(hullOf(pose), t,
                         {pose.latitude_deg(), pose.longitude_deg(), pose.height_m(),
                          pose.heading_deg(), pose.pitch_deg(), pose.roll_deg()});
    if (!placed) response.add_ignored(pose.name());
  }
  response.set_id(request.id());
  response.set_time_s(t);
  for (const auto& [name, hull] : hulls_) {
    v1::PosesResponse::Hull* entry = response.add_hulls();
    entry->set_name(name);
    entry->set_hull(hull);
  }
}

void PoseStream::leave() {
  while (!hulls_.empty()) remove(hulls_.begin()->first);
}

}  // namespace seaway::bridge::rpc
