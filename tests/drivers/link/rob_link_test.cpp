#include "drivers/link/rob_link.h"

#include <doctest/doctest.h>

#include <atomic>
#include <thread>

#include "drivers/device/rob_device.h"
#include "tests/drivers/link/wire_bench.h"
#include "tests/emulators/device_process.h"
#include "tests/support/no_allocation.h"
#include "tests/support/pty_wire.h"

namespace rob::drivers {
namespace {

using motion::DriverStatus;
using test::all;
using test::DeviceProcess;
using test::mentions;
using test::WireBench;

std::unique_ptr<WireBackend> machine_on(const std::string& path, int count = 2) {
  const auto axes = test::plain_axes(count, 0);
  return std::make_unique<WireBackend>(test::settings_for(path, axes, 0.02), rob_link(axes, 0.02));
}

wire::Frame only_frame(RobDevice& device) {
  FrameReader<wire::Format> reader;
  wire::Frame frame;
  const wire::Wire out = device.send();
  reader.add(out.view());
  REQUIRE(reader.next(frame));
  return frame;
}

/// A device, spoken to without a wire.
struct Spoken {
  RobDevice device{{.axes = 1}};
  std::uint32_t now = 4294960000U;  // it wraps on the way
  std::uint8_t sequence = 0;

  wire::State say(wire::Type type, Bytes payload = {}) {
    device.receive(wire::encode(type, ++sequence, payload).view(), now);
    const wire::Frame frame = only_frame(device);
    CHECK(frame.sequence == sequence);
    wire::State state;
    if (frame.type == wire::Type::State) CHECK(wire::parse(frame.payload.view(), 1, state));
    return state;
  }
  wire::State enable() {
    const std::uint8_t on = 1;
    return say(wire::Type::Enable, {&on, 1});
  }
  wire::State refer(std::uint32_t ahead, std::int32_t position, std::int32_t velocity) {
    const wire::Reference reference{now + ahead, 10000, {position}, {velocity}};
    return say(wire::Type::Reference, wire::payload_of(reference, 1).view());
  }
  void pass(std::uint32_t microseconds) {
    for (std::uint32_t i = 0; i < microseconds; i += 100) device.step(now += 100);
  }
};

}  // namespace

TEST_CASE("a device in its own process goes where it is told, over the wrap of its clock") {
  // Its watchdog acts where this computer lets it wait for three periods: that trial is repeated.
  constexpr double kWatchdog = 3 * 0.02;
  for (int trial = 0; trial < 30; ++trial) {
    DeviceProcess device(2);
    WireBench bench(machine_on(device.path()));
    bench.go(all(2, 5e6), 0.7);
    bench.go(all(2, 0), 0.7);
    bench.comes(DriverStatus::Lost, 0.2);
    const DeviceProcess::End end = device.finish();
    if (end.silence > kWatchdog) continue;
    CHECK(bench.count(DriverStatus::Alarm) == 0);
    CHECK(bench.count(DriverStatus::Lost) == 0);
    CHECK(std::abs(bench.state().measured.q[0]) < 1);
    CHECK(end.places == std::vector<double>{0, 0});
    return;
  }
  FAIL("this computer never had three periods of 20 ms for it");
}

TEST_CASE("fault 23: a device process that is killed is lost") {
  DeviceProcess device(2);
  WireBench bench(machine_on(device.path()));
  bench.go(all(2, 1e6), 0.2);
  device.end();
  CHECK(bench.comes(DriverStatus::Lost, 3));
}

TEST_CASE("fault 31: a device that has switched off its drives is not put under force again") {
  const test::PtyWire wire;
  std::atomic<bool> ended = false, switches_off = false, off = false;
  std::atomic<int> again = 0;
  std::thread runs([&] {
    RobDevice device({.axes = 2});
    while (!ended) {
      const std::vector<std::uint8_t> bytes = wire.receive(1);
      const auto now = static_cast<std::uint32_t>(wire_time() * 1e6);
      device.receive(bytes, now);
      const wire::Wire out = device.send();
      wire.send({out.view().begin(), out.view().end()});
      again += off && device.enabled() ? 1 : 0;
      if (!switches_off.exchange(false)) continue;
      constexpr std::uint8_t kWithoutForce = 0;  // as its own emergency stop does
      device.receive(wire::encode(wire::Type::Stop, 0, {&kWithoutForce, 1}).view(), now);
      device.send();
      off = true;
    }
  });
  WireBench bench(machine_on(wire.path()));
  bench.go(all(2, 0), 0.2);
  switches_off = true;
  CHECK(bench.comes(DriverStatus::Alarm, 2));
  CHECK(mentions(bench.machine().trouble(), "was switched off its drives"));
  bench.go(all(2, 0), 0.5);
  ended = true;
  runs.join();
  CHECK(off);
  CHECK(again == 0);
}

TEST_CASE("a device with other axes than the robot is refused") {
  const DeviceProcess device(3);
  CHECK(mentions(test::trouble_opening(*machine_on(device.path(), 2)), "has 3 axes, the robot 2"));
}

TEST_CASE("the device never moves before HELLO and ENABLE") {
  Spoken spoken;
  spoken.refer(5000, 1000, 0);
  spoken.pass(20000);
  CHECK(spoken.device.position()[0] == 0);
  CHECK((spoken.enable().flags & wire::State::kEnabled) == 0);  // no HELLO
  spoken.say(wire::Type::Hello);
  spoken.refer(5000, 1000, 0);
  spoken.pass(20000);
  CHECK(spoken.device.position()[0] == 0);  // no ENABLE
  CHECK((spoken.enable().flags & wire::State::kEnabled) != 0);
  spoken.refer(5000, 1000, 0);
  spoken.pass(6000);
  CHECK(spoken.device.position()[0] == 1000);
}

TEST_CASE("between references the device is on the cubic through places and velocities") {
  Spoken spoken;
  spoken.say(wire::Type::Hello);
  spoken.enable();
  spoken.refer(10000, 0, 0);
  spoken.refer(20000, 10000, 2000000);
  spoken.pass(15000);
  // s = 1/2: way/2 − v·T/8 = 5000 − 2000000·0.01/8 = 2500
  CHECK(spoken.device.position()[0] == doctest::Approx(2500).epsilon(0.001));
}

TEST_CASE("references of the past are counted, and not carried out") {
  Spoken spoken;
  spoken.say(wire::Type::Hello);
  spoken.enable();
  spoken.refer(static_cast<std::uint32_t>(-5000), 7000, 0);
  spoken.pass(20000);
  CHECK(spoken.device.late() == 1);
  CHECK(spoken.device.position()[0] == 0);
}

TEST_CASE("fault 37: without references the device brakes by itself, and is enabled by command") {
  Spoken spoken;
  spoken.say(wire::Type::Hello);
  spoken.enable();
  for (int i = 1; i <= 5; ++i) {
    spoken.refer(10000, 100 * i, 10000);  // 10 mm/s
    spoken.pass(10000);
  }
  const std::int32_t there = spoken.device.position()[0];
  spoken.pass(200000);
  CHECK_FALSE(spoken.device.enabled());
  CHECK(spoken.device.velocity()[0] == 0);
  // 3 periods of 10 ms at 10 mm/s, the one on its way, and what braking takes.
  CHECK(spoken.device.position()[0] - there < 600);
  CHECK((spoken.enable().flags & wire::State::kStarved) != 0);
  CHECK_FALSE(spoken.device.enabled());
  spoken.say(wire::Type::Hello);
  spoken.enable();
  CHECK(spoken.device.enabled());
}

TEST_CASE("the device takes no memory, whatever comes") {
  RobDevice device({.axes = 6});
  std::array<std::uint8_t, 2000> noise;
  unsigned value = 1;
  for (std::uint8_t& byte : noise) byte = static_cast<std::uint8_t>((value *= 1103515245U) >> 16U);
  test::NoAllocation guard;
  device.receive(noise, 0);
  device.receive(wire::encode(wire::Type::Hello, 1, {}).view(), 1);
  device.step(2);
  CHECK(guard.count() == 0);
  CHECK(device.send().size() > 0);
}

}  // namespace rob::drivers
