#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "sim_bridge/shm/bus_guard.h"
#include "sim_bridge/shm/seaway_shm_layout.h"

namespace seaway::bridge::shm {

/// What a segment has room for. Memory is used only for slots with a host and pictures asked for.
struct SegmentSettings {
  std::uint32_t slots = 16;              ///< hosts at a time, [1, 256]
  std::uint32_t cells = 4;               ///< requests of a host under way; a power of two
  std::uint32_t points = 8192;           ///< of a request, [1, 1048576]
  std::uint32_t pixels = 4096u * 2160u;  ///< of a picture
};

/// The header of a segment with that room; `magic` and `state` are still 0.
seaway_shm_header headerFor(const SegmentSettings& settings);

/// The shared memory of one server: made, locked, and taken away again. Its own copy of the header
/// says where things are; nothing that a host can write is believed.
class Segment {
 public:
  /// Makes /`name`, in place of one whose server is gone. Throws InputError, which begins with
  /// `option`, for a name that is not allowed, that a live server has, or that is somebody else's
  /// memory.
  Segment(const std::string& option, const std::string& name, const SegmentSettings& settings);
  /// Tells hosts that the server has ended, and removes the name where it is still this one's.
  ~Segment();
  Segment(const Segment&) = delete;
  Segment& operator=(const Segment&) = delete;

  const std::string& name() const { return name_; }
  const seaway_shm_header& layout() const { return layout_; }

  seaway_shm_header& header() const;
  seaway_shm_slot& slot(std::uint32_t number) const;
  /// The cell of the slot's request `request`, from 1 on.
  std::byte* cell(std::uint32_t slot, std::uint32_t request) const;
  std::byte* pixels(std::uint32_t slot) const;

  /// Hosts may connect from now on.
  void open();
  /// Hosts learn that nothing is answered any more.
  void end();

  /// Memory for a slot's ring; false where there is none left.
  bool reserveRing(std::uint32_t slot) const;
  bool reservePixels(std::uint32_t slot, std::size_t bytes) const;
  /// Gives a slot's memory back, all but its first page.
  void release(std::uint32_t slot) const;

  /// The lock of a host's slot. `tryLock` succeeds where no host lives there.
  bool tryLock(std::uint32_t slot) const;
  void unlock(std::uint32_t slot) const;

  /// The memory has been taken away underneath (BusGuard).
  bool broken() const noexcept { return guard_ && guard_->broken(); }
  /// Neither that, nor has a host written to what the server says of itself in the header.
  bool sound() const noexcept;

 private:
  void makeFile(const std::string& option);
  std::byte* slotMemory(std::uint32_t number) const;

  std::string name_;
  seaway_shm_header layout_;
  int file_ = -1;
  std::byte* memory_ = nullptr;
  std::optional<BusGuard> guard_;
};

}  // namespace seaway::bridge::shm
