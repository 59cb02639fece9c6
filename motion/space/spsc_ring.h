#pragma once

#include <atomic>
#include <cstddef>
#include <vector>

namespace rob::motion {

/// A queue of fixed size from one thread to one other, without locks. Memory is taken by the
/// constructor alone, so every other call may be used in the tick.
template <typename T>
class SpscRing {
 public:
  explicit SpscRing(std::size_t capacity) : slots_(capacity + 1) {}
  std::size_t capacity() const noexcept { return slots_.size() - 1; }

  /// The writer's. False: full, nothing has happened.
  bool push(const T& value) noexcept {
    const std::size_t tail = tail_.load(std::memory_order_relaxed);
    const std::size_t next = after(tail);
    if (next == head_.load(std::memory_order_acquire)) return false;
    slots_[tail] = value;
    tail_.store(next, std::memory_order_release);
    return true;
  }
  /// The same, written in place: the next slot, which holds what it held before, and then push();
  /// null: full.
  T* slot() noexcept { return full() ? nullptr : &slots_[tail_.load(std::memory_order_relaxed)]; }
  void push() noexcept {
    tail_.store(after(tail_.load(std::memory_order_relaxed)), std::memory_order_release);
  }
  bool full() const noexcept {
    return after(tail_.load(std::memory_order_relaxed)) == head_.load(std::memory_order_acquire);
  }
  /// How many more there is room for; the reader can only make it more.
  std::size_t room() const noexcept {
    const std::size_t tail = tail_.load(std::memory_order_relaxed);
    const std::size_t head = head_.load(std::memory_order_acquire);
    return (head > tail ? head : head + slots_.size()) - tail - 1;
  }

  /// The reader's. Null when empty; valid until pop().
  const T* front() const noexcept {
    const std::size_t head = head_.load(std::memory_order_relaxed);
    return head == tail_.load(std::memory_order_acquire) ? nullptr : &slots_[head];
  }
  /// The i-th after the front, which is the 0th; null when there are not so many.
  const T* at(std::size_t i) const noexcept {
    const std::size_t head = head_.load(std::memory_order_relaxed);
    const std::size_t tail = tail_.load(std::memory_order_acquire);
    const std::size_t count = (tail >= head ? tail : tail + slots_.size()) - head;
    return i < count ? &slots_[(head + i) % slots_.size()] : nullptr;
  }
  void pop() noexcept {
    head_.store(after(head_.load(std::memory_order_relaxed)), std::memory_order_release);
  }
  bool take(T& value) noexcept {
    const T* oldest = front();
    if (oldest == nullptr) return false;
    value = *oldest;
    pop();
    return true;
  }

 private:
  std::size_t after(std::size_t i) const noexcept { return i + 1 == slots_.size() ? 0 : i + 1; }

  std::vector<T> slots_;
  alignas(64) std::atomic<std::size_t> head_{0};
  alignas(64) std::atomic<std::size_t> tail_{0};
};

}  // namespace rob::motion
