#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "render/frame.h"
#include "sim_bridge/output/frame_files.h"
#include "sim_bridge/scene/scene.h"
#include "surface/field/blocked_octaves.h"

namespace seaway::bridge {

/// Where the files of one `seaway run` go.
///
/// `summary.json` lists what a run wrote: `telemetry` by name, and of each of `cameras` as many
/// `frames`, numbered from 0, each with the kinds of files in `also`. Until it is there the same
/// list stands in `summary.json.unfinished`, so that a run that was cut off is cleared away as
/// well.
class RunFolder {
 public:
  /// Makes the folders and throws InputError unless they can be written to; then removes the
  /// summary that an earlier run left there and exactly the files that it lists, with folders of
  /// cameras that this empties; and leaves the list of the files that are to come: `frames` of each
  /// camera.
  RunFolder(std::filesystem::path folder, const Scene& scene, long long frames,
            std::vector<std::string> also = {});

  const std::filesystem::path& path() const { return folder_; }
  std::filesystem::path frame(std::size_t camera, long long index) const;

  /// What else is written of that frame: a file for each word of `also` (frameFileKinds).
  FrameFiles files(std::size_t camera, long long index) const;
  const std::vector<std::string>& also() const { return also_; }

  /// Makes the summary appear: the run is whole.
  void finish(const std::string& summary) const;

 private:
  std::filesystem::path summary() const { return folder_ / "summary.json"; }
  std::filesystem::path unfinished() const { return folder_ / "summary.json.unfinished"; }
  std::filesystem::path frames(std::size_t camera) const;

  std::filesystem::path folder_;
  std::vector<std::string> cameras_, also_;
};

/// How long steps took, counted in classes 2 % wide: of a fixed size for any number of steps.
class StepTimes {
 public:
  void add(double microseconds);
  /// The time that `share` of the steps took at most, within 2 %; 0 without steps.
  double percentile(double share) const;

 private:
  static constexpr double shortest = 0.1, width = 0.02;  // µs; of a class, in the logarithm
  std::array<std::uint64_t, 1200> counts_{};
};

/// What a run did, for summary.json.
struct RunSummary {
  double hm0Asked = 0.0;               ///< m
  double hm0Realised = 0.0;            ///< m
  std::vector<BlockedOctave> blocked;  ///< octaves that the current stops
  long long frames = 0;                ///< of each camera
  long long steps = 0;
  double wallSeconds = 0.0;
  std::map<std::string, double> timingsMs;  ///< totals by stage
  std::map<std::string, double> passesMs;   ///< totals of the technique's passes
  render::FrameStats lastFrame;
  StepTimes stepTimes;
  double stepMs = 0.0;                ///< of all steps, without what is written
  StepTimes frameTimes;               ///< of frames after each camera's first
  std::optional<double> resumedFrom;  ///< time of the checkpoint, s
  long long framesDrawn = 0;          ///< of each camera by this run: without those before that
  Performance achieved;               ///< what of the scene's `tuned` was measured
  std::vector<std::string> also;      ///< what else was written of each frame

  /// How much of the scene this run went through, s.
  double simulated(const Scene& scene) const {
    return scene.run.duration - resumedFrom.value_or(0.0);
  }

  std::string json(const Scene& scene) const;
};

}  // namespace seaway::bridge
