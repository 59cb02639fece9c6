#pragma once

#include <cstdint>

// Sanitizers bring an allocator of their own, which cannot be watched from here.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define ROB_NO_ALLOCATION_ACTIVE 0
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define ROB_NO_ALLOCATION_ACTIVE 0
#endif
#endif
#ifndef ROB_NO_ALLOCATION_ACTIVE
#define ROB_NO_ALLOCATION_ACTIVE 1
#endif

namespace rob::test {

namespace detail {
/// How often this thread has taken memory since it began.
std::int64_t allocations_of_this_thread() noexcept;
}  // namespace detail

/// Counts how often the calling thread takes memory while the guard lives: malloc, calloc,
/// realloc, aligned_alloc, posix_memalign, and with them every `operator new`. Giving memory back
/// is not counted. Guards may be nested; create and ask one in the same thread.
///
///     NoAllocation guard;
///     law.update(reference, measured);
///     CHECK(guard.count() == 0);
///
/// Under the address and thread sanitizers kActive is false and count() is always 0.
class NoAllocation {
 public:
  static constexpr bool kActive = ROB_NO_ALLOCATION_ACTIVE;

  NoAllocation() noexcept : before_(detail::allocations_of_this_thread()) {}
  NoAllocation(const NoAllocation&) = delete;
  NoAllocation& operator=(const NoAllocation&) = delete;

  int count() const noexcept {
    return static_cast<int>(detail::allocations_of_this_thread() - before_);
  }

 private:
  std::int64_t before_;
};

}  // namespace rob::test
