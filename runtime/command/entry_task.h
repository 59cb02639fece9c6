#pragma once

#include <atomic>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "lang/vm/vm.h"
#include "runtime/command/program_task.h"
#include "runtime/command/robot_machine.h"
#include "runtime/command/task_machine.h"

namespace rob::runtime {

/// Carries out what is entered at a prompt, one entry after another, ahead of the motion: the
/// motions of two entries meet as those of two lines do. An error that nothing catches ends its
/// entry when all that was commanded before is finished, and drops the entries after it.
///
/// submit() and what stands above step() belong to the thread that reads; step() to the program's,
/// or on the virtual clock to the same one.
class EntryTask {
 public:
  /// Statements; what was typed.
  struct Statements {
    std::shared_ptr<const lang::Chunk> chunk;
    std::vector<motion::Obstacle> obstacles{};  ///< that it declares
  };
  /// A whole program, with variables of its own.
  struct Program {
    std::shared_ptr<const lang::Chunk> chunk;
    std::uint64_t seed = lang::Random::kDefaultSeed;
    const lang::SavedValues* saved = nullptr;  ///< of PERSIST; they outlive the run
    std::vector<motion::Obstacle> obstacles{};
  };
  /// A jog for as long as its watch says No.
  struct Jog {
    lang::MoveCommand command;
    motion::Watch held;
  };
  struct Entry {
    std::uint32_t line = 0;  ///< where it begins in the text
    std::variant<Statements, Program, Jog> what;
  };
  /// An entry that has ended by an error.
  struct Failure {
    std::uint32_t line = 0;  ///< 0: between two entries
    // Where the first and the last begin of it and those after it that are dropped; 0: none are.
    std::uint32_t first = 0;
    std::uint32_t last = 0;
    std::size_t dropped = 0;
    lang::RuntimeError error;
    bool beside = false;  ///< of a TASK: the entries go on
    bool told = false;    ///< nothing has gone wrong: the message is all
  };

  EntryTask(RobotMachine& machine, std::uint64_t seed);

  void submit(Entry entry);
  /// Entries that are not done yet.
  std::size_t open() const { return open_.load(std::memory_order_acquire); }
  /// No entry is open, and the robot stands after all that was commanded.
  bool settled() const { return settled_.load(std::memory_order_acquire); }
  /// The oldest one that has not been taken.
  std::optional<Failure> take_failure();

  ProgramTask::State step(std::int64_t budget) {
    const State state = carry_out(budget);
    tell_settled();
    return state;
  }
  /// To be called after step(), once in every cycle.
  ProgramTask::State run_tasks(ProgramTask::State state);

 private:
  using State = ProgramTask::State;
  State carry_out(std::int64_t budget);
  void tell_settled();
  /// An entry under way, from its beginning; what its code needs is kept with it.
  bool begin_next();
  void begin(const Statements& statements);
  void begin(const Program& program);
  void begin(const Jog&) {}
  void stand(const std::vector<motion::Obstacle>& obstacles);
  State go_on(const Statements& statements, std::int64_t budget);
  State go_on(const Program& program, std::int64_t budget);
  State go_on(const Jog& jog, std::int64_t budget);
  State run_vm(std::int64_t budget);
  State end_failed();
  State end();
  void tell_outdated();
  void run_own_tasks();
  void take_interruption();
  void begin_handler();

  RobotMachine& machine_;
  BackgroundTasks tasks_;          ///< of the entries; they go on beside a program
  std::int64_t tasks_cycle_ = -1;  ///< in which they ran last
  TaskMachine beside_;             ///< of handlers that do not stop the axes
  lang::Vm vm_;
  std::shared_ptr<const lang::Chunk> present_;                ///< what vm_ executes
  std::shared_ptr<const lang::Chunk> run_last_;               ///< of the last program
  std::vector<std::shared_ptr<const lang::Chunk>> watching_;  ///< what WHENs point into
  std::optional<ProgramTask> program_;
  std::optional<Entry> entry_;
  std::optional<lang::RuntimeError> failing_;
  bool given_up_ = false;  ///< the entry that fails has been left
  bool jogs_ = false;      ///< the jog of the entry is under way

  mutable std::mutex mutex_;  ///< of what follows
  std::deque<Entry> queue_;
  std::deque<Failure> failures_;
  std::atomic<std::size_t> open_{0};
  std::atomic<bool> settled_{true};
};

}  // namespace rob::runtime
