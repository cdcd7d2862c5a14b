#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "render/frame.h"
#include "sim_bridge/scene/scene.h"

namespace seaway::bridge {

/// Where the files of one `seaway run` go.
class RunFolder {
 public:
  /// Makes the folders and throws InputError unless they can be written to; removes the summary and
  /// the frames that an earlier run left there.
  RunFolder(std::filesystem::path folder, const Scene& scene);

  const std::filesystem::path& path() const { return folder_; }
  std::filesystem::path frame(std::size_t camera, long long index) const;
  std::filesystem::path summary() const { return folder_ / "summary.json"; }

 private:
  std::filesystem::path frames(std::size_t camera) const;

  std::filesystem::path folder_;
  std::vector<std::string> cameras_;
};

/// What a run did, for summary.json.
struct RunSummary {
  double hm0Asked = 0.0;     ///< m
  double hm0Realised = 0.0;  ///< m
  long long frames = 0;      ///< of each camera
  long long steps = 0;
  double wallSeconds = 0.0;
  std::map<std::string, double> timingsMs;  ///< totals by stage
  std::map<std::string, double> passesMs;   ///< totals of the technique's passes
  render::FrameStats lastFrame;

  std::string json(const Scene& scene) const;
};

}  // namespace seaway::bridge
