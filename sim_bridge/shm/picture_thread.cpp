#include "sim_bridge/shm/picture_thread.h"

#include <chrono>
#include <cmath>
#include <string>

#include "sim_bridge/shm/seaway_shm_system.h"

namespace seaway::bridge::shm {
namespace {

using Clock = std::chrono::steady_clock;

void requirePixels(std::uint64_t width, std::uint64_t height, std::uint32_t most) {
  if (width * height <= most) return;
  throw Refused(SEAWAY_SHM_TOO_LARGE, std::to_string(width) + " x " + std::to_string(height) +
                                          " pixels; at most " + std::to_string(most));
}

/// The request with its time made out. Throws Refused.
seaway_shm_picture_request checked(seaway_shm_picture_request request, const Backing& backing,
                                   std::uint32_t mostPixels) {
  if ((request.flags & ~std::uint32_t{SEAWAY_SHM_SERVERS_TIME | SEAWAY_SHM_OWN_CAMERA}) != 0) {
    throw Refused(SEAWAY_SHM_MALFORMED, "flags of a picture: unknown bits");
  }
  request.time = timeOf(backing, request.time, request.flags);
  if (!std::isfinite(request.time)) {
    throw Refused(SEAWAY_SHM_BAD_VALUE, "the time of a picture must be finite");
  }
  request.camera[sizeof request.camera - 1] = 0;
  requirePixels(request.width, request.height, mostPixels);
  return request;
}

}  // namespace

PictureThread::PictureThread(Segment& segment, std::span<const std::unique_ptr<SlotWorker>> workers,
                             const Backing& backing)
    : segment_(segment), workers_(workers), backing_(backing) {
  thread_ = std::thread([this] { run(); });
}

PictureThread::~PictureThread() {
  stopping_ = true;
  __atomic_add_fetch(&segment_.header().pictures_asked, 1, __ATOMIC_SEQ_CST);
  seaway_shm_wake(&segment_.header().pictures_asked);
  thread_.join();
}

void PictureThread::run() {
  while (!stopping_ && !segment_.broken()) {
    const std::uint32_t seen = seaway_shm_load(&segment_.header().pictures_asked);
    bool drawn = false;
    for (const auto& worker : workers_) {
      if (!stopping_) drawn = drawFor(worker->pictures()) || drawn;
    }
    // Awake now and then, whatever a host has done to the word.
    if (!drawn && !stopping_) seaway_shm_sleep(&segment_.header().pictures_asked, seen, 0.5);
  }
}

bool PictureThread::drawFor(SlotPictures& pictures) {
  const auto job = pictures.asked();
  if (!job) return false;
  const Clock::time_point start = Clock::now();
  try {
    if (!backing_.draw) throw Refused(SEAWAY_SHM_NOT_FOUND, "no pictures are served");
    const auto request = checked(job->request, backing_, segment_.layout().pixel_limit);
    const Picture picture = backing_.draw(request);
    requirePixels(picture.width, picture.height, segment_.layout().pixel_limit);
    const auto drawn = pictures.stored(*job, request.time, picture);
    if (backing_.observer) {
      backing_.observer->pictureSent(std::chrono::duration<double>(Clock::now() - start).count());
    }
    pictures.answer(*job, drawn);
  } catch (const Refused& why) {
    refuse(pictures, *job, why);
  } catch (const std::exception& fault) {
    refuse(pictures, *job, Refused(SEAWAY_SHM_FAILED, fault.what()));
  }
  return true;
}

// Counted first: what a host has heard of is in the figures.
void PictureThread::refuse(SlotPictures& pictures, const SlotPictures::Job& job,
                           const Refused& why) {
  if (backing_.observer) backing_.observer->refused(why.status);
  pictures.refuse(job, why);
}

}  // namespace seaway::bridge::shm
