#pragma once

#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>

#include "sim_bridge/mujoco/hull_coupling.h"
#include "surface/hull/analytic_hulls.h"
#include "tests/sim_bridge/mujoco/mujoco_world.h"

namespace seaway::bridge::test {

/// A body with a joint; mass and centre of gravity are in its XML too.
inline std::string world(const std::string& joint, double step, double mass,
                         const glm::dvec3& gravity, const glm::dvec3& inertia) {
  const auto number = [](double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.17g", value);
    return std::string(text);
  };
  const auto vector = [&](const glm::dvec3& v) {
    return number(v.x) + " " + number(v.y) + " " + number(v.z);
  };
  return "<mujoco><compiler boundmass='0' boundinertia='0'/><option timestep='" + number(step) +
         "' integrator='RK4' gravity='0 0 -9.80665'/><worldbody><body name='hull'>" + joint +
         "<inertial pos='" + vector(gravity) + "' mass='" + number(mass) + "' diaginertia='" +
         vector(inertia) + "'/></body></worldbody></mujoco>";
}

inline HullCoefficients ideal() {
  HullCoefficients none;
  none.formDrag = none.heaveDamping = none.rollDamping = none.pitchDamping = 0.0;
  none.skinFriction = 0.0;
  return none;
}

/// A floating hull in MuJoCo.
struct Afloat {
  Afloat(const TriangleMesh& mesh, double mass, const HullCoefficients& coefficients,
         const std::string& joint, WaveField field, double step)
      : water(std::move(field)) {
    HullSettings settings;
    settings.mass = mass;
    settings.centreOfGravity = {0.0, 0.0, -0.02};
    settings.gyradii = {0.4, 0.5, 0.5};
    settings.coefficients = coefficients;
    settings.shortestWavelength = 0.0;
    hull = std::make_shared<HullModel>(mesh, settings);
    inertia = mass * settings.gyradii * settings.gyradii;
    mujoco.emplace(world(joint, step, mass, settings.centreOfGravity, inertia));
    coupling.emplace(*mujoco->model, water);
    coupling->add("hull", hull);
  }
  double height() const { return mujoco->data->xpos[5]; }
  void step() { mj_step(mujoco->model.get(), mujoco->data.get()); }
  double time() const { return mujoco->data->time; }

  WaterSurface water;
  std::shared_ptr<HullModel> hull;
  glm::dvec3 inertia;
  std::optional<MujocoWorld> mujoco;
  std::optional<HullCoupling> coupling;
};

inline const char* const free = "<freejoint/>";
inline const char* const heaving = "<joint type='slide' axis='0 0 1'/>";
inline constexpr double length = 1.0, beam = 0.6, depth = 0.3, draft = 0.1;

inline TriangleMesh box(std::size_t triangles = 300) {
  return boxMesh(length, beam, depth, draft, triangles);
}
inline double boxMass() { return seaWaterDensity * length * beam * draft; }

/// Angular frequency by upward crossings of zero over so many seconds.
template <class Signal>
double frequencyOf(Afloat& body, double seconds, Signal signal) {
  double before = signal(), first = 0.0, last = 0.0;
  int crossings = 0;
  const double step = body.mujoco->model->opt.timestep;
  while (body.time() < seconds) {
    body.step();
    const double now = signal();
    if (before < 0.0 && now >= 0.0) {
      last = body.time() - step * now / (now - before);
      if (crossings++ == 0) first = last;
    }
    before = now;
  }
  return 2.0 * pi * (crossings - 1) / (last - first);
}

}  // namespace seaway::bridge::test
