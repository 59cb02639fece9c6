#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lang/machine/machine.h"
#include "lang/vm/task_memory.h"
#include "runtime/command/assumptions.h"
#include "runtime/command/handler_turns.h"
#include "runtime/command/readings.h"
#include "runtime/command/robot_links.h"

namespace rob::runtime {

/// The part of the program's side of the robot that a TASK needs. All of it outlives the TASK.
struct TaskSide {
  const RobotLinks& links;
  Readings& readings;
  Assumptions& assumptions;
  HandlerTurns& turns;
};

/// A TASK's side of the robot, and that of a handler that does not stop the axes: it reads the
/// current cycle, the values that it sets and prints act at the beginning of the next one, and its
/// WAIT stops nothing but itself. It has nothing that moves the robot; the checker lets nothing of
/// the kind into a TASK. All calls come from the program's thread.
class TaskMachine final : public lang::Machine {
 public:
  /// `memory`: the globals that TASKs see; null where there are none.
  TaskMachine(const TaskSide& side, lang::TaskMemory* memory);
  TaskMachine(const TaskMachine&) = delete;

  lang::Reply wait(int line, double seconds) override;
  lang::Reply stand(int line, double& now) override;
  lang::Reply settle(int line) override;
  lang::Reply print(int line, std::string_view text) override;
  lang::Reply write_signal(int line, int signal, bool value) override;
  lang::Reply write_analog(int line, int signal, double volts) override;
  lang::Reply pulse(int line, int signal, double seconds) override;
  lang::Reply read_signal(int line, int signal, bool& value) override;
  lang::Reply read_analog(int line, int signal, double& volts) override;
  lang::Reply read(int line, lang::Reading what, lang::Slot* value) override;
  lang::Reply forward(int line, std::span<const double> joints, lang::PoseValue& pose) override;
  lang::Reply inverse(int line, const lang::PoseValue& pose, std::span<const double> near,
                      std::span<double> joints) override;

  // A TASK works on its globals directly; a handler of the program must publish them.
  lang::Reply publish(int line, std::size_t first, std::span<const lang::Slot> values) override;
  lang::Reply publish(int line, std::size_t first, std::span<const std::string> texts) override;
  lang::Reply refresh(int line, std::size_t first, std::span<lang::Slot> values) override;
  lang::Reply refresh(int line, std::size_t first, std::span<std::string> texts) override;
  lang::Reply leave_handler(int line) override;

 private:
  double now() const;
  lang::Reply send(const motion::Effect& effect);

  const TaskSide side_;
  Channels& channels_;
  lang::TaskMemory* const memory_;
  const Refuse refuse_;
  const lang::Setting outside_{};        ///< of all WITH and IN
  std::optional<double> waiting_since_;  ///< s
};

}  // namespace rob::runtime
