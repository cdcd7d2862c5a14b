#include "sim_bridge/output/kept_text.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <functional>
#include <stdexcept>
#include <string_view>

#include "surface/input_error.h"

namespace seaway::bridge {
namespace {

namespace fs = std::filesystem;

/// Reads up to `bytes` from a stream, a piece at a time; how many there were.
std::uint64_t forPieces(std::istream& from, std::uint64_t bytes,
                        const std::function<void(std::string_view)>& action) {
  std::array<char, 1 << 16> piece{};
  std::uint64_t done = 0;
  while (done < bytes) {
    from.read(piece.data(),
              static_cast<std::streamsize>(std::min<std::uint64_t>(piece.size(), bytes - done)));
    if (from.gcount() == 0) break;
    action({piece.data(), static_cast<std::size_t>(from.gcount())});
    done += static_cast<std::uint64_t>(from.gcount());
  }
  return done;
}

void add(std::uint32_t& checksum, std::string_view piece) {
  checksum = static_cast<std::uint32_t>(
      crc32_z(checksum, reinterpret_cast<const Bytef*>(piece.data()), piece.size()));
}

}  // namespace

KeptText keepText(const fs::path& text, const fs::path& kept, const KeptText& known) {
  std::error_code ignored;
  if (fs::file_size(kept, ignored) > known.bytes && !ignored) fs::resize_file(kept, known.bytes);
  std::ifstream from(text, std::ios::binary);
  from.seekg(static_cast<std::streamoff>(known.bytes));
  std::ofstream to(kept, std::ios::binary | std::ios::app);
  KeptText all = known;
  all.bytes += forPieces(from, ~std::uint64_t{0}, [&](std::string_view piece) {
    to << piece;
    add(all.checksum, piece);
  });
  if (!to.flush()) throw std::runtime_error(kept.string() + ": writing failed (disk full?)");
  return all;
}

void copyKept(const fs::path& kept, const KeptText& wanted, std::ostream& to) {
  std::ifstream from(kept, std::ios::binary);
  if (!from) {
    throw InputError(kept.string(), 0, "no such file: it has the telemetry up to the checkpoint");
  }
  KeptText found;
  found.bytes = forPieces(from, wanted.bytes, [&](std::string_view piece) {
    to << piece;
    add(found.checksum, piece);
  });
  if (found.bytes != wanted.bytes || found.checksum != wanted.checksum) {
    throw InputError(kept.string(), 0, "is not the telemetry up to the checkpoint");
  }
}

}  // namespace seaway::bridge
