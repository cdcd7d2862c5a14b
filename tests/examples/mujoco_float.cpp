// A box that MuJoCo moves on Seaway's waves: the coupling in one page.
#include <cstdio>
#include <cstring>

#include "sim_bridge/mujoco/hull_coupling.h"
#include "surface/hull/analytic_hulls.h"

namespace {

const char* const xml = R"(<mujoco>
  <option timestep="0.01" integrator="RK4" gravity="0 0 -9.80665"/>
  <worldbody><body name="raft">
    <freejoint/>
    <inertial pos="0 0 -0.05" mass="300" diaginertia="40 90 110"/>
  </body></worldbody>
</mujoco>)";

mjModel* modelFrom(const char* text) {
  static mjVFS files;
  mj_defaultVFS(&files);
  const int size = static_cast<int>(std::strlen(text));
  mj_makeEmptyFileVFS(&files, "raft.xml", size);
  std::memcpy(files.filedata[mj_findFileVFS(&files, "raft.xml")], text, std::strlen(text));
  char error[300] = "";
  mjModel* model = mj_loadXML("raft.xml", &files, error, sizeof error);
  mj_deleteVFS(&files);
  if (!model) std::fprintf(stderr, "%s\n", error);
  return model;
}

}  // namespace

int main() {
  using namespace seaway;
  mjModel* model = modelFrom(xml);
  if (!model) return 1;
  mjData* data = mj_makeData(model);
  const WaterSurface water(WaveField({makeRegularWave(0.3, 0.15, 0.0)}));
  HullSettings settings;
  settings.mass = 300.0;
  settings.centreOfGravity = {0.0, 0.0, -0.05};
  const auto raft = std::make_shared<HullModel>(boxMesh(2.0, 1.0, 0.4, 0.2), settings);
  bridge::HullCoupling coupling(*model, water);
  coupling.add("raft", raft);
  for (int step = 0; step <= 1000; ++step) {
    if (step % 200 == 0) {
      const double surface = water.sample({data->xpos[3], data->xpos[4]}, data->time).height;
      std::printf("%4.1f s: raft at %+.3f m, water there at %+.3f m\n", data->time, data->xpos[5],
                  surface);
    }
    mj_step(model, data);
  }
  mj_deleteData(data);
  mj_deleteModel(model);
}
