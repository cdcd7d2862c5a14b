// A raft under MuJoCo in a process of its own, on the sea that another process serves:
//   seaway serve configs/scenes/canaveral.yaml --shm sea & mujoco_host sea
// Water is asked under 32 columns, at every Runge-Kutta stage.
#include <mujoco/mujoco.h>

#include <algorithm>
#include <cstdio>
#include <cstring>

#include "sim_bridge/shm/seaway_shm.hpp"

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
seaway_shm_client sea;
seaway_shm_status status;

void buoyancy(const mjModel* model, mjData* data) {
  double x[columns], y[columns], bottom[columns];
  for (int i = 0; i < columns; ++i) {
    const mjtNum inBody[3] = {-0.875 + 0.25 * (i % 8), -0.375 + 0.25 * (i / 8), -draft};
    mjtNum world[3];
    mju_rotVecMat(world, inBody, data->xmat + 9);
    mju_addTo3(world, data->xpos + 3);
    x[i] = world[0], y[i] = world[1], bottom[i] = world[2];
  }
  const auto how = seaway::shm::How{.time = data->time, .shortestWavelength = 0.5}.request();
  seaway_shm_batch water{};
  if (status == SEAWAY_SHM_OK) status = seaway_shm_sample(&sea, &how, x, y, columns, &water);
  for (int i = 0; i < columns && status == SEAWAY_SHM_OK; ++i) {
    const double wet = std::clamp(water.height[i] - bottom[i], 0.0, depth);
    const mjtNum force[3] = {0.0, 0.0, 1025.0 * 9.80665 * area * wet}, none[3] = {};
    const mjtNum at[3] = {x[i], y[i], bottom[i]};
    mj_applyFT(model, data, force, none, at, 1, data->qfrc_passive);
  }
}
}  // namespace

int main(int argc, char** argv) {
  const seaway_shm_options patient{20.0, 1.0, 50e-6};  // s
  status = seaway_shm_connect(&sea, argc > 1 ? argv[1] : "sea", &patient);
  static mjVFS files;
  mj_defaultVFS(&files);
  mj_makeEmptyFileVFS(&files, "raft.xml", sizeof xml - 1);
  std::memcpy(files.filedata[0], xml, sizeof xml - 1);
  mjModel* model = mj_loadXML("raft.xml", &files, nullptr, 0);
  mjData* data = mj_makeData(model);
  mjcb_passive = buoyancy;
  for (int step = 0; step <= 1000 && status == SEAWAY_SHM_OK; ++step, mj_step(model, data)) {
    if (step % 200 == 0) std::printf("%4.1f s: raft at %+.3f m\n", data->time, data->xpos[5]);
  }
  return status == SEAWAY_SHM_OK ? 0 : (std::fprintf(stderr, "%s\n", sea.message), 1);
}
