#include "drivers/serial/tcp_port.h"

#include <doctest/doctest.h>

#include <array>
#include <memory>
#include <string>

#include "drivers/serial/open_port.h"
#include "motion/servo/servo_backend.h"
#include "tests/emulators/tcp_bridge.h"
#include "tests/support/eventually.h"
#include "tests/support/pty_wire.h"

namespace rob::drivers {
namespace {

using Status = WireIo::Status;

std::string tcp_trouble(const std::string& address) {
  try {
    const TcpPort port(address);
  } catch (const motion::DriverError& error) {
    return error.what();
  }
  return "";
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("bytes go both ways through a network connection, as through a serial port") {
  const test::PtyWire device;
  const test::TcpBridge bridge(device.path());
  const auto port = open_port(bridge.address(), 0);
  CHECK(port->path() == bridge.address());
  const std::array<std::uint8_t, 3> sent{0, 255, 10};
  CHECK(port->write(sent, wire_time() + 5).bytes == 3);
  CHECK(device.receive(5000) == std::vector<std::uint8_t>{0, 255, 10});
  device.send({7, 13, 17});
  std::array<std::uint8_t, 3> got{};
  for (std::size_t count = 0; count < 3;) {
    const WireIo io = port->read(std::span(got).subspan(count), wire_time() + 5);
    REQUIRE(io.status == Status::Ok);
    count += io.bytes;
  }
  CHECK(got == std::array<std::uint8_t, 3>{7, 13, 17});
  CHECK(port->read(got, wire_time() + 0.01).status == Status::TimedOut);
}

TEST_CASE("fault 23: a connection that breaks is gone, and is not made again") {
  const test::PtyWire device;
  test::TcpBridge bridge(device.path());
  TcpPort port(bridge.address());
  REQUIRE(test::eventually([&] { return bridge.connections() == 1; }));
  bridge.cut();
  std::array<std::uint8_t, 8> bytes{};
  CHECK(port.read(bytes, wire_time() + 5).status == Status::Gone);
  CHECK(port.read(bytes, wire_time() + 5).status == Status::Gone);
  for (int i = 0; i < 20; ++i) port.write(bytes, wire_time() + 0.01);  // no signal ends the process
  CHECK(port.write(bytes, wire_time() + 1).status == Status::Gone);
  CHECK(bridge.connections() == 1);
}

TEST_CASE("an address that is none, and a host that does not answer, are refused with a remedy") {
  for (const char* text : {"tcp://", "tcp://host", "tcp://:23", "tcp://host:", "tcp://host:0",
                           "tcp://host:65536", "tcp://host:telnet"})
    CHECK(contains(tcp_trouble(text), "is no network address; write tcp://host:port"));
  CHECK(contains(tcp_trouble("tcp://no.such.host.invalid:23"), "there is no host"));
  // Nothing listens there: the port was this process' own until now.
  std::string address;
  {
    const test::PtyWire device;
    address = test::TcpBridge(device.path()).address();
  }
  CHECK(contains(tcp_trouble(address), "no connection to " + address + ": Connection refused"));
}

}  // namespace rob::drivers
