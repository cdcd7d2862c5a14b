#pragma once

#include <cstdint>
#include <filesystem>

namespace seaway::bridge {

/// The beginning of a text that is kept in a file, which may go on beyond it.
struct KeptText {
  std::uint64_t bytes = 0;
  std::uint32_t checksum = 0;  ///< CRC-32

  template <class Archive>
  void serialize(Archive& archive) {
    archive(bytes, checksum);
  }
};

/// Appends to `kept`, of which `known` is there, what `text` has beyond that, and returns what is
/// there then. Whatever else stood in `kept` goes. Whoever holds an earlier KeptText can read it at
/// any time, however this ends. Throws std::runtime_error where it cannot be written.
KeptText keepText(const std::filesystem::path& text, const std::filesystem::path& kept,
                  const KeptText& known);

/// Writes the beginning that `wanted` describes to `to`. Throws InputError, naming `kept`, where
/// that is missing or does not begin so.
void copyKept(const std::filesystem::path& kept, const KeptText& wanted, std::ostream& to);

}  // namespace seaway::bridge
