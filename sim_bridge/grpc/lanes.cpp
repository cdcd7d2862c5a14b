#include "sim_bridge/grpc/lanes.h"

#include <algorithm>
#include <asio/post.hpp>
#include <asio/thread_pool.hpp>
#include <atomic>
#include <thread>

namespace seaway::bridge::rpc {

struct Lanes::Threads {
  explicit Threads(std::size_t count) : pool(count) {}
  ~Threads() { pool.join(); }

  std::atomic<int> waiting{0};
  asio::thread_pool pool;
};

Lanes::Lanes()
    : large_(std::make_unique<Threads>(std::max(2u, std::thread::hardware_concurrency()))),
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
