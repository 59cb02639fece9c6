#include <atomic>
#include <chrono>
#include <exception>
#include <thread>

#include "runtime/run/control_threads.h"
#include "runtime/run/execution.h"

namespace rob::runtime {

namespace {

using namespace std::chrono_literals;

constexpr std::int64_t kHeadStart = 1'000'000;  // instructions before the clock starts
constexpr std::int64_t kSlice = 10'000;         // instructions between looks at the stop flag
constexpr auto kProgramPause = 1ms;             // [choice] a tenth of a reference period
constexpr auto kReportPause = 10ms;             // [choice] what an eye does not notice

/// The program's thread: sleeps while the program must wait. It works far ahead of the motion,
/// so that its pauses shape nothing. TASKs run on until the motion is over.
class ProgramThread {
 public:
  /// It waits for begin(). Throws std::system_error.
  explicit ProgramThread(ProgramTask& program)
      : program_(program), thread_([this] {
          begun_.wait(false);
          run();
        }) {}
  ~ProgramThread() {
    stop();
    begin(ProgramTask::State::Over);
    if (thread_.joinable()) thread_.join();
  }
  ProgramThread(const ProgramThread&) = delete;
  ProgramThread& operator=(const ProgramThread&) = delete;

  /// The program has come so far.
  void begin(ProgramTask::State state) {
    if (begun_) return;
    state_ = state;
    begun_ = true;
    begun_.notify_all();
  }
  void stop() { stopping_.store(true, std::memory_order_relaxed); }
  void join() { thread_.join(); }

 private:
  void run() {
    while (!stopping_.load(std::memory_order_relaxed)) {
      if (state_ != ProgramTask::State::Over) state_ = program_.step(kSlice);
      state_ = program_.run_tasks(state_);
      if (state_ == ProgramTask::State::Over && !program_.has_tasks()) return;
      if (state_ != ProgramTask::State::Busy) std::this_thread::sleep_for(kProgramPause);
    }
  }

  ProgramTask& program_;
  ProgramTask::State state_ = ProgramTask::State::Over;
  std::atomic<bool> begun_{false};
  std::atomic<bool> stopping_{false};
  std::thread thread_;
};

/// Reports until the robot stands for good. If the reporting itself fails, the robot is stopped on
/// its path first; what went wrong is returned.
std::exception_ptr watch_over(Controller& controller, ProgramThread& program,
                              const Attend& attend) {
  std::exception_ptr trouble;
  while (!controller.motion().over()) {
    std::this_thread::sleep_for(kReportPause);
    try {
      if (!trouble) attend();
    } catch (...) {
      trouble = std::current_exception();
      controller.request_hold();
    }
    if (controller.holding()) program.stop();
  }
  return trouble;
}

}  // namespace

Timing run_threaded(Controller& controller, ProgramTask& program, const Attend& attend) {
  ControlThreads threads(controller);
  ProgramThread program_thread(program);
  controller.servo().enable(-kThreadLead);  // where the clock will begin
  controller.motion().prepare(0);
  const auto program_state = program.step(kHeadStart);
  controller.plan_path();
  threads.begin();
  program_thread.begin(program_state);

  const std::exception_ptr trouble = watch_over(controller, program_thread, attend);
  program_thread.stop();
  program_thread.join();
  const Timing timing = threads.finish();
  if (trouble) std::rethrow_exception(trouble);
  attend();
  return timing;
}

}  // namespace rob::runtime
