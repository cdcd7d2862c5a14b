#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "sim_bridge/shm/request_desk.h"
#include "tests/sim_bridge/shm/known_sea.h"

namespace {

using namespace seaway::bridge::shm;

/// A cell for 16 points; its size is its own, so that a read or write beyond it is seen.
seaway_shm_header smallLayout() {
  seaway_shm_header layout{};
  layout.point_limit = 16;
  layout.arrays_offset = sizeof(seaway_shm_request) + sizeof(seaway_shm_answer);
  layout.array_stride = 128;
  layout.cell_size = layout.arrays_offset + 12 * layout.array_stride;
  return layout;
}

}  // namespace

/// Inputs are cells of one host, one after the other; whatever they hold is answered by its number.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const seaway_shm_header layout = smallLayout();
  test::KnownSea sea;
  test::KnownHost host(sea);
  Backing backing;
  backing.observer = &sea;
  RequestDesk desk(backing, layout);
  std::uint32_t number = 0;
  do {
    std::vector<std::byte> cell(layout.cell_size);
    const std::size_t part = std::min(size, cell.size());
    if (part > 0) std::memcpy(cell.data(), data, part);
    data += part;
    size -= part;
    ++number;
    if (number % 4 != 0) std::memcpy(cell.data(), &number, sizeof number);
    desk.answer(cell.data(), number, host);
    seaway_shm_answer answer;
    std::memcpy(&answer, cell.data() + sizeof(seaway_shm_request), sizeof answer);
    if (answer.number != number || answer.message[sizeof answer.message - 1] != 0) std::abort();
  } while (size > 0);
  return 0;
}
