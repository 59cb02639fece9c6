#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "lang/machine/machine.h"
#include "runtime/command/robot_links.h"
#include "runtime/command/robot_outlets.h"
#include "runtime/command/robot_parts.h"

namespace rob::runtime {

/// The program's side of a robot: completes and checks what is asked, puts it into the buffer,
/// and answers Later while the buffer is full or a decision point has not come. Its parts do the
/// work; what concerns all of them is done here. All calls come from the program's thread.
class RobotMachine final : public RobotOutlets {
 public:
  /// `progress`: the reports of the motions in `buffer`; one of those of `channels`.
  /// `handlers`: commands what handlers do, into a buffer of its own; null: there are none. It must
  /// outlive the run. `override_share`: the speed
  /// that the program's OVERRIDE is a share of, 1 = as programmed.
  RobotMachine(const motion::RobotModel& robot, motion::MotionPlanner& planner,
               motion::LookAheadBuffer& buffer, Channels& channels, MotionProgress& progress,
               ProgramLog& log, RobotMachine* handlers = nullptr, double override_share = 1);

  /// Before the run: the program's TASKs; they must outlive it.
  void run_beside(BackgroundTasks& tasks);

  const RobotLinks& links() const { return links_; }
  RobotParts& parts() { return parts_; }
  /// Null: there is none for handlers.
  RobotMachine* handlers() { return handlers_; }

  /// The program has failed for good: as end(), but when all that was commanded has acted the
  /// outputs take their SAFE values.
  lang::Reply fail(int line);
  /// The error that a WHEN has raised, once the axes stand; what had been commanded is dropped.
  std::optional<lang::RuntimeError> take_interruption();
  /// A WHEN whose handler must begin now.
  struct Handled {
    int id;                ///< as when() has said
    lang::Machine* robot;  ///< what it commands: the axes stand; null: they go on
  };
  std::optional<Handled> take_handled();

  // Motions
  lang::Reply move(int line, const lang::MoveCommand& command) override;
  lang::Reply via(int line, const lang::MoveCommand& point) override;
  void work_in(int line, const lang::Setting& setting) override;
  lang::Reply begin_path(int line) override;
  lang::Reply end_path(int line) override;
  lang::Reply on_the_way(int line, const lang::PathPlace& place) override;
  lang::Reply live_pace(int line, const lang::Watch& pace, lang::MoveCommand::Pace means) override;
  lang::Reply override_speed(int line, double share) override;
  lang::Reply carry(int line, const lang::LoadCommand& load) override;
  lang::Reply stop(int line) override;
  lang::Reply brake(int line) override;
  lang::Reply wait(int line, double seconds) override;
  lang::Reply end(int line) override;
  lang::Reply forward(int line, std::span<const double> joints, lang::PoseValue& pose) override;
  lang::Reply inverse(int line, const lang::PoseValue& pose, std::span<const double> near,
                      std::span<double> joints) override;
  // Signals
  lang::Reply write_signal(int line, int signal, bool value) override;
  lang::Reply write_analog(int line, int signal, double volts) override;
  lang::Reply pulse(int line, int signal, double seconds) override;
  lang::Reply read_signal(int line, int signal, bool& value) override;
  lang::Reply read_group(int line, int signal, int count, std::int64_t& value) override;
  lang::Reply read_analog(int line, int signal, double& volts) override;
  lang::Reply guard(int line, const lang::Watch& condition) override;
  lang::Reply ended(int line, bool& hit) override;
  lang::Reply when(int line, const lang::Watch& condition, int& id) override;
  lang::Reply when_raise(const lang::Place& place, std::string_view text) override;
  lang::Reply when_handle(int line, bool stops) override;
  lang::Reply leave_handler(int line) override;
  lang::Reply disarm(int line, int id) override;
  lang::Reply stand(int line, double& now) override;
  bool taken_as_met(int line) override;
  lang::Reply waited(int line) override;
  // Output, Operator, Force
  lang::Reply print(int line, std::string_view text) override;
  lang::Reply halt(int line, std::string_view text) override;
  lang::Reply ask(int line, std::string_view text, std::optional<std::string>& answer) override;
  lang::Reply teach(int line, lang::TaughtPoint& point) override;
  lang::Reply press(int line, const lang::PressCommand& command) override;
  lang::Reply end_press(int line) override;
  lang::Reply zero_force(int line) override;
  // Testing
  lang::Reply expectation_failed(int line, std::string_view text) override;
  lang::Reply simulate(int line, int signal, double value, double after) override;
  lang::Reply simulate_force(int line, int component, double value, double after) override;
  lang::Reply simulate_go(int line, bool go, double after) override;
  lang::Reply simulate_answer(int line, std::string_view text, double after) override;
  // Machine
  lang::Reply read(int line, lang::Reading what, lang::Slot* value) override;
  lang::Reply leave_block(int line) override;
  lang::Reply settle(int line) override;

 private:
  lang::Reply drop_interrupted(int line);
  /// Forgets what the current statement has begun, and what has been said of the next motion.
  void drop_statement();

  const lang::RobotSignature signature_;
  const RobotLinks links_;
  RobotParts parts_;
  RobotMachine* const handlers_;
};

}  // namespace rob::runtime
