#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lang/code/watch.h"
#include "lang/machine/machine.h"
#include "lang/machine/robot_signature.h"
#include "lang/vm/call_log.h"
#include "lang/vm/printing_outlets.h"
#include "lang/vm/scripted_robot.h"

namespace rob::lang {

/// A Machine that writes down each call in a line, and moves nothing: for tests.
///
///     move 40 - 0 at 20mm/s over 3s     mm and deg; - was left out
///     movel by 20 0 0 · move joints - - 90 · … zone 5mm · … fine
///     send 1 TEXT · receive 1 · simulate line 1 TEXT after 0s     a DEVICE, counted likewise
///     read FILE · warned MESSAGE · write FILE TEXT · persist 1 7mm    a PERSIST variable, counted
///     in the order of the text stop · brake · end · print TEXT · lift on · AOUT[1] 2.5V · pulse
///     lift 0.05s · wait 0.5s teach pick 40 20 0 · teach pick 40 20 0 in pallet     the place, in
///     mm start 1                           a TASK, counted in the order of the text halt TEXT ·
///     ask TEXT · simulate go after 2s · simulate answer TEXT after 0s guard · ended hit · ended
///     reached
///                                       UNTIL; the condition is looked at after its motion, until
///                                       it holds or the scripted signals change no more
///     zero force · live pace            ZERO force; AT LIVE, before its motion
///     via 10 20 - · movec … · moves … · spiral from 4mm turns 5 · jog world 5 - - for 2s
///     with flange in world · with 0 0 120 0 0 0 0.8kg cog 0 0 60 in tool
///                                       WITH and IN, and what holds again after them
///     path · end path · press z 10N limit 5mm/s · end press · override 30%
///     load 2kg cog 0 0 150              the place in mm, seen from the flange
///     failed TEXT · simulate lift_up 1 after 2s · simulate force.z 5N after 0s
///     after 2mm · before 3mm lead 0.1s  a path event, before its action
///     when 1 · raise TEXT · disarm 1    WHEN, before its action; counted in the order of arming
///     stand · waited                    WAIT for a condition: its beginning, its end
///     settle                            an error is caught: its RESCUE begins
///
/// While a program waits for a condition every look at it is 10 ms later than the one before.
///
/// The robot is where the last motion was to bring it, from 0 on every coordinate at the beginning;
/// its kinematics is that of cartesian_axes.h. Axes are taken for coordinates: of an arm the first
/// one moves x, 1 m for 1 rad. A force sensor says 0 where nothing is scripted.
///
/// Everything is taken at once, unless a test asks for something else.
class PrintingMachine : public PrintingOutlets {
 public:
  /// `robot` must outlive it.
  explicit PrintingMachine(const RobotSignature& robot);

  /// The answers of the following reads of a signal, one after another (1 is ON, V); the last
  /// stays. Without a script an output answers what was written last, an input FALSE.
  void script(int signal, std::vector<double> values) {
    scripted_.script(signal, std::move(values));
  }
  /// The answers of an operator, one after another; then an ASK leaves its variable as it is.
  void answer(std::vector<std::string> answers) { answers_ = std::move(answers); }
  /// The next `times` calls are answered Later.
  void answer_later(int times) { log_.answer_later(times); }
  /// The call that comes after `calls` further ones is refused.
  void refuse_after(int calls, Refusal refusal);

  const std::vector<CallLog::Call>& calls() const { return log_.calls(); }
  /// The texts of all calls.
  std::vector<std::string> texts() const { return log_.texts(); }
  /// Reads that were answered.
  int reads() const { return reads_; }

  Reply move(int line, const MoveCommand& command) override;
  Reply via(int line, const MoveCommand& point) override;
  void work_in(int line, const Setting& setting) override;
  Reply begin_path(int line) override { return log_.note(line, "path"); }
  Reply end_path(int line) override { return log_.note(line, "end path"); }
  Reply press(int line, const PressCommand& command) override;
  Reply end_press(int line) override { return log_.note(line, "end press"); }
  Reply override_speed(int line, double share) override;
  Reply carry(int line, const LoadCommand& load) override;
  Reply guard(int line, const Watch& condition) override;
  Reply ended(int line, bool& hit) override;
  Reply when(int line, const Watch& condition, int& id) override;
  Reply when_handle(int line, bool stops) override;
  Reply leave_handler(int line) override;
  Reply when_raise(const Place& place, std::string_view text) override;
  Reply disarm(int line, int id) override;
  Reply on_the_way(int line, const PathPlace& place) override;
  Reply live_pace(int line, const Watch& pace, MoveCommand::Pace means) override;
  Reply zero_force(int line) override { return log_.note(line, "zero force"); }
  Reply stop(int line) override { return log_.note(line, "stop"); }
  Reply brake(int line) override { return log_.note(line, "brake"); }
  Reply halt(int line, std::string_view text) override;
  Reply ask(int line, std::string_view text, std::optional<std::string>& answer) override;
  Reply simulate_go(int line, bool go, double after) override;
  Reply simulate_answer(int line, std::string_view text, double after) override;
  /// TASKs do not run here: the program alone changes its globals.
  Reply start(const Place& place, std::uint32_t task) override;
  Reply publish(int, std::size_t, std::span<const Slot>) override { return log_.answer(); }
  Reply publish(int, std::size_t, std::span<const std::string>) override { return log_.answer(); }
  Reply publish_list(int, std::size_t, const ListContent&) override { return log_.answer(); }
  Reply refresh(int, std::size_t, std::span<Slot>) override { return log_.answer(); }
  Reply refresh(int, std::size_t, std::span<std::string>) override { return log_.answer(); }
  Reply teach(int line, TaughtPoint& point) override;
  Reply wait(int line, double seconds) override;
  Reply stand(int line, double& now) override;
  Reply waited(int line) override;
  Reply leave_block(int) override { return log_.answer(); }
  Reply settle(int line) override;
  Reply end(int line) override { return log_.note(line, "end"); }
  Reply print(int line, std::string_view text) override;
  Reply write_signal(int line, int signal, bool value) override;
  Reply write_analog(int line, int signal, double volts) override;
  Reply pulse(int line, int signal, double seconds) override;
  Reply expectation_failed(int line, std::string_view text) override;
  Reply simulate(int line, int signal, double value, double after) override;
  Reply simulate_force(int line, int component, double value, double after) override;
  Reply read_signal(int line, int signal, bool& value) override;
  Reply read_analog(int line, int signal, double& volts) override;
  Reply read(int line, Reading what, Slot* value) override;
  Reply forward(int line, std::span<const double> joints, PoseValue& pose) override;
  Reply inverse(int line, const PoseValue& pose, std::span<const double> near,
                std::span<double> joints) override;

 private:
  const RobotSignature& robot_;
  ScriptedRobot scripted_;
  std::vector<std::string> answers_;
  std::size_t next_answer_ = 0;
  int reads_ = 0;
  Watch guard_;
  int whens_ = 0;
};

}  // namespace rob::lang
