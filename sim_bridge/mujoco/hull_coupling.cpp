#include "sim_bridge/mujoco/hull_coupling.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>
#include <mutex>
#include <optional>
#include <shared_mutex>
#include <stdexcept>

#include "sim_bridge/mujoco/added_inertia.h"
#include "surface/input_error.h"

namespace seaway::bridge {
namespace {

/// Couplings by their models: MuJoCo's callback has no data of its own.
struct Registry {
  std::shared_mutex mutex;
  std::map<const mjModel*, HullCoupling*> couplings;
};

Registry& registry() {
  static Registry all;
  return all;
}

/// What one thread works with; grows at first use.
struct Workspace {
  AddedInertia inertia;
  std::optional<SurfaceAtTime> water;
  std::vector<PlacedHull> hulls;
  std::vector<HullLoads> loads;
  std::vector<LoadScratch> scratch;
};

/// Pose and motion of a body's frame, moved to the hull's origin.
HullPose poseOf(const mjModel* model, const mjData* data, int body, const glm::dvec3& origin) {
  const mjtNum *x = data->xpos + 3 * body, *q = data->xquat + 4 * body;
  mjtNum motion[6];  // turning, then moving
  mj_objectVelocity(model, data, mjOBJ_XBODY, body, motion, 0);
  HullPose pose;
  pose.worldFromBody = {q[0], q[1], q[2], q[3]};
  const glm::dvec3 arm = pose.worldFromBody * origin;
  pose.position = glm::dvec3(x[0], x[1], x[2]) + arm;
  pose.angularVelocity = {motion[0], motion[1], motion[2]};
  pose.velocity =
      glm::dvec3(motion[3], motion[4], motion[5]) + glm::cross(pose.angularVelocity, arm);
  return pose;
}

}  // namespace

HullCoupling::HullCoupling(const mjModel& model, const WaterSurface& water)
    : model_(&model), water_(&water) {
  const std::unique_lock lock(registry().mutex);
  if (mjcb_passive && mjcb_passive != &HullCoupling::passive) {
    throw std::logic_error("another passive callback of MuJoCo is installed");
  }
  if (!registry().couplings.emplace(&model, this).second) {
    throw std::logic_error("the MuJoCo model has a coupling to the sea already");
  }
  mjcb_passive = &HullCoupling::passive;
}

HullCoupling::~HullCoupling() {
  const std::unique_lock lock(registry().mutex);
  registry().couplings.erase(model_);
  if (registry().couplings.empty()) mjcb_passive = nullptr;
}

void HullCoupling::add(const std::string& body, std::shared_ptr<const HullModel> hull,
                       const LoadOptions& options, const glm::dvec3& origin) {
  const int id = mj_name2id(model_, mjOBJ_BODY, body.c_str());
  if (id <= 0) {
    std::string all;
    for (int i = 1; i < model_->nbody; ++i) {
      const char* name = mj_id2name(model_, mjOBJ_BODY, i);
      if (name) all += (all.empty() ? "" : ", ") + std::string(name);
    }
    throw InputError("the MuJoCo model has no body '" + body + "'; must be one of: " + all);
  }
  const auto& added = hull->addedMass();
  addsInertia_ |= std::any_of(added.begin(), added.end(), [](double part) { return part > 0.0; });
  hulls_.push_back({id, std::move(hull), options, origin});
}

void HullCoupling::passive(const mjModel* model, mjData* data) {
  HullCoupling* coupling = nullptr;
  {
    const std::shared_lock lock(registry().mutex);
    const auto found = registry().couplings.find(model);
    if (found != registry().couplings.end()) coupling = found->second;
  }
  if (coupling) coupling->apply(model, data);
}

void HullCoupling::apply(const mjModel* model, mjData* data) {
  thread_local Workspace work;
  if (work.water) {
    work.water->moveTo(*water_, data->time);
  } else {
    work.water.emplace(water_->at(data->time));
  }
  work.hulls.resize(hulls_.size());
  work.loads.resize(hulls_.size());
  work.scratch.resize(std::max(work.scratch.size(), hulls_.size()));
  for (std::size_t i = 0; i < hulls_.size(); ++i) {
    work.hulls[i] = {hulls_[i].model.get(), poseOf(model, data, hulls_[i].body, hulls_[i].origin),
                     hulls_[i].options};
  }
  if (hulls_.size() < parallelFrom) {
    for (std::size_t i = 0; i < hulls_.size(); ++i) {
      const PlacedHull& hull = work.hulls[i];
      work.loads[i] = loads(*hull.model, hull.pose, *work.water, work.scratch[0], hull.options);
    }
  } else {
    loadsInParallel(work.hulls, *work.water, work.loads,
                    std::span(work.scratch).first(hulls_.size()));
  }
  const glm::dvec2 current = water_->waves().settings().current;
  if (addsInertia_) work.inertia.begin(model, data);
  for (std::size_t i = 0; i < hulls_.size(); ++i) {
    const Load total = work.loads[i].total();
    const glm::dvec3 at = work.hulls[i].pose.position;
    mj_applyFT(model, data, &total.force.x, &total.moment.x, &at.x, hulls_[i].body,
               data->qfrc_passive);
    if (addsInertia_) {
      work.inertia.add(model, data, hulls_[i].body, *hulls_[i].model, work.hulls[i].pose,
                       work.loads[i], current);
    }
    status_.fetch_or(static_cast<std::uint32_t>(work.loads[i].status), std::memory_order_relaxed);
  }
  if (addsInertia_) mj_factorM(model, data);
}

}  // namespace seaway::bridge
