#include "surface/disturbance/grid_pool.h"

namespace seaway {

void GridPool::Returned::push(Node* node) {
  node->next = top.load(std::memory_order_relaxed);
  while (!top.compare_exchange_weak(node->next, node, std::memory_order_release,
                                    std::memory_order_relaxed)) {
  }
}

GridPool::Returned::~Returned() {
  for (Node* node = top.load(); node;) {
    const std::unique_ptr<Node> gone(node);
    node = node->next;
  }
}

std::shared_ptr<WakeGrid> GridPool::take() {
  std::unique_ptr<Node> node(returned_->top.exchange(nullptr, std::memory_order_acquire));
  if (node) {
    // Nobody else takes: the rest goes back.
    for (Node* rest = node->next; rest;) {
      Node* const next = rest->next;
      returned_->push(rest);
      rest = next;
    }
  } else {
    node = std::make_unique<Node>();
    node->grid = std::make_unique<WakeGrid>(cells_, withPotential_);
  }
  WakeGrid* const grid = node->grid.get();
  const auto giveBack = [returned = returned_, owner = node.get()](WakeGrid*) {
    returned->push(owner);
  };
  node.release();
  return {grid, giveBack};
}

}  // namespace seaway
