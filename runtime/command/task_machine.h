#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lang/machine/machine.h"
#include "runtime/command/program_log.h"
#include "runtime/tick/channels.h"

namespace rob::runtime {

class RobotMachine;

/// A TASK's side of the robot, and that of a handler that does not stop the axes: it reads the
/// current cycle, the values that it sets and prints act at the beginning of the next one, and its
/// WAIT stops nothing but itself. It has nothing that moves the robot; the checker lets nothing of
/// the kind into a TASK. All calls come from the program's thread.
class TaskMachine final : public lang::Machine {
 public:
  explicit TaskMachine(RobotMachine& robot);

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

  // A TASK works on its globals directly; a handler of the program has to be told.
  lang::Reply publish(int line, std::size_t first, std::span<const lang::Slot> values) override;
  lang::Reply publish(int line, std::size_t first, std::span<const std::string> texts) override;
  lang::Reply refresh(int line, std::size_t first, std::span<lang::Slot> values) override;
  lang::Reply refresh(int line, std::size_t first, std::span<std::string> texts) override;
  lang::Reply leave_handler(int line) override;

 private:
  double now() const;
  lang::Reply send(const motion::Effect& effect);
  /// Asks the robot outside of all WITH and IN; its refusal is this machine's.
  template <typename Ask>
  lang::Reply asked(const Ask& ask);

  RobotMachine& robot_;
  Channels& channels_;
  ProgramLog& log_;
  double period_;                        ///< s
  std::optional<double> waiting_since_;  ///< s
};

}  // namespace rob::runtime
