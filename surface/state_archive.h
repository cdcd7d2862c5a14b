#pragma once

#include <cereal/archives/binary.hpp>
#include <cstdint>
#include <deque>
#include <optional>
#include <type_traits>
#include <vector>

#include "surface/input_error.h"

/// How the state of what moves is written down and read back, bit for bit, on one machine: classes
/// have `template <class Archive> void archive(Archive&)`, which writes with a StateWriter and
/// reads with a StateReader into an object made by the same settings.
namespace seaway {

using StateWriter = cereal::BinaryOutputArchive;
using StateReader = cereal::BinaryInputArchive;

template <class Archive>
inline constexpr bool isReader = std::is_same_v<Archive, StateReader>;

/// A value without pointers in it.
template <class Archive, class T>
requires std::is_trivially_copyable_v<T>
void archivePlain(Archive& archive, T& value) { archive(cereal::binary_data(&value, sizeof(T))); }

/// A row of such values; one that is read may have at most `most`.
template <class Archive, class Row>
void archiveRow(Archive& archive, Row& row, std::uint64_t most = std::uint64_t{1} << 28) {
  std::uint64_t count = row.size();
  archivePlain(archive, count);
  if (count > most) throw InputError("a checkpoint is damaged: a row is too long");
  if constexpr (isReader<Archive>) row.resize(static_cast<std::size_t>(count));
  for (auto& value : row) archivePlain(archive, value);
}

/// The same, all at once.
template <class Archive, class T>
void archiveRow(Archive& archive, std::vector<T>& row,
                std::uint64_t most = std::uint64_t{1} << 28) {
  std::uint64_t count = row.size();
  archivePlain(archive, count);
  if (count > most) throw InputError("a checkpoint is damaged: a row is too long");
  if constexpr (isReader<Archive>) row.resize(static_cast<std::size_t>(count));
  archive(cereal::binary_data(row.data(), row.size() * sizeof(T)));
}

}  // namespace seaway
