#include "drivers/link/servo_driver.h"

#include <doctest/doctest.h>

#include "tests/drivers/link/wire_bench.h"
#include "tests/emulators/servo_emulator.h"
#include "tests/support/no_allocation.h"

// Servos on a bus. Periods are 20 ms and bounds are wide: the machine of the tests may be busy.

namespace rob::drivers {
namespace {

using motion::DriverStatus;
using test::all;
using test::mentions;
using test::ServoEmulator;
using test::WireBench;

constexpr double kPeriod = 0.02;

struct Dynamixel {
  static constexpr auto kKind = ServoEmulator::Kind::Dynamixel;
  static std::unique_ptr<WireLink> link(const std::vector<WireAxis>& axes) {
    return dynamixel_link(axes, 1000000);
  }
};
struct Feetech {
  static constexpr auto kKind = ServoEmulator::Kind::Feetech;
  static std::unique_ptr<WireLink> link(const std::vector<WireAxis>& axes) {
    return feetech_link(axes, 1000000);
  }
};

struct FeetechScs {
  static constexpr auto kKind = ServoEmulator::Kind::FeetechScs;
  static std::unique_ptr<WireLink> link(const std::vector<WireAxis>& axes) {
    return feetech_scs_link(axes, 1000000);
  }
};

template <typename Bus>
std::unique_ptr<WireBackend> machine_on(ServoEmulator& bus, int count = 3) {
  const auto axes = test::plain_axes(count, 1, 3000);
  return std::make_unique<WireBackend>(test::settings_for(bus.path(), axes, kPeriod),
                                       Bus::link(axes));
}

}  // namespace

TEST_CASE_TEMPLATE("servos go where they are told, and tell where they are", Bus, Dynamixel,
                   Feetech) {
  ServoEmulator bus(Bus::kKind, 3);
  bus.stand_at(2, 1000);
  {
    const auto machine = machine_on<Bus>(bus);
    machine->open();
    CHECK_FALSE(bus.torque(1));  // not before it is enabled
  }
  {
    WireBench bench(machine_on<Bus>(bus));
    CHECK(bench.machine().position()[1] == 1000);
    bench.go(all(3, 1500), 0.5);
    CHECK(bus.torque(1));
    bench.comes(DriverStatus::Lost, 0.3);
    for (const int id : {1, 2, 3}) CHECK(std::abs(bus.position(id) - 1500) < 1);
    CHECK(bench.state().measured.q[2] == doctest::Approx(1500).epsilon(0.001));
  }
  for (const int id : {1, 2, 3})  // closed: without force
    CHECK(test::eventually([&] { return !bus.torque(id); }));
}

TEST_CASE_TEMPLATE("nothing jumps when the torque comes on", Bus, Dynamixel, Feetech) {
  ServoEmulator bus(Bus::kKind, 2);
  bus.stand_at(1, 3000);
  const int goal = Bus::kKind == ServoEmulator::Kind::Dynamixel ? 116 : 42;
  WireBench bench(machine_on<Bus>(bus, 2));
  bench.comes(DriverStatus::Lost, 0.2);
  CHECK(bus.get(1, goal, 2) == 3000);
  CHECK(bus.position(1) == 3000);
}

TEST_CASE("the bus watchdog of DYNAMIXEL servos is on while they are enabled (fault 37)") {
  ServoEmulator bus(ServoEmulator::Kind::Dynamixel, 2);
  {
    WireBench bench(machine_on<Dynamixel>(bus, 2));
    bench.comes(DriverStatus::Lost, 0.1);
    CHECK(bus.get(2, 98, 1) == 5);  // · 20 ms
    CHECK(bus.get(2, 9, 1) == 0);   // answers at once
  }
  CHECK(test::eventually([&] { return bus.get(2, 98, 1) == 0; }));
}

TEST_CASE_TEMPLATE("fault 28: a servo that falls mute is told by its id, the others are still read",
                   Bus, Dynamixel, Feetech) {
  ServoEmulator bus(Bus::kKind, 3);
  WireBench bench(machine_on<Bus>(bus));
  bench.go(all(3, 2100), 0.2);
  bus.mute = 2;
  CHECK(bench.comes(DriverStatus::Silent, 2));
  CHECK(bench.comes(DriverStatus::Silent, 2));
  CHECK(mentions(bench.machine().trouble(), "servo 2 (axis y) does not answer"));
  bus.mute = 0;
  CHECK(bench.comes(DriverStatus::Ok, 2));
}

TEST_CASE_TEMPLATE("fault 23: pulled out it is lost, and stays so", Bus, Dynamixel, Feetech) {
  ServoEmulator bus(Bus::kKind, 2);
  WireBench bench(machine_on<Bus>(bus, 2));
  bus.unplug();
  CHECK(bench.comes(DriverStatus::Lost, 2));
  CHECK(mentions(bench.machine().trouble(), "is gone"));
  CHECK(bench.comes(DriverStatus::Lost, 0.1));
}

TEST_CASE_TEMPLATE("faults 24, 25: noise and bad checks are overcome within the cycle, and counted",
                   Bus, Dynamixel, Feetech) {
  ServoEmulator bus(Bus::kKind, 2);
  WireBench bench(machine_on<Bus>(bus, 2));
  bus.garbage = 20;
  bus.corrupt = 10;
  bench.go(all(2, 2300), 1.5);
  CHECK(bench.count(DriverStatus::Ok) > 4 * bench.count(DriverStatus::Silent));
  CHECK(bench.count(DriverStatus::Lost) == 0);
  CHECK(bench.state().wire_errors > 0.05);
  CHECK(std::abs(bus.position(1) - 2300) < 30);
  bus.garbage = 0;
  bus.corrupt = 100;
  CHECK(bench.comes(DriverStatus::Silent, 2));
}

TEST_CASE_TEMPLATE("fault 26: half answers are not joined to what comes later", Bus, Dynamixel,
                   Feetech) {
  ServoEmulator bus(Bus::kKind, 2);
  WireBench bench(machine_on<Bus>(bus, 2));
  bus.halved = 100;
  CHECK(bench.comes(DriverStatus::Silent, 2));
  bus.halved = 0;
  CHECK(bench.comes(DriverStatus::Ok, 2));
  for (int i = 0; i < 20; ++i) bench.cycle(all(2, 2048));
  CHECK(bench.state().measured.q[0] == 2048);
}

TEST_CASE_TEMPLATE("fault 27: an answer that comes too late is not taken for the next one", Bus,
                   Dynamixel, Feetech) {
  ServoEmulator bus(Bus::kKind, 2);
  WireBench bench(machine_on<Bus>(bus, 2));
  bus.late_ms = 60;
  CHECK(bench.comes(DriverStatus::Silent, 2));
  CHECK(bench.count(DriverStatus::Alarm) == 0);
  bus.late_ms = 0;
  CHECK(bench.comes(DriverStatus::Ok, 3));
}

TEST_CASE_TEMPLATE("fault 31: a servo that has restarted is not driven on", Bus, Dynamixel,
                   Feetech) {
  ServoEmulator bus(Bus::kKind, 2);
  WireBench bench(machine_on<Bus>(bus, 2));
  bench.comes(DriverStatus::Alarm, 0.2);
  bus.restart(1);
  CHECK(bench.comes(DriverStatus::Alarm, 3));
  CHECK(mentions(bench.machine().trouble(), "servo 1 (axis x)"));
  CHECK_FALSE(bus.torque(1));
}

TEST_CASE("a hardware alert of a DYNAMIXEL servo is told in words") {
  ServoEmulator bus(ServoEmulator::Kind::Dynamixel, 2);
  WireBench bench(machine_on<Dynamixel>(bus, 2));
  bus.set(2, 70, 1, 0x20);
  CHECK(bench.comes(DriverStatus::Alarm, 3));
  CHECK(mentions(bench.machine().trouble(), "servo 2 (axis y): overload"));
}

TEST_CASE_TEMPLATE("a servo in the wrong mode, or missing, is refused by its id", Bus, Dynamixel,
                   Feetech) {
  ServoEmulator bus(Bus::kKind, 2);
  CHECK(mentions(test::trouble_opening(*machine_on<Bus>(bus, 3)), "servo 3 (axis z)"));
  bus.set(2, Bus::kKind == ServoEmulator::Kind::Dynamixel ? 11 : 33, 1, 1);
  CHECK(mentions(test::trouble_opening(*machine_on<Bus>(bus, 2)), "servo 2 (axis y) is in mode 1"));
}

TEST_CASE_TEMPLATE("limits of the servos are those of the axes", Bus, Dynamixel, Feetech) {
  ServoEmulator bus(Bus::kKind, 1);
  const bool dynamixel = Bus::kKind == ServoEmulator::Kind::Dynamixel;
  bus.set(1, dynamixel ? 52 : 9, 2, 900);
  bus.set(1, dynamixel ? 48 : 11, 2, 3000);
  const auto machine = machine_on<Bus>(bus, 1);
  REQUIRE(test::trouble_opening(*machine) == "");
  CHECK(machine->least(0) == 900);
  CHECK(machine->most(0) == 3000);
}

TEST_CASE("SCS servos: big-endian numbers, asked one by one") {
  ServoEmulator bus(FeetechScs::kKind, 3);
  bus.stand_at(2, 700);
  bus.set(1, 9, 2, 260);
  bus.set(1, 11, 2, 900);
  {
    WireBench bench(machine_on<FeetechScs>(bus));
    CHECK(bench.machine().position()[1] == 700);
    CHECK(bench.machine().least(0) == 260);
    CHECK(bench.machine().most(0) == 900);
    bench.go(all(3, 300), 0.5);
    CHECK(bus.torque(3));
    bench.comes(DriverStatus::Lost, 0.3);
    for (const int id : {1, 2, 3}) CHECK(std::abs(bus.position(id) - 300) < 1);
    CHECK(bench.state().measured.q[2] == doctest::Approx(300).epsilon(0.001));
    CHECK(bench.state().wire_errors == 0);
    bus.mute = 3;
    CHECK(bench.comes(DriverStatus::Silent, 2));
    bench.comes(DriverStatus::Lost, 0.1);
    CHECK(mentions(bench.machine().trouble(), "servo 3 (axis z) does not answer"));
  }
  CHECK(test::eventually([&] { return !bus.torque(1); }));
}

TEST_CASE("an SCS servo without limits is a wheel, and refused") {
  ServoEmulator bus(FeetechScs::kKind, 1);
  bus.set(1, 11, 2, 0);
  CHECK(mentions(test::trouble_opening(*machine_on<FeetechScs>(bus, 1)), "turns as a wheel"));
}

TEST_CASE("the tick takes no memory") {
  ServoEmulator bus(ServoEmulator::Kind::Feetech, 2);
  const auto machine = machine_on<Feetech>(bus, 2);
  machine->open();
  motion::ServoState state;
  motion::ServoCommand command;
  command.reference.q = command.reference.qd = all(2, 2048);
  test::NoAllocation guard;
  machine->enable(0);
  for (int i = 0; i < 10; ++i) {
    machine->read(0.01 * i, state);
    command.reference.time = 0.01 * i;
    machine->write(0.01 * i, command);
  }
  machine->disable(0.1);
  CHECK(guard.count() == 0);
}

TEST_CASE("the period is what the bus can do") {
  const auto axes = test::plain_axes(6, 1);
  CHECK(dynamixel_link(axes, 1000000)->least_period() < 1.0 / 200);
  CHECK(dynamixel_link(axes, 57600)->least_period() > 0.031);  // drivers of six servos: 178 bytes
}

TEST_CASE("six DYNAMIXEL servos run at the 57,600 baud that they have from the factory") {
  ServoEmulator bus(ServoEmulator::Kind::Dynamixel, 6);
  bus.baud = 57600;
  const auto axes = test::plain_axes(6, 1, 3000);
  WireBench bench(std::make_unique<WireBackend>(test::settings_for(bus.path(), axes, 0.01),
                                                dynamixel_link(axes, 57600)));
  CHECK(bench.machine().asked_period() == 0.01);
  CHECK(bench.machine().period() == doctest::Approx(0.05));
  bench.go(all(6, 2300), 2);
  bench.comes(DriverStatus::Lost, 0.3);
  for (int id = 1; id <= 6; ++id) CHECK(std::abs(bus.position(id) - 2300) < 1);
  CHECK(bench.count(DriverStatus::Ok) > bench.count(DriverStatus::Silent));
  CHECK(bench.state().measured.q[5] == doctest::Approx(2300).epsilon(0.001));
}

TEST_CASE_TEMPLATE("an adapter that echoes is found, and its echo is not taken for an answer", Bus,
                   Dynamixel, Feetech, FeetechScs) {
  ServoEmulator bus(Bus::kKind, 3);
  bus.echoes = true;
  bus.stand_at(2, 700);
  WireBench bench(machine_on<Bus>(bus));
  CHECK(bench.machine().position()[1] == 700);
  bench.go(all(3, 800), 0.4);
  bench.comes(DriverStatus::Lost, 0.3);
  for (const int id : {1, 2, 3}) CHECK(std::abs(bus.position(id) - 800) < 1);
  CHECK(bench.count(DriverStatus::Alarm) == 0);
  CHECK(bench.count(DriverStatus::Ok) > 10);
}

TEST_CASE_TEMPLATE("fault 31: a servo that restarts in motion is named before it looks frozen", Bus,
                   Dynamixel, Feetech) {
  ServoEmulator bus(Bus::kKind, 6);
  WireBench bench(machine_on<Bus>(bus, 6));
  bench.go(all(6, 2100), 0.2);
  bus.restart(5);
  // From here on its goal goes away by 20 ticks a cycle: three cycles are what E503 waits for.
  const int before = bench.count(DriverStatus::Ok);
  bench.go(all(6, 3100), 1);
  CHECK(bench.count(DriverStatus::Alarm) > 0);
  CHECK(bench.count(DriverStatus::Ok) - before <= 5);
  CHECK(mentions(bench.machine().trouble(), "servo 5 (axis b) has restarted"));
}

TEST_CASE("a servo that its bus watchdog has stopped is named, with the computer that was late") {
  ServoEmulator bus(ServoEmulator::Kind::Dynamixel, 3);
  WireBench bench(machine_on<Dynamixel>(bus));
  bench.go(all(3, 2100), 0.2);
  bus.set(2, 98, 1, 255);
  bench.go(all(3, 3100), 1);
  CHECK(bench.count(DriverStatus::Alarm) > 0);
  CHECK(mentions(bench.machine().trouble(), "the bus watchdog of servo 2 (axis y) has stopped it"));
}

TEST_CASE("torque that another program has left on is taken off before settings are written") {
  ServoEmulator bus(ServoEmulator::Kind::Dynamixel, 2);
  bus.set(2, 64, 1, 1);
  bus.set(2, 116, 4, 2048);
  const auto machine = machine_on<Dynamixel>(bus, 2);
  CHECK(test::trouble_opening(*machine) == "");
  CHECK(bus.get(2, 9, 1) == 0);  // return delay, which is kept in its EEPROM
  CHECK_FALSE(bus.torque(2));
}

TEST_CASE_TEMPLATE("servos that answer, but too late, are not said to be mute", Bus, Dynamixel,
                   Feetech) {
  ServoEmulator bus(Bus::kKind, 2);
  WireBench bench(machine_on<Bus>(bus, 2));
  bench.go(all(2, 2100), 0.2);
  bus.late_ms = 30;
  CHECK(bench.comes(DriverStatus::Silent, 2));
  bool told = false;
  for (int i = 0; i < 40 && !told; ++i) {
    bench.cycle(all(2, 2100));
    told = mentions(bench.machine().trouble(), "later than the cycle permits; raise period");
  }
  CHECK(told);
}

TEST_CASE_TEMPLATE("fault 27: a position belongs to its instant, however late the answers come",
                   Bus, Dynamixel, Feetech) {
  ServoEmulator bus(Bus::kKind, 2);
  bus.speed = 1000;
  WireBench bench(machine_on<Bus>(bus, 2));
  const double zero = wire_time() - bench.now();
  int answered = 0;
  for (int i = 0; bench.now() < 5 && bus.position(2) < 3800; ++i) {
    bus.kept_ms = i % 8 < 4 ? 30 : 0;
    const DriverStatus status = bench.cycle(all(2, 4000));
    const motion::ServoState& state = bench.state();
    if (status != DriverStatus::Ok || state.measured.q[1] < 2100) continue;
    ++answered;
    const double place = bus.position_at(2, zero + state.measured.time);
    CHECK(std::abs(state.measured.q[1] - place) < bus.speed * state.spread + 2);
  }
  CHECK(answered > 5);
}

TEST_CASE_TEMPLATE("late answers while it connects are not taken for other registers", Bus,
                   Dynamixel, Feetech) {
  ServoEmulator bus(Bus::kKind, 1);
  const bool dynamixel = Bus::kKind == ServoEmulator::Kind::Dynamixel;
  bus.set(1, dynamixel ? 52 : 9, 2, 900);
  bus.set(1, dynamixel ? 48 : 11, 2, 3000);
  bus.late_ms = 60;
  const auto machine = machine_on<Bus>(bus, 1);
  REQUIRE(test::trouble_opening(*machine) == "");
  CHECK(machine->least(0) == 900);
  CHECK(machine->most(0) == 3000);
}

TEST_CASE("stamps are those of the servo's clock, though its thread waits between two looks") {
  ServoEmulator bus(ServoEmulator::Kind::Feetech, 2);
  WireBench bench(machine_on<Feetech>(bus, 2));
  bench.comes(DriverStatus::Lost, 0.3);
  motion::ServoState state;
  for (const int waits : {0, 60, 0, 40}) {
    const double looked = bench.now();
    std::this_thread::sleep_for(std::chrono::milliseconds(waits));
    bench.machine().read(looked, state);
    const double now = bench.now();
    CAPTURE(waits);
    CHECK(state.seen <= now);
    CHECK(now - state.seen < 0.038);  // a period and a half, and the wire
    CHECK(state.measured.time <= now);
    CHECK(now - state.measured.time < 0.038);
    bench.cycle(all(2, 2048));
  }
}

TEST_CASE("a tick that only reads keeps the exchange going, one that does neither ends it") {
  ServoEmulator bus(ServoEmulator::Kind::Feetech, 1);
  WireBench bench(machine_on<Feetech>(bus, 1));
  bench.comes(DriverStatus::Lost, 0.2);
  for (int i = 0; i < 20; ++i) {
    bench.look();
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  CHECK(bench.now() - bench.state().seen < 0.2);
  const int questions = bus.questions();
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  CHECK(bus.questions() - questions < 15);  // of a cycle of 20 ms, and its last 100 ms
  CHECK(bench.look() == DriverStatus::Late);
  CHECK(bench.state().late > 0.2);
}

}  // namespace rob::drivers
