#include "tests/bench/busy.h"

#include <sched.h>

#include <cerrno>
#include <ctime>
#include <system_error>

namespace rob::bench {

double thread_time() noexcept {
  timespec t;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

void work_for(double seconds) noexcept {
  const double end = thread_time() + seconds;
  while (thread_time() < end) {
  }
}

Load::Load(int threads) {
  for (int i = 0; i < threads; ++i) {
    threads_.emplace_back([this] {
      while (!stopping_.load(std::memory_order_relaxed)) {
      }
    });
  }
}

Load::~Load() {
  stopping_ = true;
  for (std::thread& thread : threads_) thread.join();
}

void stay_on_one_processor() {
  cpu_set_t one;
  CPU_ZERO(&one);
  CPU_SET(static_cast<std::size_t>(sched_getcpu()), &one);
  if (sched_setaffinity(0, sizeof one, &one) != 0) {
    throw std::system_error(errno, std::generic_category(), "cannot stay on one processor");
  }
}

}  // namespace rob::bench
