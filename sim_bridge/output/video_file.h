#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>

#include "render/frame.h"
#include "sim_bridge/output/unfinished_files.h"

namespace seaway::bridge {

/// An MP4 that the program `ffmpeg` makes of frames that it is handed through a pipe. It appears
/// whole or not at all: written beside its path, renamed by `commit`.
class VideoFile {
 public:
  /// Starts ffmpeg. Frames are `size` pixels; ones with odd sides get a black line more, which the
  /// usual pixel format needs. Throws InputError where requireVideo does.
  VideoFile(std::filesystem::path path, glm::ivec2 size, double framesPerSecond);
  ~VideoFile();
  VideoFile(const VideoFile&) = delete;
  VideoFile& operator=(const VideoFile&) = delete;

  /// Throws std::runtime_error where ffmpeg has gone, with what it said.
  void write(const render::ColourImage& frame);
  /// Throws std::runtime_error where ffmpeg failed or nothing was written.
  void commit();

 private:
  [[noreturn]] void fail(int status);
  /// Ends the pipe and waits; what ffmpeg ended with.
  int finish();

  std::filesystem::path path_, beside_, log_;
  glm::ivec2 size_;
  std::optional<UnfinishedFile> unfinished_, unfinishedLog_;
  pid_t process_ = -1;
  int pipe_ = -1;
};

/// Throws InputError unless `path` ends in .mp4, can be written and there is a program `ffmpeg` on
/// the PATH. To be asked before the work.
void requireVideo(const std::filesystem::path& path);

}  // namespace seaway::bridge
