// What is the same for every machine on a wire, with a link that does as it is told.
#include "drivers/link/wire_backend.h"

#include <doctest/doctest.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "drivers/link/driver.h"
#include "tests/drivers/link/wire_bench.h"
#include "tests/support/eventually.h"
#include "tests/support/pty_wire.h"

namespace rob::drivers {
namespace {

using motion::DriverStatus;
using namespace std::chrono_literals;

/// What the link was told, and what it answers; read and written by the test meanwhile.
struct Script {
  std::mutex mutex;
  std::vector<WireCommand> told;
  int exchanges = 0;
  int enabled = 0;
  std::atomic<bool> silent{false};
  std::atomic<bool> blocks{false};   ///< the thread of the wire must not go on
  std::atomic<bool> blocked{false};  ///< it does not
};

class ScriptedLink final : public WireLink {
 public:
  explicit ScriptedLink(Script& script) : script_(script) {}
  void connect(WirePort&) override {}
  DriverStatus enable() noexcept override {
    const std::lock_guard lock(script_.mutex);
    ++script_.enabled;
    return DriverStatus::Ok;
  }
  void disable() noexcept override {}
  bool carries_signals() const override { return true; }
  DriverStatus exchange(const WireCommand* command, double, WireAnswer& answer) noexcept override {
    for (; script_.blocks; std::this_thread::sleep_for(1ms)) script_.blocked = true;
    script_.blocked = false;
    const std::lock_guard lock(script_.mutex);
    ++script_.exchanges;
    if (command != nullptr) script_.told.push_back(*command);
    if (script_.silent) return fail(DriverStatus::Silent, "it is silent", "wake it");
    answer.seen = answer.time = wire_time();
    if (command == nullptr) return DriverStatus::Ok;
    answer.position = command->position;
    answer.inputs = ~command->outputs;
    for (std::size_t i = 0; i < motion::kMostAnalog; ++i)
      answer.analog_inputs[i] = 10 - command->analog_outputs[i];
    return DriverStatus::Ok;
  }

 private:
  Script& script_;
};

struct Scripted {
  test::PtyWire wire;
  Script script;
  WireBackend machine{test::settings_for(wire.path(), test::plain_axes(1, 0), 0.01),
                      std::make_unique<ScriptedLink>(script)};
  double begun = wire_time();
  motion::ServoState state;
  motion::ServoCommand command;

  Scripted() {
    machine.open();
    command.reference.q = command.reference.qd = command.reference.qdd = test::all(1, 0);
  }
  double now() const { return wire_time() - begun; }
  DriverStatus read() { return machine.read(now(), state); }
  void write(double time) {
    command.reference.time = time;
    machine.write(time, command);
  }
  int exchanges() {
    const std::lock_guard lock(script.mutex);
    return script.exchanges;
  }
  std::size_t told() {
    const std::lock_guard lock(script.mutex);
    return script.told.size();
  }
};

}  // namespace

TEST_CASE("outputs go to the machine and inputs come from it: 64 digital and 16 analog each way") {
  Scripted scripted;
  scripted.machine.enable(scripted.now());
  scripted.command.outputs = 0x8000000000000005U;
  for (std::size_t i = 0; i < motion::kMostAnalog; ++i)
    scripted.command.analog_outputs[i] = 0.5 * static_cast<double>(i);
  scripted.read();
  scripted.write(scripted.now());
  REQUIRE(test::eventually([&] { return scripted.told() == 1; }));
  CHECK(scripted.script.told[0].outputs == 0x8000000000000005U);
  CHECK(scripted.script.told[0].analog_outputs[15] == 7.5);
  REQUIRE(test::eventually([&] {
    scripted.read();
    return scripted.state.inputs != 0;
  }));
  CHECK(scripted.state.inputs == 0x7FFFFFFFFFFFFFFAU);
  CHECK(scripted.state.analog_inputs[0] == 10);
  CHECK(scripted.state.analog_inputs[15] == 2.5);
  CHECK(scripted.machine.carries_signals());
}

TEST_CASE("the drives come under force with the first command") {
  Scripted scripted;
  scripted.machine.enable(-0.02);
  // It is asked where it stands meanwhile.
  CHECK(test::eventually([&] { return scripted.exchanges() > 5; }));
  CHECK(scripted.script.enabled == 0);
  scripted.read();
  scripted.write(scripted.now());
  REQUIRE(test::eventually([&] { return scripted.told() == 1; }));
  CHECK(scripted.script.enabled == 1);
}

TEST_CASE("each answer that does not come is told once, however often the tick looks") {
  Scripted scripted;
  scripted.script.silent = true;
  bool came = false;
  REQUIRE(test::eventually([&] { return came = came || scripted.read() == DriverStatus::Silent; }));
  const int before = scripted.exchanges();
  int silent = 0;
  int looks = 0;
  for (; looks < 400; ++looks) {
    silent += scripted.read() == DriverStatus::Silent ? 1 : 0;
    std::this_thread::sleep_for(500us);
  }
  CHECK(silent > 0);
  CHECK(silent <= scripted.exchanges() - before + 1);
  CHECK(silent < looks / 4);
  CHECK(scripted.machine.trouble() == "it is silent; wake it");
}

TEST_CASE("a thread of the wire that does not run is late, and not a silent machine") {
  Scripted scripted;
  scripted.script.blocks = true;
  CHECK(test::eventually(
      [&] { return scripted.read() == DriverStatus::Late && scripted.state.late > 0.3; }));
  scripted.script.blocks = false;
  CHECK(test::eventually([&] { return scripted.read() == DriverStatus::Ok; }));
}

TEST_CASE("a command that the process was stopped over is too old to be carried out") {
  Scripted scripted;
  scripted.machine.enable(scripted.now());
  scripted.read();
  scripted.write(scripted.now());
  REQUIRE(test::eventually([&] { return scripted.told() == 1; }));
  scripted.script.blocks = true;
  REQUIRE(test::eventually([&] { return scripted.script.blocked.load(); }));
  scripted.read();
  scripted.write(scripted.now());
  std::this_thread::sleep_for(400ms);
  scripted.script.blocks = false;
  const int before = scripted.exchanges();
  REQUIRE(test::eventually([&] {
    scripted.read();
    return scripted.exchanges() > before + 3;
  }));
  CHECK(scripted.told() == 1);
  scripted.write(scripted.now());
  CHECK(test::eventually([&] { return scripted.told() == 2; }));
}

TEST_CASE("every driver is in the one table, with a name of its own") {
  for (const Driver& driver : drivers()) {
    CHECK(find_driver(driver.name) == &driver);
    CHECK(std::string(driver.description).size() > 10);
    CHECK(driver.default_baud >= 57600);
  }
  CHECK(find_driver("sim") == nullptr);
  CHECK(find_driver("") == nullptr);
  CHECK_FALSE(find_driver("grbl")->sees_hand);
}

}  // namespace rob::drivers
