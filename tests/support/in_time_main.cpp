// Tests in real time, on computers that others use, too. `in_time BINARY OPTION…` runs the test
// cases of a doctest binary that the options choose, each in a process of its own. A case that
// fails while this computer was late is run again (tests/support/trials.h). The last line gives
// the number of such reruns; ./test adds them up.
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "tests/support/child.h"
#include "tests/support/process.h"
#include "tests/support/trials.h"

namespace rob::test {

namespace {

/// s: a third of the silence on a wire that is E506 (docs/drivers.md): the tick, the thread of the
/// wire and the device that is emulated may wait one after the other.
constexpr double kLate = 0.1 / 3;
/// s, in the mean of that time: [choice] a cycle of 10 ms goes through half a dozen wake-ups, one
/// after the other, and has 8 ms for them; an idle computer is late by 0.1 ms.
constexpr double kLateInTheMean = 1e-3;
constexpr int kNaps = 20;  // in that time

/// Sleeps again and again, and keeps how late it was woken. It has a lower priority than the tests:
/// the scheduler would prefer a thread that does next to nothing to those of the test. So it is
/// late, too, while the test keeps the whole computer busy.
class LatenessWatch {
 public:
  LatenessWatch() : thread_([this] { watch(); }) {}
  ~LatenessWatch() { end(); }
  /// Ends the watch; the results below are known afterwards.
  void end() {
    ended_ = true;
    if (thread_.joinable()) thread_.join();
  }
  /// s, the most; and in the mean of some time.
  double worst() const { return worst_; }
  double worst_mean() const { return worst_mean_; }
  bool late() const { return worst_ >= kLate || worst_mean_ >= kLateInTheMean; }

 private:
  using Clock = std::chrono::steady_clock;

  /// Each nap begins at the end of the last, the first when the watch is made: a thread that is
  /// late to start is late.
  void watch() {
    constexpr std::chrono::milliseconds kNap{5};
    double sum = 0;
    std::array<double, kNaps> last{};
    constexpr int kLower = 10;
    ::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), kLower);
    std::size_t i = 0;
    do {
      const Clock::time_point due = begin_ + kNap;
      std::this_thread::sleep_until(due);
      begin_ = Clock::now();
      const double late = std::chrono::duration<double>(begin_ - due).count();
      sum += late - std::exchange(last[i++ % last.size()], late);
      if (late > worst_) worst_ = late;
      if (sum / kNaps > worst_mean_) worst_mean_ = sum / kNaps;
    } while (!ended_);
  }

  Clock::time_point begin_ = Clock::now();
  std::atomic<bool> ended_ = false;
  double worst_ = 0;
  double worst_mean_ = 0;
  std::thread thread_;
};

using Command = std::vector<std::string>;

std::mutex printing;  // several cases at a time do

Command with(Command command, const std::string& option) {
  command.push_back(option);
  return command;
}

/// How many test cases the command chooses. Throws std::runtime_error if that are none.
int number_of_cases(const Command& command) {
  const std::string out = run_process(with(command, "--count")).out;
  const int number = std::atoi(out.substr(out.find_last_of(' ') + 1).c_str());
  if (number < 1) throw std::runtime_error("there is no such test case");
  return number;
}

/// Runs one of the test cases that the command chooses; `number` counts from 1. One that hangs is
/// killed, and no lateness excuses it.
Trial try_case(const Command& command, int number) {
  const std::string only = std::to_string(number);
  LatenessWatch watch;
  ProcessResult result;
  bool hangs = false;
  try {
    result = run_process(with(with(command, "--first=" + only), "--last=" + only));
  } catch (const std::exception& error) {
    result.err = error.what();
    hangs = true;
  }
  watch.end();
  if (result.exit_code == 0) return {true, watch.late()};
  const std::lock_guard lock(printing);
  std::printf("%s%s\nin_time: this computer was late by %.0f ms, by %.1f ms in the mean\n",
              result.out.c_str(), result.err.c_str(), 1e3 * watch.worst(),
              1e3 * watch.worst_mean());
  std::fflush(stdout);
  return {false, !hangs && watch.late()};
}

/// Runs each case once, several at a time: they wait for most of their time.
std::vector<Trial> try_all(const Command& command, int cases) {
  constexpr int kAtATime = 4;  // [choice] for two processors
  std::vector<Trial> trials(static_cast<std::size_t>(cases));
  std::atomic<int> taken = 0;
  const auto work = [&] {
    for (int i = taken++; i < cases; i = taken++) {
      trials[static_cast<std::size_t>(i)] = try_case(command, i + 1);
    }
  };
  std::vector<std::jthread> workers(kAtATime);
  for (std::jthread& worker : workers) worker = std::jthread(work);
  workers.clear();  // waits for them
  return trials;
}

/// Whether all cases pass. Reruns are made alone.
bool run_all(const Command& command) {
  const std::vector<Trial> trials = try_all(command, number_of_cases(command));
  int failed = 0;
  int reruns = 0;
  int number = 0;
  for (const Trial& trial : trials) {
    ++number;
    const Verdict verdict = judge_trials(trial, [&] { return try_case(command, number); });
    if (!verdict.passed) ++failed;
    reruns += verdict.reruns;
  }
  std::printf("in_time: %d of %zu cases failed; reruns: %d\n", failed, trials.size(), reruns);
  return failed == 0;
}

}  // namespace

}  // namespace rob::test

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "usage: in_time BINARY [OPTION]...\n");
    return 64;
  }
  try {
    return rob::test::run_all({argv + 1, argv + argc}) ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "in_time: %s\n", error.what());
    return 1;
  }
}
