#include "sim_bridge/output/video_file.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "sim_bridge/output/atomic_file.h"
#include "sim_bridge/output/number_text.h"
#include "surface/input_error.h"

extern char** environ;

namespace seaway::bridge {
namespace {

bool isOnPath(const std::string& program) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');) {
    if (access((folder + "/" + program).c_str(), X_OK) == 0) return true;
  }
  return false;
}

/// A write to a program that has gone is an error to be told of, not the end of this one.
class WithoutBrokenPipes {
 public:
  WithoutBrokenPipes() {
    struct sigaction ignore {};
    ignore.sa_handler = SIG_IGN;
    sigaction(SIGPIPE, &ignore, &before_);
  }
  ~WithoutBrokenPipes() { sigaction(SIGPIPE, &before_, nullptr); }

 private:
  struct sigaction before_ {};
};

pid_t start(const std::vector<std::string>& words, int input, const std::filesystem::path& log) {
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, log.c_str(),
                                   O_WRONLY | O_CREAT | O_TRUNC, 0600);
  pid_t process = -1;
  const int fault =
      posix_spawnp(&process, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (fault != 0) throw std::runtime_error(std::string("ffmpeg: ") + std::strerror(fault));
  return process;
}

}  // namespace

void requireVideo(const std::filesystem::path& path) {
  if (path.extension() != ".mp4") {
    throw InputError("--video: '" + path.string() + "' is not allowed; the name must end in .mp4");
  }
  requireWritableFile(path);
  if (!isOnPath("ffmpeg")) {
    throw InputError(
        "--video: the program ffmpeg is not on the PATH (Debian: apt-get install ffmpeg)");
  }
}

VideoFile::VideoFile(std::filesystem::path path, glm::ivec2 size, double framesPerSecond)
    : path_(std::move(path)), beside_(path_), log_(path_), size_(size) {
  requireVideo(path_);
  beside_ += ".part" + std::to_string(getpid()) + ".mp4";
  log_ += ".log" + std::to_string(getpid());
  unfinished_.emplace(beside_);
  unfinishedLog_.emplace(log_);
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error(std::strerror(errno));
  const std::string frame = std::to_string(size.x) + "x" + std::to_string(size.y);
  try {
    process_ = start({"ffmpeg",
                      "-y",
                      "-loglevel",
                      "error",
                      "-f",
                      "rawvideo",
                      "-pix_fmt",
                      "rgb24",
                      "-s",
                      frame,
                      "-r",
                      numberText(framesPerSecond),
                      "-i",
                      "-",
                      "-an",
                      "-vf",
                      "pad=ceil(iw/2)*2:ceil(ih/2)*2",
                      "-pix_fmt",
                      "yuv420p",
                      beside_.string()},
                     ends[0], log_);
  } catch (...) {
    close(ends[0]);
    close(ends[1]);
    throw;
  }
  close(ends[0]);
  pipe_ = ends[1];
}

VideoFile::~VideoFile() {
  if (process_ > 0) {
    kill(process_, SIGTERM);
    finish();
  }
  std::error_code ignored;
  if (!beside_.empty()) std::filesystem::remove(beside_, ignored);
  std::filesystem::remove(log_, ignored);
}

int VideoFile::finish() {
  if (pipe_ >= 0) close(pipe_);
  pipe_ = -1;
  int status = 0;
  while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
  return status;
}

/// Ends in what ffmpeg wrote to its log, or else how it ended.
void VideoFile::fail(int status) {
  std::ifstream log(log_);
  std::string said, line;
  while (std::getline(log, line)) said += (said.empty() ? "" : "; ") + line;
  if (said.empty()) {
    said = WIFSIGNALED(status) ? "was ended by signal " + std::to_string(WTERMSIG(status))
                               : "ended with status " + std::to_string(WEXITSTATUS(status));
  }
  throw std::runtime_error(path_.string() + ": cannot be written: ffmpeg " + said);
}

void VideoFile::write(const render::ColourImage& frame) {
  if (frame.size != size_) throw std::runtime_error("video: a frame of another size");
  const WithoutBrokenPipes quiet;
  const std::uint8_t* from = frame.rgb.data();
  std::size_t left = frame.rgb.size();
  while (left > 0) {
    const ssize_t written = ::write(pipe_, from, left);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(finish());
    from += written;
    left -= static_cast<std::size_t>(written);
  }
}

void VideoFile::commit() {
  const int status = finish();
  std::error_code fault;
  const bool isThere = std::filesystem::file_size(beside_, fault) > 0 && !fault;
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || !isThere) fail(status);
  std::filesystem::rename(beside_, path_);
  beside_.clear();
  unfinished_.reset();
}

}  // namespace seaway::bridge
