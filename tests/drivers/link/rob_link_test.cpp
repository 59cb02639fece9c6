#include "drivers/link/rob_link.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

#include "drivers/device/rob_device.h"
#include "drivers/serial/open_port.h"
#include "tests/drivers/link/wire_bench.h"
#include "tests/emulators/device_process.h"
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

/// The clock of a device, µs: it wraps.
std::uint32_t microseconds_now() {
  return static_cast<std::uint32_t>(static_cast<std::uint64_t>(wire_time() * 1e6));
}

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
      const std::uint32_t now = microseconds_now();
      device.receive(bytes, now);
      const wire::Wire out = device.send();
      wire.send({out.view().begin(), out.view().end()});
      again += off && device.enabled() ? 1 : 0;
      if (!switches_off.exchange(false)) continue;
      constexpr std::uint8_t kWithoutForce = 0;  // as its own emergency stop does
      device.receive(wire::encode(wire::Type::Stop, 0, {&kWithoutForce, 1}).view(), now);
      device.send();
      device.stand_at({777});  // and its axes sink
      off = true;
    }
  });
  WireBench bench(machine_on(wire.path()));
  bench.go(all(2, 0), 0.2);
  switches_off = true;
  CHECK(bench.comes(DriverStatus::Alarm, 2));
  CHECK(mentions(bench.machine().trouble(), "has restarted, or its drives were switched off"));
  bench.go(all(2, 0), 0.5);
  CHECK(bench.state().measured.q[0] == doctest::Approx(777));
  ended = true;
  runs.join();
  CHECK(off);
  CHECK(again == 0);
}

TEST_CASE("a device that refuses a reference by ERROR has stopped the run") {
  const test::PtyWire wire;
  std::atomic<bool> ended = false;
  std::thread runs([&] {
    RobDevice device({.axes = 2});
    while (!ended) {
      std::vector<std::uint8_t> bytes = wire.receive(1);
      // To this device a reference is of a TYPE that it does not know.
      constexpr std::size_t kType = 2;
      if (bytes.size() > kType &&
          bytes[kType] == static_cast<std::uint8_t>(wire::Type::Reference)) {
        constexpr std::uint8_t kReference = 0x10;
        const wire::Wire error =
            wire::encode(wire::Type::Error, bytes[kType + 1], {&kReference, 1});
        wire.send({error.view().begin(), error.view().end()});
        continue;
      }
      device.receive(bytes, microseconds_now());
      const wire::Wire out = device.send();
      wire.send({out.view().begin(), out.view().end()});
    }
  });
  WireBench bench(machine_on(wire.path()));
  bench.go(all(2, 0), 0.2);
  CHECK(bench.comes(DriverStatus::Alarm, 2));
  CHECK(mentions(bench.machine().trouble(), "sends what this protocol does not have"));
  bench.close();
  ended = true;
  runs.join();
}

TEST_CASE("a device whose answers come cycles later, and together, is not said to be mute") {
  const test::PtyWire wire;
  RobDevice device({.axes = 1});
  const auto answer = [&](std::vector<std::uint8_t> bytes) {
    device.receive(bytes, microseconds_now());
    const wire::Wire out = device.send();
    wire.send({out.view().begin(), out.view().end()});
  };
  RobLink link(test::plain_axes(1, 0), 0.02);
  const auto port = open_port(wire.path(), 115200);
  std::atomic<bool> connected = false;
  std::thread answers([&] {
    while (!connected) answer(wire.receive(1));
  });
  link.connect(*port);
  connected = true;
  answers.join();
  WireAnswer unused;
  const auto trouble_of_a_cycle = [&] {
    CHECK(link.exchange(nullptr, wire_time() + 0.01, unused) == DriverStatus::Silent);
    return link.trouble();
  };
  for (int i = 0; i < 3; ++i) CHECK(mentions(trouble_of_a_cycle(), "does not answer"));
  answer(wire.receive(1));
  for (int i = 0; i < 5; ++i) CHECK(mentions(trouble_of_a_cycle(), "answers, but later than"));
  for (int i = 0; i < 8; ++i) trouble_of_a_cycle();
  CHECK(mentions(trouble_of_a_cycle(), "does not answer"));
}

TEST_CASE("a device with other axes than the robot is refused") {
  const DeviceProcess device(3);
  CHECK(mentions(test::trouble_opening(*machine_on(device.path(), 2)), "has 3 axes, the robot 2"));
}

TEST_CASE(
    "a device that takes fewer references a second is sent fewer, each with its true period") {
  const test::PtyWire wire;
  std::atomic<bool> ended = false;
  std::atomic<int> longest = 0;
  std::atomic<int> late = 0;
  std::thread runs([&] {
    RobDevice device({.axes = 1, .highest_rate = 20});
    FrameReader<wire::Format> reader;
    while (!ended) {
      const std::vector<std::uint8_t> bytes = wire.receive(1);
      reader.add(bytes);
      wire::Frame frame;
      wire::Reference reference;
      while (reader.next(frame))
        if (frame.type == wire::Type::Reference && wire::parse(frame.payload.view(), 1, reference))
          longest = std::max<int>(longest, reference.period);
      const std::uint32_t now = microseconds_now();
      device.receive(bytes, now);
      const wire::Wire out = device.send();
      wire.send({out.view().begin(), out.view().end()});
      device.step(now);
      late = static_cast<int>(device.late());
    }
  });
  WireBench bench(machine_on(wire.path(), 1));
  CHECK(bench.machine().period() == doctest::Approx(0.05));
  bench.go(all(1, 1e6), 1);
  bench.close();
  ended = true;
  runs.join();
  CHECK(longest == 50'000);
  CHECK(late == 0);
}

TEST_CASE("a cycle that REF has no number for is refused") {
  const DeviceProcess device(2);
  const auto axes = test::plain_axes(2, 0);
  const auto open = [&](double period) {
    WireBackend machine(test::settings_for(device.path(), axes, period), rob_link(axes, period));
    return test::trouble_opening(machine);
  };
  CHECK(open(0.06) == "");
  CHECK(mentions(open(0.1), "a cycle of 100 ms is longer than Rob's protocol permits (65 ms)"));
}

}  // namespace rob::drivers
