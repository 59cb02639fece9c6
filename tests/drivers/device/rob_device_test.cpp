#include "drivers/device/rob_device.h"

#include <doctest/doctest.h>

#include <array>
#include <cstdint>

#include "tests/support/no_allocation.h"

namespace rob::drivers {
namespace {

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

// ---- what docs/serial-protocol.md leaves to no device

TEST_CASE("an ENABLE that comes twice is one, and does not feed the watchdog") {
  Spoken spoken;
  spoken.say(wire::Type::Hello);
  spoken.enable();
  spoken.refer(10000, 1000, 0);
  spoken.pass(20000);
  for (int i = 0; i < 3; ++i) {
    CHECK((spoken.enable().flags & wire::State::kEnabled) != 0);
    CHECK(spoken.device.position()[0] == 1000);
    spoken.pass(25000);
  }
  spoken.pass(10000);  // 105 ms after the reference
  CHECK_FALSE(spoken.device.enabled());
  CHECK((spoken.enable().flags & wire::State::kStarved) != 0);
}

TEST_CASE("the first reference must come within a second of ENABLE") {
  for (const std::uint32_t after : {990'000U, 1'010'000U}) {
    Spoken spoken;
    spoken.say(wire::Type::Hello);
    spoken.enable();
    spoken.pass(after);
    CHECK(spoken.device.enabled() == (after < 1'000'000));
    const wire::State state = spoken.refer(10000, 1000, 0);
    CHECK(((state.flags & wire::State::kStarved) != 0) == (after > 1'000'000));
  }
}

TEST_CASE("from standing the axes go to the first reference on a cubic that begins at once") {
  Spoken spoken;
  spoken.say(wire::Type::Hello);
  spoken.enable();
  spoken.refer(20000, 8000, 0);
  spoken.pass(10000);
  CHECK(spoken.device.position()[0] == doctest::Approx(4000).epsilon(0.01));  // half of the way
  spoken.pass(10000);
  CHECK(spoken.device.position()[0] == 8000);
}

TEST_CASE("after a pause the axes go on from where they are, as from standing") {
  Spoken spoken;
  spoken.say(wire::Type::Hello);
  spoken.enable();
  spoken.refer(10000, 1000, 0);
  spoken.pass(80000);  // it has stood at 1000 for 70 ms
  spoken.refer(20000, 9000, 0);
  std::int32_t before = spoken.device.position()[0];
  for (int i = 0; i < 200; ++i) {
    spoken.pass(100);
    const std::int32_t step = spoken.device.position()[0] - before;
    CHECK(step <= 60 + 1);  // 1.5·way/T·0.1 ms, the greatest speed of the cubic
    before = spoken.device.position()[0];
  }
  CHECK(before == 9000);
}

TEST_CASE("axes that have gone on from the last reference join the next one from there") {
  Spoken spoken;
  spoken.say(wire::Type::Hello);
  spoken.enable();
  spoken.refer(10000, 1000, 200000);
  spoken.pass(20000);  // 10 ms beyond it, at 200000 1e-6/s
  CHECK(spoken.device.position()[0] == 3000);
  const wire::State state = spoken.refer(10000, 7000, 200000);
  CHECK(state.position[0] == 3000);
  spoken.pass(5000);
  // s = 1/2, the same velocity at both ends: half of the way from 3000
  CHECK(spoken.device.position()[0] == doctest::Approx(5000).epsilon(0.001));
}

TEST_CASE("STATE has the position of the instant that it names") {
  Spoken spoken;
  spoken.say(wire::Type::Hello);
  spoken.enable();
  spoken.refer(10000, 0, 1000000);
  spoken.refer(20000, 10000, 1000000);  // a straight line
  spoken.pass(12000);
  spoken.now += 3000;  // no step() meanwhile
  CHECK(spoken.refer(15000, 20000, 1000000).position[0] == doctest::Approx(5000).epsilon(0.001));
}

TEST_CASE("a reference without force, and one that is late, are not carried out and do not count") {
  Spoken spoken;
  spoken.say(wire::Type::Hello);
  CHECK(spoken.refer(5000, 1000, 0).queue == 0);  // before ENABLE
  CHECK(spoken.device.late() == 0);
  spoken.enable();
  spoken.refer(10000, 1000, 0);
  spoken.pass(20000);
  // From here on all come late: they are told, and do not keep the watchdog quiet.
  for (int i = 0; i < 5; ++i) {
    const wire::State state = spoken.refer(static_cast<std::uint32_t>(-1000), 5000, 0);
    CHECK((state.flags & wire::State::kLate) != 0);
    CHECK(state.queue == 0);
    spoken.pass(20000);
  }
  CHECK(spoken.device.late() == 5);
  CHECK(spoken.device.position()[0] == 1000);
  CHECK_FALSE(spoken.device.enabled());
  CHECK((spoken.say(wire::Type::Hello), spoken.enable().flags & wire::State::kLate) == 0);
}

TEST_CASE("queue is how many references wait; a full one takes no more, a repetition is none") {
  Spoken spoken;
  spoken.say(wire::Type::Hello);
  spoken.enable();
  for (int i = 1; i <= RobDevice::kQueue; ++i) {
    const auto ahead = static_cast<std::uint32_t>(10000 * i);
    CHECK(spoken.refer(ahead, 100 * i, 0).queue == i);
    CHECK(spoken.refer(ahead, 9999, 0).queue == i);
  }
  CHECK(spoken.refer(10000 * 17, 9999, 0).queue == RobDevice::kQueue);
  spoken.pass(15000);
  CHECK(spoken.enable().queue == RobDevice::kQueue - 1);
  CHECK(spoken.device.late() == 0);
}

TEST_CASE("a frame of the wrong length, or of no type, is answered by ERROR with its type") {
  Spoken spoken;
  spoken.say(wire::Type::Hello);
  spoken.enable();
  const std::array<std::uint8_t, 5> five{1, 2, 3, 4, 5};
  for (const int type : {0x10, 0x30, 0x31, 0x02, 0x77}) {
    const Bytes payload(five);
    spoken.device.receive(
        wire::encode(static_cast<wire::Type>(type), ++spoken.sequence, payload).view(), spoken.now);
    const wire::Frame answer = only_frame(spoken.device);
    CHECK(answer.type == wire::Type::Error);
    CHECK(answer.sequence == spoken.sequence);
    REQUIRE(answer.payload.size() == 1);
    CHECK(answer.payload[0] == type);
  }
  CHECK(spoken.device.enabled());
  spoken.device.receive(wire::encode(wire::Type::Hello, 7, five).view(), spoken.now);
  CHECK(only_frame(spoken.device).type == wire::Type::Info);  // what HELLO has is passed over
}

TEST_CASE("HELLO in motion takes the force away, and begins a session without it") {
  Spoken spoken;
  spoken.say(wire::Type::Hello);
  spoken.enable();
  for (int i = 1; i <= 5; ++i) {
    spoken.refer(10000, 100 * i, 10000);
    spoken.pass(10000);
  }
  CHECK(spoken.device.velocity()[0] != 0);
  spoken.say(wire::Type::Hello);
  CHECK_FALSE(spoken.device.enabled());
  const std::int32_t there = spoken.device.position()[0];
  spoken.pass(50000);
  CHECK(spoken.device.position()[0] == there);
  CHECK((spoken.enable().flags & wire::State::kEnabled) != 0);
}

TEST_CASE(
    "STOP 1 brakes each axis and ends without force, STOP 0 ends at once; both may come twice") {
  for (const std::uint8_t category : {std::uint8_t{1}, std::uint8_t{0}}) {
    Spoken spoken;
    spoken.say(wire::Type::Hello);
    spoken.enable();
    for (int i = 1; i <= 5; ++i) {
      spoken.refer(10000, 1000 * i, 100000);  // 0.1 mm/s
      spoken.pass(10000);
    }
    for (int i = 0; i < 2; ++i) {
      const wire::State state = spoken.say(wire::Type::Stop, {&category, 1});
      CHECK(((state.flags & wire::State::kEnabled) != 0) == (category == 1));
      CHECK(((state.flags & wire::State::kMoving) != 0) == (category == 1));
    }
    spoken.enable();    // does not take back a stop that brakes
    spoken.pass(2000);  // 0.1 mm/s at 100 mm/s²: 1 ms
    CHECK(spoken.device.enabled() == (category == 0));
    CHECK(spoken.device.velocity()[0] == 0);
  }
}

TEST_CASE("STATE has the SEQ of the question, twice; its 16 bits wrap with it") {
  Spoken spoken;
  spoken.say(wire::Type::Hello);
  for (int i = 0; i < 600; ++i) CHECK(spoken.enable().last == spoken.sequence);
}

TEST_CASE("half a frame is forgotten after a pause of 20 ms") {
  Spoken spoken;
  spoken.say(wire::Type::Hello);
  const std::uint8_t on = 1;
  const wire::Wire frame = wire::encode(wire::Type::Enable, 9, {&on, 1});
  for (const std::uint32_t pause : {10'000U, 30'000U}) {
    spoken.device.receive(frame.view().first(4), spoken.now);
    spoken.pass(pause);
    spoken.device.receive(frame.view().subspan(4), spoken.now);
    CHECK((spoken.device.send().size() > 0) == (pause < 20'000));
  }
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
