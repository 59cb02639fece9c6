#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lang/machine/machine.h"
#include "lang/vm/task_memory.h"
#include "runtime/command/assumptions.h"
#include "runtime/command/device_desk.h"
#include "runtime/command/file_desk.h"
#include "runtime/command/handler_turns.h"
#include "runtime/command/readings.h"
#include "runtime/command/robot_links.h"

namespace rob::runtime {

/// References to the objects that a TASK's machine uses. The objects outlive the machine.
struct TaskSide {
  const RobotLinks& links;
  Readings& readings;
  Assumptions& assumptions;
  HandlerTurns& turns;
  FileDesk& files;
  DeviceDesk& devices;
};

/// The machine of a TASK, and of a handler that does not stop the axes. It reads the current cycle.
/// Its outputs and prints act at the beginning of the next cycle, and its WAIT stops only itself.
/// It has no motions; the checker rejects them in a TASK. The program's thread makes all calls.
class TaskMachine final : public lang::Machine {
 public:
  /// `memory`: the globals that TASKs see; null where there are none.
  TaskMachine(const TaskSide& side, lang::TaskMemory* memory);
  TaskMachine(const TaskMachine&) = delete;

  lang::Reply wait(int line, double seconds) override;
  lang::Reply stand(int line, double& now) override;
  lang::Reply settle(int line) override;
  lang::Reply write(int line, std::string_view file, std::string_view text) override;
  lang::Reply persist(int line, std::size_t variable, std::string_view value) override;
  lang::Reply exists(int line, std::string_view file, bool& value) override;
  lang::Reply send(int line, std::size_t device, std::string_view text) override;
  lang::Reply receive(int line, std::size_t device, double timeout, std::string& text,
                      bool& came) override;
  lang::Reply print(int line, std::string_view text) override;
  lang::Reply write_signal(int line, int signal, bool value) override;
  lang::Reply write_analog(int line, int signal, double volts) override;
  lang::Reply pulse(int line, int signal, double seconds) override;
  lang::Reply read_signal(int line, int signal, bool& value) override;
  lang::Reply read_group(int line, int signal, int count, std::int64_t& value) override;
  lang::Reply read_analog(int line, int signal, double& volts) override;
  lang::Reply read(int line, lang::Reading what, lang::Slot* value) override;
  lang::Reply forward(int line, std::span<const double> joints, lang::PoseValue& pose) override;
  lang::Reply inverse(int line, const lang::PoseValue& pose, std::span<const double> near,
                      std::span<double> joints) override;

  // A TASK works on its globals directly; a handler of the program must publish them.
  lang::Reply publish(int line, std::size_t first, std::span<const lang::Slot> values) override;
  lang::Reply publish(int line, std::size_t first, std::span<const std::string> texts) override;
  lang::Reply publish_list(int line, std::size_t home, const lang::ListContent& list) override;
  lang::Reply refresh(int line, std::size_t first, std::span<lang::Slot> values) override;
  lang::Reply refresh(int line, std::size_t first, std::span<std::string> texts) override;
  lang::Reply leave_handler(int line) override;

 private:
  double now() const;
  lang::Reply give(const motion::Effect& effect);

  const TaskSide side_;
  Channels& channels_;
  lang::TaskMemory* const memory_;
  const Refuse refuse_;
  const lang::Setting outside_{};        ///< of all WITH and IN
  std::optional<double> waiting_since_;  ///< s; of a RECEIVE its first look
};

}  // namespace rob::runtime
