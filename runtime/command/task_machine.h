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

/// A TASK's side of the robot, and that of a handler which does not stop the axes: it reads the
/// present cycle, what it sets and prints acts at the beginning of the next one, and its WAIT stops
/// nothing but itself. What would move the robot is refused; the checker has let nothing of the
/// kind through. All calls come from the program's thread.
class TaskMachine final : public lang::Machine {
 public:
  explicit TaskMachine(RobotMachine& robot);

  lang::Reply wait(int line, double seconds) override;
  lang::Reply stand(int line, double& now) override;
  bool taken_as_met(int /*line*/) override { return false; }
  lang::Reply waited(int /*line*/) override { return lang::Reply::Done; }
  lang::Reply leave_block(int /*line*/) override { return lang::Reply::Done; }
  lang::Reply settle(int line) override;
  lang::Reply end(int /*line*/) override { return lang::Reply::Done; }
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
  const lang::Refusal& refusal() const override;

  // A TASK works on its globals directly; a handler of the program has to be told.
  lang::Reply publish(int line, std::size_t first, std::span<const lang::Slot> values) override;
  lang::Reply publish(int line, std::size_t first, std::span<const std::string> texts) override;
  lang::Reply refresh(int line, std::size_t first, std::span<lang::Slot> values) override;
  lang::Reply refresh(int line, std::size_t first, std::span<std::string> texts) override;
  lang::Reply leave_handler(int line) override;

  // Nothing of the kind is in a TASK, nor in a handler that does not stop the axes.
  void work_in(int, const lang::Setting&) override {}
  lang::Reply move(int, const lang::MoveCommand&) override { return impossible(); }
  lang::Reply via(int, const lang::MoveCommand&) override { return impossible(); }
  lang::Reply begin_path(int) override { return impossible(); }
  lang::Reply end_path(int) override { return impossible(); }
  lang::Reply press(int, const lang::PressCommand&) override { return impossible(); }
  lang::Reply end_press(int) override { return impossible(); }
  lang::Reply override_speed(int, double) override { return impossible(); }
  lang::Reply carry(int, const lang::LoadCommand&) override { return impossible(); }
  lang::Reply live_pace(int, const lang::Watch&, lang::MoveCommand::Pace) override {
    return impossible();
  }
  lang::Reply zero_force(int) override { return impossible(); }
  lang::Reply guard(int, const lang::Watch&) override { return impossible(); }
  lang::Reply ended(int, bool&) override { return impossible(); }
  lang::Reply when(int, const lang::Watch&, int&) override { return impossible(); }
  lang::Reply when_raise(const lang::Place&, std::string_view) override { return impossible(); }
  lang::Reply when_handle(int, bool) override { return impossible(); }
  lang::Reply on_the_way(int, const lang::PathPlace&) override { return impossible(); }
  lang::Reply disarm(int, int) override { return impossible(); }
  lang::Reply stop(int) override { return impossible(); }
  lang::Reply brake(int) override { return impossible(); }
  lang::Reply halt(int, std::string_view) override { return impossible(); }
  lang::Reply ask(int, std::string_view, std::optional<std::string>&) override {
    return impossible();
  }
  lang::Reply teach(int, const lang::TaughtPoint&) override { return impossible(); }
  lang::Reply expectation_failed(int, std::string_view) override { return impossible(); }
  lang::Reply simulate(int, int, double, double) override { return impossible(); }
  lang::Reply simulate_force(int, int, double, double) override { return impossible(); }
  lang::Reply simulate_go(int, bool, double) override { return impossible(); }
  lang::Reply simulate_answer(int, std::string_view, double) override { return impossible(); }
  lang::Reply start(const lang::Place&, std::uint32_t) override { return impossible(); }

 private:
  double now() const;
  lang::Reply impossible();
  lang::Reply send(const motion::Effect& effect);

  RobotMachine& robot_;
  Channels& channels_;
  ProgramLog& log_;
  double period_;                        ///< s
  std::optional<double> waiting_since_;  ///< s
  bool impossible_ = false;              ///< the last refusal was the TASK's own
  lang::Refusal refusal_;
};

}  // namespace rob::runtime
