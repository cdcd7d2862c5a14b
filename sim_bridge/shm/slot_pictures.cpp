#include "sim_bridge/shm/slot_pictures.h"

#include <atomic>
#include <cstring>

#include "sim_bridge/shm/request_desk.h"
#include "sim_bridge/shm/seaway_shm_system.h"

namespace seaway::bridge::shm {

void SlotPictures::begin(std::uint32_t session) {
  const std::lock_guard lock(mutex_);
  session_ = session;
  drawn_ = 0;
  seaway_shm_store(&segment_.slot(slot_).pictures_drawn, 0);
}

void SlotPictures::end() {
  const std::lock_guard lock(mutex_);
  session_ = 0;
}

std::optional<SlotPictures::Job> SlotPictures::asked() {
  const std::lock_guard lock(mutex_);
  seaway_shm_slot& slot = segment_.slot(slot_);
  const std::uint32_t number = seaway_shm_load(&slot.pictures_asked);
  if (session_ == 0 || number == drawn_) return std::nullopt;
  Job job{session_, number, {}};
  std::memcpy(&job.request, &slot.picture, sizeof job.request);
  std::atomic_signal_fence(std::memory_order_seq_cst);
  return job;
}

seaway_shm_picture_answer SlotPictures::stored(const Job& job, double t, const Picture& picture) {
  const std::size_t pixels = std::size_t{picture.width} * picture.height;
  const std::size_t colour = (3 * pixels + 63) / 64 * 64;
  seaway_shm_picture_answer drawn{};
  drawn.status = SEAWAY_SHM_OK;
  drawn.width = picture.width;
  drawn.height = picture.height;
  drawn.time = t;
  drawn.colour_offset = segment_.layout().pixels_offset;
  drawn.depth_offset = drawn.colour_offset + colour;
  const std::lock_guard lock(mutex_);
  if (!isFor(job)) return drawn;
  if (!segment_.reservePixels(slot_, colour + 4 * pixels)) {
    throw Refused(SEAWAY_SHM_NO_MEMORY, "the machine's shared memory is used up");
  }
  std::byte* const to = segment_.pixels(slot_);
  std::memcpy(to, picture.rgb.data(), 3 * pixels);
  std::memcpy(to + colour, picture.depth.data(), 4 * pixels);
  return drawn;
}

void SlotPictures::refuse(const Job& job, const Refused& why) {
  seaway_shm_picture_answer drawn{};
  drawn.status = why.status;
  write(drawn.message, why.what());
  answer(job, drawn);
}

void SlotPictures::answer(const Job& job, const seaway_shm_picture_answer& drawn) {
  const std::lock_guard lock(mutex_);
  if (!isFor(job)) return;
  seaway_shm_slot& slot = segment_.slot(slot_);
  std::memcpy(&slot.drawn, &drawn, sizeof drawn);
  slot.drawn.number = job.number;
  drawn_ = job.number;
  seaway_shm_store(&slot.pictures_drawn, job.number);
  seaway_shm_wake(&slot.pictures_drawn);
}

}  // namespace seaway::bridge::shm
