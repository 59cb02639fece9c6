#include "lang/machine/machine.h"

#include <doctest/doctest.h>

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lang/code/watch.h"
#include "lang/lang.h"

using namespace rob::lang;

namespace {

/// A machine that has nothing.
class BareMachine final : public Machine {};

struct Order {
  std::string without;  ///< the word that the refusal names
  std::function<Reply(Machine&)> give;
};

std::vector<Order> all_orders() {
  static bool flag = false;
  static int number = 0;
  static double real = 0;
  static std::optional<std::string> text;
  static std::array<Slot, 7> slots{};
  static std::array<std::string, 1> texts{};
  static PoseValue pose{};
  static const Watch watch{};
  return {
      {"MOVE", [](Machine& m) { return m.move(1, {}); }},
      {"MOVEC and MOVES", [](Machine& m) { return m.via(1, {}); }},
      {"PATH", [](Machine& m) { return m.begin_path(1); }},
      {"PATH", [](Machine& m) { return m.end_path(1); }},
      {"path events", [](Machine& m) { return m.on_the_way(1, {}); }},
      {"AT LIVE", [](Machine& m) { return m.live_pace(1, watch, {}); }},
      {"OVERRIDE", [](Machine& m) { return m.override_speed(1, 0.5); }},
      {"LOAD", [](Machine& m) { return m.carry(1, {}); }},
      {"BRAKE", [](Machine& m) { return m.brake(1); }},
      {"WAIT", [](Machine& m) { return m.wait(1, 0.5); }},
      {"kinematics", [](Machine& m) { return m.forward(1, {}, pose); }},
      {"kinematics", [](Machine& m) { return m.inverse(1, pose, {}, {}); }},
      {"outputs", [](Machine& m) { return m.write_signal(1, 0, true); }},
      {"analog outputs", [](Machine& m) { return m.write_analog(1, 0, 1.0); }},
      {"PULSE", [](Machine& m) { return m.pulse(1, 0, 0.1); }},
      {"signals", [](Machine& m) { return m.read_signal(1, 0, flag); }},
      {"analog signals", [](Machine& m) { return m.read_analog(1, 0, real); }},
      {"UNTIL", [](Machine& m) { return m.guard(1, watch); }},
      {"UNTIL", [](Machine& m) { return m.ended(1, flag); }},
      {"WHEN", [](Machine& m) { return m.when(1, watch, number); }},
      {"WHEN", [](Machine& m) { return m.when_raise(Place{}, "text"); }},
      {"WHEN", [](Machine& m) { return m.when_handle(1, true); }},
      {"WHEN", [](Machine& m) { return m.leave_handler(1); }},
      {"WHEN", [](Machine& m) { return m.disarm(1, 1); }},
      {"WAIT for a condition", [](Machine& m) { return m.stand(1, real); }},
      {"PRINT", [](Machine& m) { return m.print(1, "text"); }},
      {"HALT", [](Machine& m) { return m.halt(1, "text"); }},
      {"ASK", [](Machine& m) { return m.ask(1, "text", text); }},
      {"TEACH",
       [](Machine& m) {
         rob::lang::TaughtPoint point{};
         return m.teach(1, point);
       }},
      {"PRESS", [](Machine& m) { return m.press(1, {}); }},
      {"PRESS", [](Machine& m) { return m.end_press(1); }},
      {"ZERO force", [](Machine& m) { return m.zero_force(1); }},
      {"EXPECT", [](Machine& m) { return m.expectation_failed(1, "text"); }},
      {"SIMULATE", [](Machine& m) { return m.simulate(1, 0, 1, 0); }},
      {"SIMULATE", [](Machine& m) { return m.simulate_force(1, 0, 1, 0); }},
      {"SIMULATE", [](Machine& m) { return m.simulate_go(1, true, 0); }},
      {"SIMULATE", [](Machine& m) { return m.simulate_answer(1, "text", 0); }},
      {"TASKs", [](Machine& m) { return m.start(Place{}, 0); }},
      {"TASKs", [](Machine& m) { return m.publish(1, 0, std::span<const Slot>(slots)); }},
      {"TASKs", [](Machine& m) { return m.publish(1, 0, std::span<const std::string>(texts)); }},
      {"TASKs", [](Machine& m) { return m.publish_list(1, 0, {}); }},
      {"TASKs", [](Machine& m) { return m.refresh(1, 0, std::span<Slot>(slots)); }},
      {"TASKs", [](Machine& m) { return m.refresh(1, 0, std::span<std::string>(texts)); }},
      {"HERE", [](Machine& m) { return m.read(1, Reading::Here, slots.data()); }},
      {"CLOCK", [](Machine& m) { return m.read(1, Reading::Clock, slots.data()); }},
  };
}

}  // namespace

TEST_CASE("a machine refuses by name what it does not have") {
  for (const Order& order : all_orders()) {
    BareMachine machine;
    CAPTURE(order.without);
    CHECK(order.give(machine) == Reply::Refused);
    CHECK(machine.refusal().message == "this machine has no " + order.without);
    CHECK(machine.refusal().code == "E344");
  }
}

TEST_CASE("orders that only end something are done on every machine") {
  BareMachine machine;
  CHECK(machine.stop(1) == Reply::Done);
  CHECK(machine.end(1) == Reply::Done);
  CHECK(machine.settle(1) == Reply::Done);
  CHECK(machine.waited(1) == Reply::Done);
  CHECK(machine.leave_block(1) == Reply::Done);
  machine.work_in(1, {});
  CHECK_FALSE(machine.taken_as_met(1));
  CHECK(machine.refusal().message.empty());
}

TEST_CASE("a program on a machine without ASK fails at the line of the ASK") {
  RobotSignature robot;
  robot.name = "table";
  robot.coordinates = robot.axes = {{"x", kLength}};
  const std::string source = "VAR answer = \"\"\nASK \"go on?\" INTO answer\n";
  const Compilation program = compile(source, robot);
  REQUIRE(diagnose(program.diagnostics, "table.rob", source).empty());
  BareMachine machine;
  Vm vm(*program.chunk, machine);
  REQUIRE(vm.run(1000) == Vm::State::Failed);
  CHECK(vm.error().message == "this machine has no ASK");
  CHECK(vm.error().place.line == 2);
}

TEST_CASE("diagnose shows all findings as rob check prints them") {
  RobotSignature robot;
  robot.name = "table";
  robot.coordinates = robot.axes = {{"x", kLength}};
  const std::string source = "MOVE(12s)\n";
  const Compilation program = compile(source, robot);
  CHECK_FALSE(program.chunk);
  const std::string text = diagnose(program.diagnostics, "table.rob", source);
  REQUIRE(program.diagnostics.all().size() == 1);
  CHECK(text == render(program.diagnostics.all().front(), "table.rob", source));
  CHECK(text.starts_with("table.rob:1:6: error["));
  CHECK(text.find("  MOVE(12s)\n       ^") != std::string::npos);
}

TEST_CASE("diagnose counts the findings that are too many to be shown") {
  RobotSignature robot;
  robot.name = "table";
  robot.coordinates = robot.axes = {{"x", kLength}};
  std::string source;
  for (std::size_t i = 0; i < Diagnostics::kMost + 3; ++i) source += "PRINT nobody\n";
  const std::string text = diagnose(compile(source, robot).diagnostics, "table.rob", source);
  CHECK(text.ends_with("table.rob: and 3 more\n"));
}
