#include "tests/support/no_allocation.h"

#include <cerrno>
#include <cstddef>

namespace {

// Of the initial-exec kind in a program, so that reading it never takes memory itself.
thread_local constinit std::int64_t allocations = 0;

}  // namespace

namespace rob::test::detail {

std::int64_t allocations_of_this_thread() noexcept { return allocations; }

}  // namespace rob::test::detail

// Symbols of the program come before those of the C library, so every allocation of the process
// passes here first and goes on to glibc under its second name. `operator new` of libstdc++ ends
// in malloc or aligned_alloc. calloc is watched too: g++ merges malloc and memset into it.
// Memory is glibc's own, so free() stays glibc's.
#if ROB_NO_ALLOCATION_ACTIVE

extern "C" {

void* __libc_malloc(std::size_t size) noexcept;
void* __libc_calloc(std::size_t count, std::size_t size) noexcept;
void* __libc_realloc(void* block, std::size_t size) noexcept;
void* __libc_memalign(std::size_t alignment, std::size_t size) noexcept;

void* malloc(std::size_t size) noexcept {
  ++allocations;
  return __libc_malloc(size);
}

void* calloc(std::size_t count, std::size_t size) noexcept {
  ++allocations;
  return __libc_calloc(count, size);
}

void* realloc(void* block, std::size_t size) noexcept {
  ++allocations;
  return __libc_realloc(block, size);
}

void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  ++allocations;
  return __libc_memalign(alignment, size);
}

int posix_memalign(void** block, std::size_t alignment, std::size_t size) noexcept {
  if (alignment % sizeof(void*) != 0 || (alignment & (alignment - 1)) != 0 || alignment == 0) {
    return EINVAL;
  }
  ++allocations;
  void* taken = __libc_memalign(alignment, size);
  if (taken == nullptr) return ENOMEM;
  *block = taken;
  return 0;
}

}  // extern "C"

#endif
