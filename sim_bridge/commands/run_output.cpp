#include "sim_bridge/commands/run_output.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>

#include "sim_bridge/commands/blocked_octaves_json.h"
#include "sim_bridge/commands/performance_json.h"
#include "sim_bridge/output/atomic_file.h"
#include "sim_bridge/output/process_memory.h"
#include "sim_bridge/output/telemetry.h"

namespace seaway::bridge {
namespace {

namespace fs = std::filesystem;

fs::path framesFolder(const fs::path& folder, std::size_t camera, const std::string& name) {
  return camera == 0 ? folder / "frames" : folder / "frames" / name;
}

std::string frameName(long long index, const std::string& suffix) {
  return fmt::format("{:06}{}", index, suffix);
}

// A list is a file that anyone may have written: only plain names are followed.
bool isPlainName(const std::string& name) {
  return !name.empty() && std::all_of(name.begin(), name.end(), [](unsigned char c) {
    return (c < 0x80 && std::isalnum(c)) || c == '_' || c == '-';
  });
}

bool isTelemetry(const std::string& name) {
  const fs::path path(name);
  return path.extension() == ".csv" && isPlainName(path.stem().string()) &&
         name.rfind("telemetry", 0) == 0;
}

struct EarlierRun {
  std::vector<std::string> telemetry, cameras;
  long long frames = 0;
  std::vector<std::string> also;
};

/// What a list says; nothing where it is not there or is no list of a run.
std::optional<EarlierRun> readList(const fs::path& file) {
  std::ifstream stream(file);
  const auto json = nlohmann::json::parse(stream, nullptr, false);
  try {
    return EarlierRun{json.at("telemetry"), json.at("cameras"), json.at("frames"),
                      json.value("also", std::vector<std::string>{})};
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  }
}

/// What names of a run's frames end in.
std::vector<std::string> suffixesOf(const std::vector<std::string>& also) {
  std::vector<std::string> suffixes{".png"};
  for (const FrameFileKind& kind : frameFileKinds()) {
    if (std::find(also.begin(), also.end(), kind.word) != also.end()) {
      suffixes.push_back(kind.suffix);
    }
  }
  return suffixes;
}

void removeFrames(const fs::path& folder, long long count, const std::vector<std::string>& also) {
  std::error_code ignored;
  const std::vector<std::string> suffixes = suffixesOf(also);
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder, ignored)) {
    const std::string stem = entry.path().stem().string();
    long long index = -1;
    std::from_chars(stem.data(), stem.data() + stem.size(), index);
    const bool listed = index >= 0 && index < count &&
                        std::any_of(suffixes.begin(), suffixes.end(), [&](const auto& suffix) {
                          return entry.path().filename() == frameName(index, suffix);
                        });
    if (listed && entry.is_regular_file(ignored)) files.push_back(entry.path());
  }
  for (const fs::path& file : files) fs::remove(file);
}

void removeEarlierRun(const fs::path& folder, const fs::path& list) {
  const std::optional<EarlierRun> earlier = readList(list);
  if (earlier) {
    for (const std::string& name : earlier->telemetry) {
      if (isTelemetry(name)) fs::remove(folder / name);
    }
    // The first camera's folder holds the others': it goes last.
    for (std::size_t i = earlier->cameras.size(); i-- > 0;) {
      if (!isPlainName(earlier->cameras[i])) continue;
      const fs::path frames = framesFolder(folder, i, earlier->cameras[i]);
      removeFrames(frames, earlier->frames, earlier->also);
      std::error_code notEmpty;
      fs::remove(frames, notEmpty);
    }
  }
  fs::remove(list);
}

nlohmann::ordered_json filesOf(const Scene& scene, long long frames,
                               const std::vector<std::string>& also) {
  nlohmann::ordered_json cameras = nlohmann::ordered_json::array();
  for (const SceneCamera& camera : scene.cameras) cameras.push_back(camera.name);
  nlohmann::ordered_json files{
      {"telemetry", telemetryFiles(scene)}, {"cameras", cameras}, {"frames", frames}};
  if (!also.empty()) files["also"] = also;
  return files;
}

}  // namespace

void StepTimes::add(double microseconds) {
  const double bin = std::log(std::max(microseconds, shortest) / shortest) / width;
  ++counts_[std::min(static_cast<std::size_t>(bin), counts_.size() - 1)];
}

double StepTimes::percentile(double share) const {
  const std::uint64_t all = std::accumulate(counts_.begin(), counts_.end(), std::uint64_t{0});
  const double wanted = share * static_cast<double>(all);
  std::uint64_t below = 0;
  for (std::size_t i = 0; all > 0 && i < counts_.size(); ++i) {
    below += counts_[i];
    if (below > 0 && static_cast<double>(below) >= wanted) {
      return shortest * std::exp(width * static_cast<double>(i + 1));
    }
  }
  return 0.0;
}

RunFolder::RunFolder(fs::path folder, const Scene& scene, long long frames,
                     std::vector<std::string> also)
    : folder_(std::move(folder)), also_(std::move(also)) {
  for (const SceneCamera& camera : scene.cameras) cameras_.push_back(camera.name);
  requireWritableFolder(folder_);
  requireWritableFile(summary());
  removeEarlierRun(folder_, summary());
  removeEarlierRun(folder_, unfinished());
  if (frames > 0) {
    for (std::size_t i = 0; i < cameras_.size(); ++i) requireWritableFolder(this->frames(i));
  }
  AtomicFile list(unfinished());
  list.stream() << filesOf(scene, frames, also_).dump() << '\n';
  list.commit();
}

fs::path RunFolder::frames(std::size_t camera) const {
  return framesFolder(folder_, camera, cameras_[camera]);
}

fs::path RunFolder::frame(std::size_t camera, long long index) const {
  return frames(camera) / frameName(index, ".png");
}

FrameFiles RunFolder::files(std::size_t camera, long long index) const {
  FrameFiles files;
  for (const std::string& word : also_) {
    const FrameFileKind& kind = frameFileKind(word);
    files.*kind.path = frames(camera) / frameName(index, kind.suffix);
  }
  return files;
}

void RunFolder::finish(const std::string& text) const {
  AtomicFile file(summary());
  file.stream() << text;
  file.commit();
  fs::remove(unfinished());
}

std::string RunSummary::json(const Scene& scene) const {
  nlohmann::ordered_json summary{{"scene", scene.file.string()},
                                 {"seed", scene.sea.seed},
                                 {"sea",
                                  {{"hm0_asked_m", hm0Asked},
                                   {"hm0_realised_m", hm0Realised},
                                   {"blocked_octaves", asJson(blocked)}}},
                                 {"duration_s", scene.run.duration},
                                 {"step_s", scene.run.step},
                                 {"steps", steps},
                                 {"fps", scene.run.framesPerSecond},
                                 {"size", {scene.run.size.x, scene.run.size.y}}};
  summary.update(filesOf(scene, frames, also));
  summary.update({{"technique", lastFrame.technique},
                  {"backend", lastFrame.backend},
                  {"renderer", lastFrame.renderer},
                  {"real_time_factor", wallSeconds > 0.0 ? simulated(scene) / wallSeconds : 0.0},
                  {"wall_s", wallSeconds},
                  {"timings_ms", timingsMs},
                  {"passes_ms", passesMs}});
  if (resumedFrom) summary["resumed_from_s"] = *resumedFrom;
  summary["step_us"] = {{"p50", stepTimes.percentile(0.5)},
                        {"p99", stepTimes.percentile(0.99)},
                        {"most", stepTimes.percentile(1.0)}};
  summary["peak_memory_bytes"] = processMemory({"VmHWM"});
  if (scene.tuned.any()) {
    summary["tuned"] = {{"foreseen", performanceJson(scene.tuned)},
                        {"achieved", performanceJson(achieved)}};
  }
  return summary.dump(2) + "\n";
}

}  // namespace seaway::bridge
