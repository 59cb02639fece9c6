// Tests in real time, on computers that others use, too: whether it was the computer that was late.
#pragma once

#include <atomic>
#include <chrono>
#include <thread>

namespace rob::test {

/// Sleeps again and again, and keeps how late it was woken.
class LatenessWatch {
 public:
  LatenessWatch() : thread_([this] { watch(); }) {}
  ~LatenessWatch() {
    ended_ = true;
    thread_.join();
  }
  /// s, the most so far.
  double worst() const { return worst_; }

 private:
  void watch() {
    using Clock = std::chrono::steady_clock;
    constexpr std::chrono::milliseconds kNap{5};
    while (!ended_) {
      const Clock::time_point due = Clock::now() + kNap;
      std::this_thread::sleep_until(due);
      const double late = std::chrono::duration<double>(Clock::now() - due).count();
      if (late > worst_) worst_ = late;
    }
  }

  std::atomic<bool> ended_ = false;
  std::atomic<double> worst_ = 0;
  std::thread thread_;
};

}  // namespace rob::test
