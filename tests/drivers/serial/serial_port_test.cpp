#include "drivers/serial/serial_port.h"

#include <doctest/doctest.h>
#include <grp.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <thread>

#include "drivers/serial/port_list.h"
#include "motion/servo/servo_backend.h"
#include "tests/support/pty_wire.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/without_privileges.h"

namespace rob::drivers {
namespace {

using test::PtyWire;
using Status = WireIo::Status;

std::string trouble_of(const std::string& path, int baud = 115200) {
  try {
    const SerialPort port(path, baud);
  } catch (const motion::DriverError& error) {
    return error.what();
  }
  return "";
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("bytes go both ways as they are") {
  PtyWire wire;
  SerialPort port(wire.path(), 115200);
  std::array<std::uint8_t, 256> sent;
  for (unsigned i = 0; i < 256; ++i) sent[i] = static_cast<std::uint8_t>(i);
  CHECK(port.write(sent, wire_time() + 5).bytes == 256);
  std::vector<std::uint8_t> came;
  while (came.size() < 256) {
    const auto part = wire.receive(5000);
    REQUIRE_FALSE(part.empty());
    came.insert(came.end(), part.begin(), part.end());
  }
  CHECK(std::equal(came.begin(), came.end(), sent.begin()));

  wire.send(came);
  std::array<std::uint8_t, 512> got;
  std::size_t count = 0;
  while (count < 256) {
    const WireIo io = port.read(std::span(got).subspan(count), wire_time() + 5);
    REQUIRE(io.status == Status::Ok);
    count += io.bytes;
  }
  CHECK(std::equal(came.begin(), came.end(), got.begin()));
}

TEST_CASE("a byte that comes alone ends the wait for it") {
  PtyWire wire;
  SerialPort port(wire.path(), 115200);
  std::thread sender([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    wire.send({7});
  });
  std::array<std::uint8_t, 8> bytes{};
  const double before = wire_time();
  const WireIo io = port.read(bytes, before + 20);
  sender.join();
  CHECK(io.status == Status::Ok);
  CHECK(io.bytes == 1);
  CHECK(wire_time() - before < 10);
}

TEST_CASE("nothing waits longer than its deadline") {
  PtyWire wire;
  SerialPort port(wire.path(), 115200);
  std::array<std::uint8_t, 8> bytes;
  const double before = wire_time();
  CHECK(port.read(bytes, before + 0.02).status == Status::TimedOut);
  CHECK(wire_time() - before >= 0.02);
  // Nobody reads: the terminal takes some kilobytes, and then no more.
  const std::vector<std::uint8_t> much(1 << 20);
  const WireIo io = port.write(much, wire_time() + 0.05);
  CHECK(io.status == Status::TimedOut);
  CHECK(io.bytes < much.size());
}

TEST_CASE("fault 23: a port that is pulled out is gone for reading and writing, at once") {
  PtyWire wire;
  SerialPort port(wire.path(), 115200);
  wire.unplug();
  std::array<std::uint8_t, 8> bytes{};
  const double before = wire_time();
  CHECK(port.read(bytes, before + 10).status == Status::Gone);
  CHECK(port.write(bytes, before + 10).status == Status::Gone);
  CHECK(wire_time() - before < 5);
}

TEST_CASE("what has come before is forgotten on command") {
  PtyWire wire;
  SerialPort port(wire.path(), 115200);
  wire.send({1, 2, 3});
  std::array<std::uint8_t, 1> byte;
  REQUIRE(port.read(byte, wire_time() + 5).status == Status::Ok);
  port.discard_input();
  CHECK(port.read(byte, wire_time()).status == Status::TimedOut);
}

TEST_CASE("a port that is not there, and what is none, are refused with a remedy") {
  CHECK(has(trouble_of("/dev/ttyNothing9"), "there is no port '/dev/ttyNothing9'"));
  CHECK(has(trouble_of("/dev/null"), "'/dev/null' is no serial port"));
  PtyWire wire;
  CHECK(has(trouble_of(wire.path(), 12345), "cannot do 12345 baud"));
}

TEST_CASE("fault 33: a port that is used is refused, and the process is named") {
  PtyWire wire;
  auto port = std::make_unique<SerialPort>(wire.path(), 115200);
  const std::string trouble = trouble_of(wire.path());
  CHECK(has(trouble, "is used by"));
  CHECK(has(trouble, "process " + std::to_string(::getpid())));
  port.reset();
  CHECK(trouble_of(wire.path()) == "");
}

namespace {

/// What a user without any right is told of the port; runs in a process of its own.
std::string told_to_nobody(const std::string& path) {
  int ends[2];
  REQUIRE(::pipe(ends) == 0);
  const pid_t child = ::fork();
  if (child == 0) {
    const bool other = ::setgroups(0, nullptr) == 0 && ::setgid(65534) == 0 && ::setuid(65534) == 0;
    const std::string trouble = other ? trouble_of(path) : "still root";
    const ssize_t written = ::write(ends[1], trouble.data(), trouble.size());
    ::_exit(written == static_cast<ssize_t>(trouble.size()) ? 0 : 1);
  }
  ::close(ends[1]);
  std::string told;
  char part[256];
  for (ssize_t count = 0; (count = ::read(ends[0], part, sizeof part)) > 0;)
    told.append(part, static_cast<std::size_t>(count));
  ::close(ends[0]);
  int status = 1;
  ::waitpid(child, &status, 0);
  CHECK(status == 0);
  return told;
}

void belong_to(const std::string& path, const char* name, mode_t mode) {
  const group* const found = ::getgrnam(name);
  REQUIRE(found != nullptr);
  REQUIRE(::chown(path.c_str(), 0, found->gr_gid) == 0);
  REQUIRE(::chmod(path.c_str(), mode) == 0);
}

}  // namespace

TEST_CASE("a port that may not be used names its group, if that exists for devices") {
  if (::geteuid() != 0) return;  // only root can become somebody else
  const PtyWire wire;
  for (const char* name : {"dialout", "uucp", "plugdev"}) {
    belong_to(wire.path(), name, 0660);
    const std::string told = told_to_nobody(wire.path());
    CAPTURE(told);
    CHECK(has(told, std::string("it needs the group ") + name));
    CHECK(has(told, std::string("sudo usermod -aG ") + name + " $USER"));
  }
}

TEST_CASE("nobody is advised to join a group that gives more than a port") {
  if (::geteuid() != 0) return;
  const PtyWire wire;
  for (const char* name : {"root", "tty", "disk"}) {
    belong_to(wire.path(), name, 0660);
    const std::string told = told_to_nobody(wire.path());
    CAPTURE(told);
    CHECK_FALSE(has(told, "usermod"));
    CHECK(has(told, std::string("it belongs to root:") + name + ", mode 0660"));
  }
  belong_to(wire.path(), "dialout", 0600);  // its members may not use it either
  const std::string told = told_to_nobody(wire.path());
  CHECK_FALSE(has(told, "usermod"));
  CHECK(has(told, "it belongs to root:dialout, mode 0600"));
}

TEST_CASE("a port in the list that may be read or written only is not free") {
  const test::ScratchFolder scratch;
  const std::string port = scratch.file("ttyUSB0");
  std::ofstream{port};
  const auto state = [&](std::filesystem::perms permissions) {
    std::filesystem::permissions(port, permissions);
    return list_ports(scratch.path().string()).at(0).state;
  };
  using std::filesystem::perms;
  const auto refused = [&](std::filesystem::perms permissions) {
    return state(permissions).starts_with("not permitted: belongs to ");
  };
  CHECK(test::true_without_privileges([&] { return refused(perms::owner_read); }));
  CHECK(test::true_without_privileges([&] { return refused(perms::owner_write); }));
  CHECK(test::true_without_privileges([&] { return state(perms(0600)) == "free"; }));
}

TEST_CASE("ports are listed once, with the name that stays") {
  const test::ScratchFolder scratch;
  const std::filesystem::path dev = scratch.path();
  for (const char* name : {"ttyUSB1", "ttyACM0", "ttyS0", "null"}) std::ofstream(dev / name) << "";
  std::filesystem::create_directories(dev / "serial/by-id");
  std::filesystem::create_symlink("../../ttyUSB1", dev / "serial/by-id/usb-FTDI-1234");
  const std::vector<PortEntry> ports = list_ports(dev.string());
  REQUIRE(ports.size() == 2);
  CHECK(ports[0].path == std::filesystem::canonical(dev / "ttyACM0").string());
  CHECK(ports[0].by_id == "");
  CHECK(has(ports[1].by_id, "usb-FTDI-1234"));
  CHECK(ports[0].state == "free");
  CHECK(list_ports("/nowhere").empty());
}

}  // namespace rob::drivers
