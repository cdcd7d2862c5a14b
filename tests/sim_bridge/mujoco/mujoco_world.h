#pragma once

#include <mujoco/mujoco.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>

namespace seaway::bridge::test {

/// A MuJoCo model from its XML text, with its data.
class MujocoWorld {
 public:
  explicit MujocoWorld(const std::string& xml) {
    const auto file = std::filesystem::temp_directory_path() /
                      ("seaway_mujoco_" + std::to_string(getpid()) + ".xml");
    std::ofstream(file) << xml;
    char error[500] = "";
    model.reset(mj_loadXML(file.c_str(), nullptr, error, sizeof error));
    std::filesystem::remove(file);
    if (!model) throw std::runtime_error(error);
    data.reset(mj_makeData(model.get()));
  }

  struct Deleter {
    void operator()(mjModel* m) const { mj_deleteModel(m); }
    void operator()(mjData* d) const { mj_deleteData(d); }
  };
  std::unique_ptr<mjModel, Deleter> model;
  std::unique_ptr<mjData, Deleter> data;
};

}  // namespace seaway::bridge::test
