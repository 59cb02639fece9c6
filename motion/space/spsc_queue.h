#pragma once

#include <atomic>
#include <utility>

namespace rob::motion {

/// A queue from one thread to one other that grows as it is filled, without locks. Not for the
/// tick: each value has memory of its own.
template <typename T>
class SpscQueue {
 public:
  SpscQueue() : first_(new Node), last_(first_) {}
  ~SpscQueue() {
    while (first_ != nullptr) delete_first();
  }
  SpscQueue(const SpscQueue&) = delete;
  SpscQueue& operator=(const SpscQueue&) = delete;

  /// The writer's.
  void push(T value) {
    Node* const node = new Node{std::move(value)};
    last_->next.store(node, std::memory_order_release);
    last_ = node;
  }

  /// The reader's. Null when empty; valid until pop().
  const T* front() const noexcept {
    const Node* const node = first_->next.load(std::memory_order_acquire);
    return node == nullptr ? nullptr : &node->value;
  }
  void pop() noexcept { delete_first(); }

 private:
  struct Node {
    T value{};
    std::atomic<Node*> next{nullptr};
  };

  void delete_first() noexcept {
    delete std::exchange(first_, first_->next.load(std::memory_order_relaxed));
  }

  Node* first_;  ///< the one before the front: the reader and the writer never share a node's value
  alignas(64) Node* last_;
};

}  // namespace rob::motion
