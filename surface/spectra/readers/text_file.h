#pragma once

#include <filesystem>
#include <string>

namespace seaway {

/// A whole file in memory.
struct TextFile {
  std::string name;  ///< as messages give it
  std::string text;
};

/// Reads a file whole. Throws InputError for one that cannot be read, or is no file but a folder or
/// a device.
TextFile readTextFile(const std::filesystem::path& path);

}  // namespace seaway
