// The reference device of docs/serial-protocol.md as a program of its own: `rob_device AXES
// SECONDS` prints the path of its port, moves axes that are not there, and when it ends, by SIGTERM
// or after SECONDS, a line "Q v… S M": where they are, mm or deg; the longest time, s, without a
// reference while they were enabled; s from their first motion to the end of their last.
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "drivers/device/rob_device.h"
#include "drivers/serial/serial_port.h"
#include "tests/support/pty_wire.h"

namespace {

volatile std::sig_atomic_t ending = 0;

/// The longest time, s, without a reference while the device was enabled.
class Silence {
 public:
  void hear(const std::vector<std::uint8_t>& bytes, bool enabled, double now) {
    longest_ = std::max(longest_, enabled ? now - heard_ : 0);
    if (!enabled) heard_ = now;
    for (const std::uint8_t byte : bytes) {
      reader_.add({&byte, 1});
      rob::drivers::wire::Frame frame;
      while (reader_.next(frame))
        if (frame.type == rob::drivers::wire::Type::Reference) heard_ = now;
    }
  }
  double longest() const { return longest_; }

 private:
  rob::drivers::FrameReader<rob::drivers::wire::Format> reader_;
  double heard_ = 0;
  double longest_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 64;
  std::signal(SIGTERM, [](int) { ending = 1; });
  const rob::test::PtyWire wire;
  rob::drivers::RobDevice device({.axes = std::atoi(argv[1])});
  std::printf("%s\n", wire.path().c_str());
  std::fflush(stdout);
  const double begun = rob::drivers::wire_time();
  Silence silence;
  double first = -1;
  double last = 0;
  for (double passed = 0; ending == 0 && passed < std::atof(argv[2]);
       passed = rob::drivers::wire_time() - begun) {
    const std::vector<std::uint8_t> bytes = wire.receive(1);
    silence.hear(bytes, device.enabled(), passed);
    // Its clock wraps after 1 s.
    const auto now = static_cast<std::uint32_t>(passed * 1e6) - 1'000'000U;
    device.receive(bytes, now);
    const rob::drivers::wire::Wire out = device.send();
    wire.send({out.view().begin(), out.view().end()});
    device.step(now);
    if (std::ranges::any_of(device.velocity(), [](std::int32_t v) { return v != 0; })) {
      if (first < 0) first = passed;
      last = passed;
    }
  }
  std::printf("Q");
  for (int i = 0; i < std::atoi(argv[1]); ++i)
    std::printf(" %.6f", device.position()[static_cast<std::size_t>(i)] / 1e6);
  std::printf(" %.6f %.6f\n", silence.longest(), last - first);
  return 0;
}
