#pragma once

#include <atomic>
#include <thread>
#include <vector>

namespace rob::bench {

/// Processor time that the calling thread has used, s.
double thread_time() noexcept;

/// Computes for `seconds` of the calling thread's own processor time: the same work however many
/// others want the processor, and however fast it is.
void work_for(double seconds) noexcept;

/// Threads that compute without end at normal priority, on whatever processors they are given,
/// until the destructor stops them.
class Load {
 public:
  explicit Load(int threads);
  ~Load();
  Load(const Load&) = delete;
  Load& operator=(const Load&) = delete;

 private:
  std::atomic<bool> stopping_{false};
  std::vector<std::thread> threads_;
};

/// Keeps the calling thread, and all that it starts from now on, on the processor it runs on: S1
/// had a single one.
void stay_on_one_processor();

}  // namespace rob::bench
