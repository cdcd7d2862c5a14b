#include "sim_bridge/commands/run_output.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "sim_bridge/output/atomic_file.h"

namespace seaway::bridge {
namespace {

namespace fs = std::filesystem;

// Only what a run writes: six digits or more, and the ending.
bool isFrame(const fs::path& file) {
  const std::string name = file.stem().string();
  return file.extension() == ".png" && name.size() >= 6 &&
         std::all_of(name.begin(), name.end(), [](char c) { return c >= '0' && c <= '9'; });
}

void removeFrames(const fs::path& folder) {
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.is_regular_file() && isFrame(entry.path())) fs::remove(entry.path());
  }
}

}  // namespace

RunFolder::RunFolder(fs::path folder, const Scene& scene) : folder_(std::move(folder)) {
  for (const SceneCamera& camera : scene.cameras) cameras_.push_back(camera.name);
  requireWritableFolder(folder_);
  requireWritableFile(summary());
  fs::remove(summary());
  if (scene.run.framesPerSecond == 0.0) return;
  for (std::size_t camera = 0; camera < cameras_.size(); ++camera) {
    requireWritableFolder(frames(camera));
    removeFrames(frames(camera));
  }
}

fs::path RunFolder::frames(std::size_t camera) const {
  return camera == 0 ? folder_ / "frames" : folder_ / "frames" / cameras_[camera];
}

fs::path RunFolder::frame(std::size_t camera, long long index) const {
  return frames(camera) / fmt::format("{:06}.png", index);
}

std::string RunSummary::json(const Scene& scene) const {
  nlohmann::ordered_json cameras = nlohmann::ordered_json::array();
  for (const SceneCamera& camera : scene.cameras) cameras.push_back(camera.name);
  const nlohmann::ordered_json summary{
      {"scene", scene.file.string()},
      {"seed", scene.sea.seed},
      {"sea", {{"hm0_asked_m", hm0Asked}, {"hm0_realised_m", hm0Realised}}},
      {"duration_s", scene.run.duration},
      {"step_s", scene.run.step},
      {"steps", steps},
      {"fps", scene.run.framesPerSecond},
      {"size", {scene.run.size.x, scene.run.size.y}},
      {"cameras", cameras},
      {"frames", frames},
      {"technique", lastFrame.technique},
      {"backend", lastFrame.backend},
      {"renderer", lastFrame.renderer},
      {"real_time_factor", wallSeconds > 0.0 ? scene.run.duration / wallSeconds : 0.0},
      {"wall_s", wallSeconds},
      {"timings_ms", timingsMs},
      {"passes_ms", passesMs}};
  return summary.dump(2) + "\n";
}

}  // namespace seaway::bridge
