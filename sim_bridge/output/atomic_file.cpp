#include "sim_bridge/output/atomic_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

#include "surface/input_error.h"

namespace seaway::bridge {

AtomicFile::AtomicFile(std::filesystem::path path) : path_(std::move(path)), beside_(path_) {
  beside_ += ".part" + std::to_string(getpid());
  std::error_code ignored;
  if (path_.filename().empty() || std::filesystem::is_directory(path_, ignored)) {
    throw InputError(path_.string(), 0, "cannot be written: is a folder");
  }
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
