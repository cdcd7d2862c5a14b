#include "sim_bridge/mujoco/added_inertia.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace seaway::bridge {
namespace {

/// Last degree of freedom that moves a body; −1: it is fixed to the world.
int lastDof(const mjModel* model, int body) {
  while (body > 0 && model->body_dofnum[body] == 0) body = model->body_parentid[body];
  return body > 0 ? model->body_dofadr[body] + model->body_dofnum[body] - 1 : -1;
}

/// Acceleration that velocities alone give a point of a body: J̇q̇, linear and angular.
struct BiasAcceleration {
  glm::dvec3 linear{0.0}, angular{0.0};

  BiasAcceleration(const mjModel* model, const mjData* data, int body, const glm::dvec3& point,
                   const glm::dvec3& velocity, const glm::dvec3& turning) {
    for (int i = lastDof(model, body); i >= 0; i = model->dof_parentid[i]) {
      const mjtNum* rate = data->cdof_dot + 6 * i;
      angular += data->qvel[i] * glm::dvec3(rate[0], rate[1], rate[2]);
      linear += data->qvel[i] * glm::dvec3(rate[3], rate[4], rate[5]);
    }
    // Spatial acceleration about the tree's centre of mass, to the point's own.
    const mjtNum* centre = data->subtree_com + 3 * model->body_rootid[body];
    const glm::dvec3 arm = point - glm::dvec3(centre[0], centre[1], centre[2]);
    linear += glm::cross(angular, arm) + glm::cross(turning, velocity);
  }
};

}  // namespace

void AddedInertia::begin(const mjModel* model, mjData* data) {
  linear_.resize(3 * static_cast<std::size_t>(model->nv));
  angular_.resize(linear_.size());
  mj_crb(model, data);
}

void AddedInertia::add(const mjModel* model, mjData* data, int body, const HullModel& hull,
                       const HullPose& pose, const HullLoads& loads, glm::dvec2 current) {
  const auto& a = loads.addedMass;
  const glm::dvec3 mass(a[0], a[1], a[2]), inertia(a[3], a[4], a[5]);
  if (!(glm::dot(mass, mass) + glm::dot(inertia, inertia) > 0.0)) return;
  const glm::dmat3 worldFromBody = glm::mat3_cast(pose.worldFromBody);
  const glm::dmat3 bodyFromWorld = glm::transpose(worldFromBody);
  const glm::dvec3 arm = worldFromBody * hull.settings().centreOfGravity;
  const glm::dvec3 point = pose.position + arm;
  const glm::dvec3 velocity = pose.velocity + glm::cross(pose.angularVelocity, arm);
  mj_jac(model, data, linear_.data(), angular_.data(), &point.x, body);
  const auto column = [&](const std::vector<mjtNum>& jacobian, int dof) {
    const mjtNum* first = jacobian.data() + dof;
    return bodyFromWorld * glm::dvec3(first[0], first[model->nv], first[2 * model->nv]);
  };
  for (int i = lastDof(model, body); i >= 0; i = model->dof_parentid[i]) {
    const glm::dvec3 moved = mass * column(linear_, i), turned = inertia * column(angular_, i);
    mjtNum* entry = data->qM + model->dof_Madr[i];
    for (int j = i; j >= 0; j = model->dof_parentid[j]) {
      *entry++ += glm::dot(moved, column(linear_, j)) + glm::dot(turned, column(angular_, j));
    }
  }
  const BiasAcceleration bias(model, data, body, point, velocity, pose.angularVelocity);
  const glm::dvec3 u = bodyFromWorld * (velocity - glm::dvec3(current, 0.0));
  const glm::dvec3 w = bodyFromWorld * pose.angularVelocity;
  const glm::dvec3 force =
      mass * (bodyFromWorld * (loads.waterAcceleration - bias.linear) + glm::cross(w, u)) -
      glm::cross(w, mass * u);
  const glm::dvec3 moment = -inertia * (bodyFromWorld * bias.angular) - glm::cross(w, inertia * w) -
                            glm::cross(u, mass * u);
  const glm::dvec3 worldForce = worldFromBody * force, worldMoment = worldFromBody * moment;
  mj_applyFT(model, data, &worldForce.x, &worldMoment.x, &point.x, body, data->qfrc_passive);
}

}  // namespace seaway::bridge
