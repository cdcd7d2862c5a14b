#pragma once

#include <mujoco/mujoco.h>

#include <glm/vec2.hpp>
#include <vector>

#include "surface/hull/hull_loads.h"

namespace seaway::bridge {

/// Added mass of hulls in MuJoCo's inertia, within its passive callback.
///
/// With A diagonal in the body's axes about the centre of gravity and J that point's Jacobian, M
/// becomes M + JᵀAJ: what accelerates the body accelerates the water with it, whatever joints the
/// body hangs on. To the forces come those of Kirchhoff's equations that do not depend on
/// acceleration, as in HullVessel (Fossen 2011, 6.1). MuJoCo makes M anew at every evaluation of
/// positions; begin() does so too, so that evaluations that skip positions count A once.
class AddedInertia {
 public:
  /// Makes M of the bodies alone again.
  void begin(const mjModel* model, mjData* data);

  /// Adds one hull's. The caller factorises (mj_factorM) when all are there.
  void add(const mjModel* model, mjData* data, int body, const HullModel& hull,
           const HullPose& pose, const HullLoads& loads, glm::dvec2 current);

 private:
  std::vector<mjtNum> linear_, angular_;  // Jacobians, 3 × nv
};

}  // namespace seaway::bridge
