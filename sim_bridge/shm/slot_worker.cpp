#include "sim_bridge/shm/slot_worker.h"

#include <spdlog/spdlog.h>

#include <exception>
#include <utility>

#include "sim_bridge/shm/seaway_shm_system.h"

namespace seaway::bridge::shm {
namespace {

constexpr double slice = 0.1;   // s: how long a dead host goes unnoticed
constexpr double linger = 1.0;  // s without a host until the thread ends

}  // namespace

SlotWorker::SlotWorker(Segment& segment, std::uint32_t slot, const Backing& backing, double spin)
    : segment_(segment),
      slot_(slot),
      backing_(backing),
      spin_(spin),
      desk_(backing, segment.layout()),
      pictures_(segment, slot) {}

SlotWorker::~SlotWorker() { stop(); }

void SlotWorker::tend() {
  if (running_ || stopping_ || seaway_shm_load(&segment_.slot(slot_).session) == 0) return;
  if (thread_.joinable()) thread_.join();
  running_ = true;
  heard_ = seaway_shm_now();
  thread_ = std::thread([this] { run(); });
}

void SlotWorker::stop() {
  stopping_ = true;
  seaway_shm_wake(&segment_.slot(slot_).asked);
  if (thread_.joinable()) thread_.join();
}

void SlotWorker::run() {
  seaway_shm_slot& slot = segment_.slot(slot_);
  std::uint32_t last = segment_.layout().cell_count;  // requests that are answered while stopping
  while (!segment_.broken()) {
    const std::uint32_t session = seaway_shm_load(&slot.session);
    if (session != session_) {
      if (session_ != 0) letGo(Ending::left);
      if (session != 0) greet(session);
      continue;
    }
    if (stopping_ && last-- == 0) break;
    if (sea_ && answerAsked()) continue;
    if (stopping_ || (session_ == 0 && seaway_shm_now() - heard_ > linger)) break;
    waitForMore();
  }
  if (session_ != 0) letGo(Ending::left);
  running_ = false;
  // Whoever tends this looks again, in case a host came just now.
  __atomic_add_fetch(&segment_.header().attention, 1, __ATOMIC_SEQ_CST);
  seaway_shm_wake(&segment_.header().attention);
}

seaway_shm_status SlotWorker::makeRoom() {
  try {
    if (!segment_.reserveRing(slot_)) return SEAWAY_SHM_NO_MEMORY;
    sea_ = backing_.newHost();
    return SEAWAY_SHM_OK;
  } catch (const std::exception& fault) {
    spdlog::error("shared memory {}: {}", segment_.name(), fault.what());
    return SEAWAY_SHM_FAILED;
  }
}

void SlotWorker::greet(std::uint32_t session) {
  seaway_shm_slot& slot = segment_.slot(slot_);
  usesMemory_ = true;
  const seaway_shm_status refusal = makeRoom();
  if (refusal != SEAWAY_SHM_OK && backing_.observer) backing_.observer->refused(refusal);
  session_ = session;
  answered_ = 0;
  heard_ = seaway_shm_now();
  if (sea_) pictures_.begin(session);
  seaway_shm_store(&slot.answered, 0);
  seaway_shm_store(&slot.refusal, refusal);
  seaway_shm_store(&slot.served, session);
  seaway_shm_wake(&slot.served);
}

void SlotWorker::letGo(Ending how) {
  pictures_.end();
  sea_.reset();
  heard_ = seaway_shm_now();
  if (how == Ending::misbehaved) return expel();
  if (how == Ending::died) {
    // The lock is ours: no host is there, and none can come.
    seaway_shm_store(&segment_.slot(slot_).session, 0);
    segment_.release(slot_);
    usesMemory_ = false;
    segment_.unlock(slot_);
  }
  session_ = 0;
}

/// The host has the slot until it leaves or dies, but is not served.
void SlotWorker::expel() {
  seaway_shm_slot& slot = segment_.slot(slot_);
  if (!std::exchange(warned_, true)) {
    const std::uint32_t process = slot.process;
    spdlog::warn(
        "shared memory {}: process {} broke its ring and is not served any more; more of these in "
        "slot {} are counted only",
        segment_.name(), process, slot_);
  }
  if (backing_.observer) backing_.observer->refused(SEAWAY_SHM_MALFORMED);
  seaway_shm_store(&slot.refusal, SEAWAY_SHM_MALFORMED);
  seaway_shm_wake(&slot.answered);
  seaway_shm_wake(&slot.pictures_drawn);
}

bool SlotWorker::answerAsked() {
  seaway_shm_slot& slot = segment_.slot(slot_);
  const std::uint32_t pending = seaway_shm_load(&slot.asked) - answered_;
  if (pending == 0) return false;
  if (pending > segment_.layout().cell_count) {
    // A host that comes takes the session away before it sets `asked` back.
    if (seaway_shm_load(&slot.session) == session_) letGo(Ending::misbehaved);
    return true;
  }
  desk_.answer(segment_.cell(slot_, answered_ + 1), answered_ + 1, *sea_);
  ++answered_;
  seaway_shm_tell(&slot.answered, answered_, &slot.client_waits);
  heard_ = seaway_shm_now();
  return true;
}

bool SlotWorker::stays(std::uint32_t asked) const {
  seaway_shm_slot& slot = segment_.slot(slot_);
  return seaway_shm_load(&slot.asked) == asked && seaway_shm_load(&slot.session) == session_ &&
         !stopping_;
}

void SlotWorker::waitForMore() {
  seaway_shm_slot& slot = segment_.slot(slot_);
  const std::uint32_t asked = sea_ ? answered_ : seaway_shm_load(&slot.asked);
  while (sea_ && seaway_shm_now() - heard_ < spin_) {
    seaway_shm_pause();
    if (!stays(asked)) return;
  }
  seaway_shm_store(&slot.server_waits, 1);
  if (stays(asked)) seaway_shm_sleep(&slot.asked, asked, slice);
  seaway_shm_store(&slot.server_waits, 0);
  if (!stays(asked) || seaway_shm_now() - heard_ < slice) return;
  if (session_ != 0 && segment_.tryLock(slot_)) letGo(Ending::died);
  if (session_ == 0 && usesMemory_) giveMemoryBack();
}

void SlotWorker::giveMemoryBack() {
  if (!segment_.tryLock(slot_)) return;
  segment_.release(slot_);
  usesMemory_ = false;
  segment_.unlock(slot_);
}

}  // namespace seaway::bridge::shm
