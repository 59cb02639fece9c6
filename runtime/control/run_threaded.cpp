#include <atomic>
#include <chrono>
#include <exception>
#include <thread>

#include "runtime/control/control_threads.h"
#include "runtime/control/execution.h"

namespace rob::runtime {

namespace {

using namespace std::chrono_literals;

constexpr std::int64_t kHeadStart = 1'000'000;  // instructions before the clock starts
constexpr std::int64_t kSlice = 10'000;         // instructions between looks at the stop flag
constexpr auto kProgramPause = 1ms;             // [choice] a tenth of a reference period
constexpr auto kReportPause = 10ms;             // [choice] what an eye does not notice

/// The program's thread: sleeps while the program has to wait. It works far ahead of the motion,
/// so that its pauses shape nothing.
/// TASKs run on until the motion is over.
void run_program(ProgramTask& program, ProgramTask::State state,
                 const std::atomic<bool>& stopping) {
  while (!stopping.load(std::memory_order_relaxed)) {
    if (state != ProgramTask::State::Over) state = program.step(kSlice);
    state = program.run_tasks(state);
    if (state == ProgramTask::State::Over && !program.has_tasks()) return;
    if (state != ProgramTask::State::Busy) std::this_thread::sleep_for(kProgramPause);
  }
}

/// Reports until the robot stands for good. If the reporting itself fails, the robot is stopped on
/// its path first; what went wrong is returned.
std::exception_ptr watch_over(Controller& controller, std::atomic<bool>& program_stops,
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
    if (controller.holding()) program_stops = true;
  }
  return trouble;
}

}  // namespace

Timing run_threaded(Controller& controller, ProgramTask& program, const Attend& attend) {
  std::atomic<bool> program_stops{false};
  controller.servo().enable(-kThreadLead);  // where the clock will begin
  controller.motion().prepare(0);
  const auto program_state = program.step(kHeadStart);
  controller.plan_path();
  ControlThreads threads(controller);
  std::thread program_thread([&] { run_program(program, program_state, program_stops); });

  const std::exception_ptr trouble = watch_over(controller, program_stops, attend);
  program_stops = true;
  program_thread.join();
  const Timing timing = threads.finish();
  if (trouble) std::rethrow_exception(trouble);
  attend();
  return timing;
}

}  // namespace rob::runtime
