// What a cycle over a wire takes and how far it strays, against devices behind pseudo-terminals:
// what driver and computer add to the time on the wire (docs/performance.md).
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "drivers/link/servo_driver.h"
#include "drivers/serial/serial_port.h"
#include "tests/emulators/servo_emulator.h"

namespace {

using rob::drivers::wire_time;
using rob::drivers::WireAxis;
using rob::test::ServoEmulator;

constexpr int kServos = 6;
constexpr int kCycles = 3000;
constexpr double kDeadline = 0.1;  // s

void measure(const char* name, ServoEmulator::Kind kind, auto make) {
  ServoEmulator bus(kind, kServos);
  std::vector<WireAxis> axes;
  for (int i = 0; i < kServos; ++i) axes.push_back({"axis", i + 1, 1, 0, 4000});
  const std::unique_ptr<rob::drivers::WireLink> link = make(axes, 1000000);
  rob::drivers::SerialPort port(bus.path(), 1000000);
  link->connect(port);
  rob::drivers::WireAnswer answer;
  rob::drivers::WireCommand command;
  command.position.fill(2048);
  std::vector<double> times;
  int failed = 0;
  for (int i = 0; i < kCycles; ++i) {
    const double begun = wire_time();
    const auto status = link->exchange(&command, begun + kDeadline, answer);
    if (status != rob::motion::DriverStatus::Ok) ++failed;
    times.push_back(1e6 * (wire_time() - begun));
  }
  link->disable();
  std::ranges::sort(times);
  const auto at = [&](double share) { return times[static_cast<std::size_t>(share * kCycles)]; };
  fmt::print("| {} | {:.0f} | {:.0f} | {:.0f} | {:.0f} | {} |\n", name, at(0.5), at(0.99),
             at(0.999), times.back(), link->errors() + static_cast<std::uint32_t>(failed));
}

}  // namespace

int main() {
  fmt::print(
      "| six servos | median µs | 99 % | 99.9 % | most | repeated |\n|---|---|---|---|---|---|\n");
  measure("DYNAMIXEL", ServoEmulator::Kind::Dynamixel, rob::drivers::dynamixel_link);
  measure("Feetech", ServoEmulator::Kind::Feetech, rob::drivers::feetech_link);
}
