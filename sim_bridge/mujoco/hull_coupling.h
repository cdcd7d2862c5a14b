#pragma once

#include <mujoco/mujoco.h>

#include <atomic>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <string>
#include <vector>

#include "surface/hull/hull_loads.h"
#include "surface/water_surface.h"

namespace seaway::bridge {

/// Seaway's loads as passive forces of a MuJoCo model (2.2.2).
///
/// MuJoCo's world is the sea plane: x east, y north, z up, m, z = 0 the still-water level; a body's
/// frame is its hull's. Loads are taken at mjData::time, so every sub-stage of the RK4 integrator
/// sees the sea of its own instant. They depend on the state alone: mj_forward, mj_step and finite
/// differences of MuJoCo agree. Added mass goes into MuJoCo's matrix of inertia (AddedInertia), so
/// that accelerations are solved for with it, at any size: constraint solvers Newton and CG see it
/// too, PGS takes the bodies' own.
///
/// Set the model's gravity to −9.80665 (standardGravity): with MuJoCo's own 9.81 hulls float
/// 0.03 % deeper. Several mjData of one model may step at once, each on its own thread.
class HullCoupling {
 public:
  /// Makes the coupling of `model`, which is looked up by its address, until it is destroyed:
  /// afterwards mj_step and its like call it. `model` and `water` must outlive it. Throws
  /// std::logic_error for a model that has one, or where another passive callback is installed.
  HullCoupling(const mjModel& model, const WaterSurface& water);
  ~HullCoupling();
  HullCoupling(const HullCoupling&) = delete;
  HullCoupling& operator=(const HullCoupling&) = delete;

  /// Floats the body of a name. `origin` is where the hull's frame lies in the body's, m, axes
  /// alike. Not while the model steps. Throws InputError for a body that is not in the model.
  void add(const std::string& body, std::shared_ptr<const HullModel> hull,
           const LoadOptions& options = {}, const glm::dvec3& origin = glm::dvec3(0.0));

  /// With this many hulls or more their loads are worked out by several threads (oneTBB).
  static constexpr std::size_t parallelFrom = 8;

  std::size_t hullCount() const { return hulls_.size(); }

  /// All that loads have told since the last call.
  SampleStatus takeStatus() {
    return static_cast<SampleStatus>(status_.exchange(0, std::memory_order_relaxed));
  }

 private:
  struct Hull {
    int body;
    std::shared_ptr<const HullModel> model;
    LoadOptions options;
    glm::dvec3 origin;
  };
  static void passive(const mjModel* model, mjData* data);
  void apply(const mjModel* model, mjData* data);

  const mjModel* model_;
  const WaterSurface* water_;
  std::vector<Hull> hulls_;
  bool addsInertia_ = false;  // a hull has added mass
  std::atomic<std::uint32_t> status_{0};
};

}  // namespace seaway::bridge
