#pragma once

#include <atomic>
#include <memory>

#include "surface/disturbance/wake_grid.h"

namespace seaway {

/// Height maps of one size, used again when their last reader lets go: megabytes that need not be
/// fetched and cleared at every step. `take` is for one thread at a time; a grid may be let go by
/// any thread, without locks, and outlive the pool.
class GridPool {
 public:
  GridPool(int cells, bool withPotential) : cells_(cells), withPotential_(withPotential) {}
  /// A pool of its own for grids of the same size.
  GridPool(const GridPool& other) : GridPool(other.cells_, other.withPotential_) {}
  GridPool& operator=(const GridPool&) = delete;

  std::shared_ptr<WakeGrid> take();

 private:
  struct Node {
    std::unique_ptr<WakeGrid> grid;
    Node* next = nullptr;
  };
  /// A stack that any thread pushes to and one thread empties in one go.
  struct Returned {
    std::atomic<Node*> top{nullptr};
    void push(Node* node);
    ~Returned();
  };

  int cells_;
  bool withPotential_;
  std::shared_ptr<Returned> returned_ = std::make_shared<Returned>();
};

}  // namespace seaway
