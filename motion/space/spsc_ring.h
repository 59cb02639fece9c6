#pragma once

#include <atomic>
#include <cstddef>
#include <memory>

namespace rob::motion {

/// A queue of fixed size from one thread to one other, without locks. Memory is taken by the
/// constructor alone, so every other call may be used in the tick. A slot is made when it is first
/// written: a short run does not touch the memory of the rest.
template <typename T>
class SpscRing {
 public:
  explicit SpscRing(std::size_t capacity)
      : size_(capacity + 1), slots_(std::allocator<T>().allocate(size_)) {}
  ~SpscRing() {
    std::destroy_n(slots_, made_);
    std::allocator<T>().deallocate(slots_, size_);
  }
  SpscRing(const SpscRing&) = delete;
  SpscRing& operator=(const SpscRing&) = delete;
  std::size_t capacity() const noexcept { return size_ - 1; }

  /// The writer's. False: full, nothing has happened.
  bool push(const T& value) noexcept {
    const std::size_t tail = tail_.load(std::memory_order_relaxed);
    const std::size_t next = after(tail);
    if (next == head_.load(std::memory_order_acquire)) return false;
    made(tail) = value;
    tail_.store(next, std::memory_order_release);
    return true;
  }
  /// The same, written in place: the next slot, which holds what it held before, and then push();
  /// null: full.
  T* slot() noexcept { return full() ? nullptr : &made(tail_.load(std::memory_order_relaxed)); }
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
    return (head > tail ? head : head + size_) - tail - 1;
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
    const std::size_t count = (tail >= head ? tail : tail + size_) - head;
    return i < count ? &slots_[(head + i) % size_] : nullptr;
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
  std::size_t after(std::size_t i) const noexcept { return i + 1 == size_ ? 0 : i + 1; }

  /// The writer's: a slot, which is made if it was never written. They are first written in order.
  T& made(std::size_t i) noexcept {
    if (i == made_) std::construct_at(&slots_[made_++]);
    return slots_[i];
  }

  const std::size_t size_;
  T* const slots_;
  alignas(64) std::atomic<std::size_t> head_{0};
  alignas(64) std::atomic<std::size_t> tail_{0};
  std::size_t made_ = 0;
};

}  // namespace rob::motion
