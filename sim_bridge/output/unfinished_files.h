#pragma once

#include <filesystem>

namespace seaway::bridge {

/// A file being written, to be removed should a signal end the program before it is whole; a name
/// longer than 4095 bytes, or the 65th at a time, is not looked after. Thread-safe.
class UnfinishedFile {
 public:
  explicit UnfinishedFile(const std::filesystem::path& path);
  ~UnfinishedFile();
  UnfinishedFile(const UnfinishedFile&) = delete;
  UnfinishedFile& operator=(const UnfinishedFile&) = delete;

 private:
  int slot_;
};

/// From now on SIGINT, SIGTERM and SIGHUP remove all unfinished files and end the program at once
/// with status 128 + signal (130, 143, 129). Signals that whoever started it has switched off stay
/// off. For a command, not for a library: it replaces handlers.
void removeUnfinishedFilesOnSignals();

}  // namespace seaway::bridge
