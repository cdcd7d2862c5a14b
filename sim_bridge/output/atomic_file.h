#pragma once

#include <filesystem>
#include <fstream>
#include <optional>

#include "sim_bridge/output/unfinished_files.h"

namespace seaway::bridge {

/// A file that appears whole or not at all: written beside its path, renamed by `commit`.
/// Without `commit` nothing is left behind, nor when a signal ends the command.
class AtomicFile {
 public:
  /// Throws InputError where nothing can be written at `path`.
  explicit AtomicFile(std::filesystem::path path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  std::ostream& stream() { return stream_; }
  /// Where what was written so far stands until `commit`.
  const std::filesystem::path& beside() const { return beside_; }

  /// Throws std::runtime_error where writing or renaming failed (a full disk, say).
  void commit();

 private:
  std::filesystem::path path_;
  std::filesystem::path beside_;
  std::optional<UnfinishedFile> unfinished_;
  std::ofstream stream_;
};

/// Throws InputError unless a file could be written at `path`; leaves nothing behind. To be asked
/// before work whose result goes there.
void requireWritableFile(const std::filesystem::path& path);

/// Makes `folder`, with its parents, and throws InputError unless files can be written in it.
void requireWritableFolder(const std::filesystem::path& folder);

}  // namespace seaway::bridge
