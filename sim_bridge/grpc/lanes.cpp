#include "sim_bridge/grpc/lanes.h"

#include <sched.h>

#include <algorithm>
#include <asio/post.hpp>
#include <asio/thread_pool.hpp>
#include <atomic>
#include <thread>

namespace seaway::bridge::rpc {

struct Lanes::Threads {
  explicit Threads(int count) : pool(static_cast<std::size_t>(count)) {}
  ~Threads() { pool.join(); }

  std::atomic<int> waiting{0};
  asio::thread_pool pool;
};

int coreCount() {
  cpu_set_t ours;
  if (sched_getaffinity(0, sizeof ours, &ours) != 0) {  // more cores than a cpu_set_t has
    return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  }
  return CPU_COUNT(&ours);
}

Lanes::Lanes()
    : large_(std::make_unique<Threads>(std::max(2, coreCount()))),
      slow_(std::make_unique<Threads>(2)) {}

Lanes::~Lanes() = default;

bool Lanes::post(Lane lane, std::function<void()> work) {
  Threads& threads = lane == Lane::large ? *large_ : *slow_;
  if (threads.waiting.fetch_add(1) >= mostWaiting) {
    threads.waiting.fetch_sub(1);
    return false;
  }
  asio::post(threads.pool, [&threads, work = std::move(work)] {
    threads.waiting.fetch_sub(1);
    work();
  });
  return true;
}

}  // namespace seaway::bridge::rpc
