#include "sim_bridge/output/atomic_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

#include "surface/input_error.h"

namespace seaway::bridge {

namespace {

/// What a link points to; the path itself where it is none.
std::filesystem::path linkTarget(const std::filesystem::path& path) {
  std::error_code fault;
  const auto target = std::filesystem::canonical(path, fault);
  return fault ? path : target;
}

}  // namespace

AtomicFile::AtomicFile(std::filesystem::path path) : path_(linkTarget(path)), beside_(path_) {
  beside_ += ".part" + std::to_string(getpid());
  std::error_code ignored;
  if (path.empty()) throw InputError("a file name is wanted to write to; it is empty");
  if (path_.filename().empty() || std::filesystem::is_directory(path_, ignored)) {
    throw InputError(path_.string(), 0, "cannot be written: is a folder");
  }
  const bool other =
      std::filesystem::exists(path_, ignored) && !std::filesystem::is_regular_file(path_, ignored);
  if (other) throw InputError(path_.string(), 0, "cannot be written: is not a regular file");
  unfinished_.emplace(beside_);
  errno = 0;
  stream_.open(beside_, std::ios::binary | std::ios::trunc);
  if (!stream_) {
    throw InputError(path_.string(), 0, std::string("cannot be written: ") + std::strerror(errno));
  }
}

AtomicFile::~AtomicFile() {
  if (beside_.empty()) return;
  stream_.close();
  std::error_code ignored;
  std::filesystem::remove(beside_, ignored);
}

void AtomicFile::commit() {
  stream_.close();
  if (!stream_) throw std::runtime_error(path_.string() + ": writing failed (disk full?)");
  std::filesystem::rename(beside_, path_);
  unfinished_.reset();
  beside_.clear();
}

void requireWritableFile(const std::filesystem::path& path) { AtomicFile probe(path); }

void requireWritableFolder(const std::filesystem::path& folder) {
  std::error_code fault;
  std::filesystem::create_directories(folder, fault);
  if (fault || !std::filesystem::is_directory(folder)) {
    throw InputError(folder.string(), 0,
                     "folder cannot be made: " + (fault ? fault.message() : "is a file"));
  }
  requireWritableFile(folder / "probe");
}

}  // namespace seaway::bridge
