#include "runtime/devices/text_devices.h"

#include <arpa/inet.h>
#include <doctest/doctest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <string>
#include <thread>

#include "motion/servo/servo_backend.h"
#include "runtime/devices/device_lines.h"

using rob::runtime::DeviceLines;
using rob::runtime::TextDevices;
using namespace std::chrono_literals;

namespace {

/// A device on this computer, played by the test.
class PlayedDevice {
 public:
  PlayedDevice() : listener_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in here{};
    here.sin_family = AF_INET;
    here.sin_addr.s_addr = ::htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof here;
    REQUIRE(::bind(listener_, reinterpret_cast<sockaddr*>(&here), size) == 0);
    REQUIRE(::listen(listener_, 1) == 0);
    REQUIRE(::getsockname(listener_, reinterpret_cast<sockaddr*>(&here), &size) == 0);
    port_ = ::ntohs(here.sin_port);
  }
  ~PlayedDevice() {
    ::close(connection_);
    ::close(listener_);
  }
  PlayedDevice(const PlayedDevice&) = delete;
  PlayedDevice& operator=(const PlayedDevice&) = delete;

  std::string address() const { return "tcp://127.0.0.1:" + std::to_string(port_); }
  void accept() { connection_ = ::accept(listener_, nullptr, nullptr); }
  void hang_up() {
    ::close(connection_);
    connection_ = -1;
  }
  void say(const std::string& bytes) const {
    REQUIRE(::send(connection_, bytes.data(), bytes.size(), MSG_NOSIGNAL) > 0);
  }
  std::string hear(std::size_t count) const {
    std::string text(count, '\0');
    const ssize_t got = ::recv(connection_, text.data(), count, MSG_WAITALL);
    text.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
    return text;
  }

 private:
  int listener_;
  int connection_ = -1;
  int port_ = 0;
};

/// Within 3 s.
bool comes_true(auto&& condition) {
  for (int i = 0; i < 300; ++i) {
    if (condition()) return true;
    std::this_thread::sleep_for(10ms);
  }
  return false;
}

}  // namespace

TEST_CASE("what a device sends is cut at its ending, however it comes") {
  DeviceLines lines("\r\n");
  lines.add("12.5 g\r");
  CHECK_FALSE(lines.take());
  lines.add("\n\r\na\rb\nc\r\nrest");
  CHECK(lines.take() == "12.5 g");
  CHECK(lines.take() == "");
  CHECK(lines.take() == "a\rb\nc");
  CHECK_FALSE(lines.take());
}

TEST_CASE("a line over 4 KiB is dropped, and the oldest beyond 64 KiB; both are counted") {
  DeviceLines lines("\n");
  lines.add(std::string(4096, 'a') + "\n");
  CHECK(lines.take() == std::string(4096, 'a'));
  lines.add(std::string(4097, 'a') + "\n" + std::string(1'000'000, 'b') + "\nshort\n");
  CHECK(lines.take_dropped() == 2);
  CHECK(lines.take() == "short");
  for (int i = 0; i < 100; ++i) lines.add(std::to_string(i) + std::string(1022, 'x') + "\n");
  CHECK(lines.take_dropped() > 30);
  std::size_t waiting = 0;
  std::string last;
  while (const auto line = lines.take()) {
    waiting += line->size();
    last = *line;
  }
  CHECK(waiting <= DeviceLines::kMostWaiting);
  CHECK(last.starts_with("99"));
}

TEST_CASE("an ending of several bytes is found across pieces, and after a line that is too long") {
  DeviceLines lines("--\n");
  for (const char byte : std::string("a-\n--\n") + std::string(5000, '-') + "\nb--\n") {
    lines.add({&byte, 1});
  }
  CHECK(lines.take() == "a-\n");
  CHECK(lines.take() == "b");
  CHECK(lines.take_dropped() == 1);
}

TEST_CASE("of a connection that is lost no half line is left, however long it was") {
  DeviceLines lines("\n");
  lines.add("whole\n12");
  lines.break_off();
  lines.add("34.5 g\n");
  CHECK(lines.take() == "whole");
  CHECK(lines.take() == "34.5 g");
  lines.add(std::string(5000, 'x'));
  lines.break_off();
  lines.add("next\n");
  CHECK(lines.take() == "next");
  CHECK(lines.take_dropped() == 0);
}

TEST_CASE("bytes that are not UTF-8 become U+FFFD") {
  DeviceLines lines("\n");
  lines.add("a\xFF\xC3\xA4\n");
  CHECK(lines.take() == "a\xEF\xBF\xBD\xC3\xA4");
}

TEST_CASE("a device gets what is sent, and SEND drops what came before") {
  PlayedDevice played;
  TextDevices devices({{"scale", played.address(), "\n", {}}});
  std::thread accepting([&] { played.accept(); });
  devices.connect();
  accepting.join();
  CHECK_FALSE(devices.objection(0));
  played.say("old\n");
  std::this_thread::sleep_for(100ms);
  devices.sending(0);
  CHECK(devices.sends_pending(0));
  devices.send(0, "W");
  CHECK_FALSE(devices.sends_pending(0));
  CHECK(played.hear(2) == "W\n");
  played.say("12.5 g\n");
  std::optional<std::string> line;
  CHECK(comes_true([&] { return (line = devices.take(0, 0)).has_value(); }));
  CHECK(line == "12.5 g");
}

TEST_CASE("a connection that is lost is an objection, and is made again") {
  PlayedDevice played;
  TextDevices devices({{"scale", played.address(), "\n", {}}});
  std::thread accepting([&] { played.accept(); });
  devices.connect();
  accepting.join();
  played.hang_up();
  CHECK(comes_true([&] { return devices.objection(0).has_value(); }));
  CHECK(devices.objection(0)->code == "E365");
  played.accept();
  CHECK(comes_true([&] { return !devices.objection(0); }));
}

TEST_CASE("half a line of a connection is not joined with the first one of the next") {
  PlayedDevice played;
  TextDevices devices({{"scale", played.address(), "\n", {}}});
  std::thread accepting([&] { played.accept(); });
  devices.connect();
  accepting.join();
  played.say("ok\n12");
  std::optional<std::string> line;
  CHECK(comes_true([&] { return (line = devices.take(0, 0)).has_value(); }));
  CHECK(line == "ok");
  played.hang_up();
  played.accept();
  played.say("34.5 g\n");
  CHECK(comes_true([&] { return (line = devices.take(0, 0)).has_value(); }));
  CHECK(line == "34.5 g");
}

TEST_CASE("lines of a flood are told of once a second, and all of them in the end") {
  PlayedDevice played;
  TextDevices devices({{"scale", played.address(), "\n", {}}});
  std::thread accepting([&] { played.accept(); });
  devices.connect();
  accepting.join();
  constexpr int kLines = 30;
  std::size_t told = 0;
  std::size_t times = 0;
  const auto hear = [&](const std::vector<std::string>& events) {
    for (const std::string& event : events) told += std::stoul(event.substr(14));
    times += events.size();
  };
  const auto begun = std::chrono::steady_clock::now();
  for (int i = 0; i < kLines; ++i) {
    played.say(std::string(5000, 'x') + "\n");
    std::this_thread::sleep_for(10ms);
    hear(devices.take_events());
  }
  const auto took = std::chrono::steady_clock::now() - begun;
  CHECK(times <= 1 + static_cast<std::size_t>(took / 1s));
  CHECK(comes_true([&] {
    hear(devices.take_events(TextDevices::Telling::All));
    return told == kLines;
  }));
}

TEST_CASE("on the virtual clock a text is cut into lines as on a wire") {
  TextDevices devices({{"scale", "tcp://nowhere:1", "\n", {}}});
  devices.give(0, 1, "a\n" + std::string(4097, 'x') + "\nb");
  CHECK(devices.take(0, 1) == "a");
  CHECK(devices.take(0, 1) == "b");
  CHECK_FALSE(devices.take(0, 1));
  CHECK(devices.take_events() ==
        std::vector<std::string>{"DEVICE scale: 1 line dropped: longer than 4 KiB, or nobody has "
                                 "received them"});
  CHECK(devices.take_events().empty());
}

TEST_CASE("on the virtual clock lines come at their times, each for one RECEIVE") {
  TextDevices devices({{"scale", "tcp://nowhere:1", "\n", {}}});
  devices.give(0, 2, "second");
  devices.give(0, 1, "first");
  CHECK_FALSE(devices.take(0, 0.5));
  CHECK(devices.take(0, 1) == "first");
  devices.sending(0);
  devices.send(0, "W");
  CHECK(devices.any_left(0));
  CHECK(devices.take(0, 5) == "second");
  CHECK_FALSE(devices.any_left(0));
}
