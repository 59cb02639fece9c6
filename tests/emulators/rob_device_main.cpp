// The reference device of docs/serial-protocol.md as a program of its own: `rob_device AXES
// SECONDS` prints the path of its port, moves axes that are not there, and writes "Q SECONDS v…"
// lines with where they are when it ends.
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "drivers/device/rob_device.h"
#include "drivers/serial/serial_port.h"
#include "tests/support/pty_wire.h"

int main(int argc, char** argv) {
  if (argc != 3) return 64;
  const rob::test::PtyWire wire;
  rob::drivers::RobDevice device({.axes = std::atoi(argv[1])});
  std::printf("%s\n", wire.path().c_str());
  std::fflush(stdout);
  const double begun = rob::drivers::wire_time();
  for (double passed = 0; passed < std::atof(argv[2]); passed = rob::drivers::wire_time() - begun) {
    const std::vector<std::uint8_t> bytes = wire.receive(1);
    // Its clock wraps after 5 s.
    const auto now = static_cast<std::uint32_t>(passed * 1e6) - 5'000'000U;
    device.receive(bytes, now);
    const rob::drivers::wire::Wire out = device.send();
    wire.send({out.view().begin(), out.view().end()});
    device.step(now);
  }
  std::printf("Q");
  for (int i = 0; i < std::atoi(argv[1]); ++i)
    std::printf(" %.6f", device.position()[static_cast<std::size_t>(i)] / 1e6);
  std::printf("\n");
  return 0;
}
