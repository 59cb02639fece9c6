// Tests in real time, on computers that others use, too: `in_time COMMAND…` runs one. Where it
// fails and a thread of this computer was late meanwhile, it is run once more.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <thread>
#include <utility>

namespace {

/// s: a third of the silence on a wire that is E506 (docs/drivers.md): the tick, the thread of the
/// wire and the device that is emulated may wait one after the other.
constexpr double kLate = 0.1 / 3;
/// s, in the mean of that time: [choice] a cycle of 10 ms goes through half a dozen wake-ups, one
/// behind the other, and has 8 ms for them; a computer with nothing else to do is late by 0.1 ms.
constexpr double kLateInTheMean = 1e-3;
constexpr int kNaps = 20;       // in that time
constexpr int kMostTrials = 6;  // [choice]

/// Sleeps again and again, and keeps how late it was woken. It stands behind others: a thread that
/// does next to nothing would be preferred to those of the test. So it is late, too, where the test
/// keeps the whole computer busy.
class LatenessWatch {
 public:
  LatenessWatch() : thread_([this] { watch(); }) {}
  ~LatenessWatch() {
    ended_ = true;
    thread_.join();
  }
  /// s, the most so far; and in the mean of some time.
  double worst() const { return worst_; }
  double worst_mean() const { return worst_mean_; }
  bool late() const { return worst_ >= kLate || worst_mean_ >= kLateInTheMean; }

 private:
  void watch() {
    using Clock = std::chrono::steady_clock;
    constexpr std::chrono::milliseconds kNap{5};
    double sum = 0;
    std::array<double, kNaps> last{};
    constexpr int kBehind = 10;
    ::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), kBehind);
    for (std::size_t i = 0; !ended_; i = (i + 1) % last.size()) {
      const Clock::time_point due = Clock::now() + kNap;
      std::this_thread::sleep_until(due);
      const double late = std::chrono::duration<double>(Clock::now() - due).count();
      sum += late - std::exchange(last[i], late);
      if (late > worst_) worst_ = late;
      if (sum / kNaps > worst_mean_) worst_mean_ = sum / kNaps;
    }
  }

  std::atomic<bool> ended_ = false;
  std::atomic<double> worst_ = 0;
  std::atomic<double> worst_mean_ = 0;
  std::thread thread_;
};

/// Its exit code, or 128 and the signal that ended it.
int run(char** command) {
  const pid_t child = ::fork();
  if (child == 0) {
    ::execv(command[0], command);
    std::perror(command[0]);
    ::_exit(127);
  }
  int status = 0;
  if (child < 0 || ::waitpid(child, &status, 0) != child) return 127;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return 64;
  for (int left = kMostTrials - 1;; --left) {
    const LatenessWatch watch;
    const int exit_code = run(argv + 1);
    if (exit_code == 0 || left == 0 || !watch.late()) return exit_code;
    std::printf("in_time: this computer was late by %.0f ms, by %.1f ms in the mean; once more\n",
                1e3 * watch.worst(), 1e3 * watch.worst_mean());
    std::fflush(stdout);
  }
}
