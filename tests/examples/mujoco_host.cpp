// A raft under MuJoCo in a process of its own, on the sea that another process serves:
//   seaway serve configs/scenes/canaveral.yaml --shm sea & mujoco_host sea
// The water under its 32 columns is asked at the time of every Runge-Kutta stage.
#include "sim_bridge/shm/seaway_shm.hpp"
// Seaway's header before the system's.
#include <mujoco/mujoco.h>

#include <algorithm>
#include <cstdio>
#include <cstring>

namespace {

constexpr char xml[] = R"(<mujoco>
  <option timestep="0.01" integrator="RK4" gravity="0 0 -9.80665"/>
  <worldbody><body name="raft">
    <joint type="slide" axis="0 0 1" damping="900"/>
    <joint type="hinge" axis="1 0 0" damping="150"/><joint type="hinge" axis="0 1 0" damping="300"/>
    <inertial pos="0 0 -0.05" mass="300" diaginertia="40 90 110"/>
  </body></worldbody></mujoco>)";

constexpr int columns = 32;
constexpr double area = 2.0 * 1.0 / columns, depth = 0.4, draft = 0.15;  // m2, m
seaway::shm::Client* sea = nullptr;

void buoyancy(const mjModel* model, mjData* data) {
  double x[columns], y[columns], bottom[columns];
  for (int i = 0; i < columns; ++i) {
    const mjtNum inBody[3] = {-0.875 + 0.25 * (i % 8), -0.375 + 0.25 * (i / 8), -draft};
    mjtNum world[3];
    mju_rotVecMat(world, inBody, data->xmat + 9);
    mju_addTo3(world, data->xpos + 3);
    x[i] = world[0], y[i] = world[1], bottom[i] = world[2];
  }
  const auto water = sea->sample(x, y, {.time = data->time, .shortestWavelength = 0.5});
  for (int i = 0; i < columns; ++i) {
    const double wet = std::clamp(water.height[i] - bottom[i], 0.0, depth);
    const mjtNum force[3] = {0.0, 0.0, 1025.0 * 9.80665 * area * wet}, none[3] = {};
    const mjtNum at[3] = {x[i], y[i], bottom[i]};
    mj_applyFT(model, data, force, none, at, 1, data->qfrc_passive);
  }
}

}  // namespace

int main(int argc, char** argv) try {
  seaway::shm::Client client(argc > 1 ? argv[1] : "sea", {20.0, 1.0, 50e-6});  // s
  sea = &client;
  static mjVFS files;
  mj_defaultVFS(&files);
  mj_makeEmptyFileVFS(&files, "raft.xml", sizeof xml - 1);
  std::memcpy(files.filedata[0], xml, sizeof xml - 1);
  mjModel* model = mj_loadXML("raft.xml", &files, nullptr, 0);
  mjData* data = mj_makeData(model);
  mjcb_passive = buoyancy;
  for (int step = 0; step <= 1000; ++step, mj_step(model, data)) {
    if (step % 200 == 0) std::printf("%4.1f s: raft at %+.3f m\n", data->time, data->xpos[5]);
  }
  return mj_deleteData(data), mj_deleteModel(model), 0;
} catch (const seaway::shm::Error& fault) {
  return std::fprintf(stderr, "%s\n", fault.what()), 1;
}
