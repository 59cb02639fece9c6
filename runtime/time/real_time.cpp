#include "runtime/time/real_time.h"

#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>

#include <cstddef>

namespace rob::runtime {

namespace {

bool set_fifo(int priority) noexcept {
  const sched_param parameter{.sched_priority = priority};
  return pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameter) == 0;
}

/// Whether fixed priorities are permitted: asked by taking one and giving it back.
bool fifo_permitted() {
  if (!set_fifo(1)) return false;
  const sched_param normal{.sched_priority = 0};
  pthread_setschedparam(pthread_self(), SCHED_OTHER, &normal);
  return true;
}

/// [choice] what a run maps after its start, thread stacks included, and as much again.
constexpr std::size_t kStillToCome = std::size_t{256} << 20U;

/// Locks all memory, now and in future. A small limit can allow the first and refuse what is
/// mapped later, which would end the run in mid-motion: whether that has room is asked at once.
bool lock_memory() {
  if (mlockall(MCL_CURRENT | MCL_FUTURE) != 0) return false;
  void* probe = mmap(nullptr, kStillToCome, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (probe == MAP_FAILED) {
    munlockall();
    return false;
  }
  munmap(probe, kStillToCome);
  return true;
}

/// [choice] far more than the tick's deepest call, far less than a thread's stack (8 MiB).
constexpr std::size_t kWarmStack = 128 * 1024;

void warm_up_stack() noexcept {
  constexpr std::size_t kPage = 4096;
  unsigned char stack[kWarmStack];
  volatile unsigned char* touched = stack;
  for (std::size_t i = 0; i < kWarmStack; i += kPage) touched[i] = 0;
}

}  // namespace

std::string prepare_real_time() {
  const bool locked = lock_memory();
  const bool fifo = fifo_permitted();
  if (locked && fifo) return "";
  std::string missing = !fifo ? "fixed priorities (SCHED_FIFO)" : "";
  if (!locked) missing += missing.empty() ? "locked memory" : " and locked memory";
  return missing +
         " not permitted: running at normal priority, lateness is counted"
         " (to permit: ulimit -r 99 -l unlimited, see docs/realtime.md)";
}

void enter_real_time(int priority) noexcept {
  set_fifo(priority);
  warm_up_stack();
}

}  // namespace rob::runtime
