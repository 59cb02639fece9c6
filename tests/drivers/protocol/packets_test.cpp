#include <doctest/doctest.h>

#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "drivers/protocol/dynamixel_packet.h"
#include "drivers/protocol/feetech_packet.h"
#include "drivers/protocol/rob_frame.h"
#include "tests/support/no_allocation.h"

// Vectors of the official documents, and what must hold of any frame.

namespace rob::drivers {
namespace {

using Octets = std::vector<std::uint8_t>;

Octets hex(const std::string& text) {
  std::istringstream words(text);
  Octets bytes;
  for (std::string word; words >> word;)
    bytes.push_back(static_cast<std::uint8_t>(std::stoi(word, nullptr, 16)));
  return bytes;
}

Octets octets(Bytes bytes) { return {bytes.begin(), bytes.end()}; }

template <typename Format>
std::vector<typename Format::Frame> frames_in(const Octets& bytes, std::size_t step = 7) {
  FrameReader<Format> reader;
  std::vector<typename Format::Frame> found;
  typename Format::Frame frame;
  for (std::size_t i = 0; i < bytes.size(); i += step) {
    reader.add(Bytes(bytes).subspan(i, std::min(step, bytes.size() - i)));
    while (reader.next(frame)) found.push_back(frame);
  }
  return found;
}

/// Every format's own frame around these parameters, and what comes out of it again.
struct DynamixelFrames {
  using Format = dynamixel::Format;
  static constexpr std::size_t kMost = 80;
  static Octets encode(const Octets& p) {
    return octets(dynamixel::encode(7, dynamixel::Instruction::Write, p).view());
  }
  static Octets payload(const dynamixel::Packet& packet) {
    return packet.id == 7 ? octets(packet.parameters.view()) : Octets{0xEE};
  }
};
struct FeetechFrames {
  using Format = feetech::Format;
  static constexpr std::size_t kMost = 80;
  static Octets encode(const Octets& p) { return octets(feetech::encode(7, 3, p).view()); }
  static Octets payload(const feetech::Packet& packet) {
    return packet.id == 7 ? octets(packet.parameters.view()) : Octets{0xEE};
  }
};
struct Robs {
  using Format = wire::Format;
  static constexpr std::size_t kMost = 128;
  static Octets encode(const Octets& p) {
    return octets(wire::encode(wire::Type::State, 7, p).view());
  }
  static Octets payload(const wire::Frame& frame) {
    return frame.sequence == 7 ? octets(frame.payload.view()) : Octets{0xEE};
  }
};

Octets random_octets(std::mt19937& random, std::size_t most) {
  // FF and FD are frequent, so that headers and stuffing occur by themselves.
  static constexpr std::uint8_t kFrequent[] = {0xFF, 0xFF, 0xFD, 0xA5, 0x5A, 0x00};
  Octets bytes(std::uniform_int_distribution<std::size_t>(0, most)(random));
  for (std::uint8_t& byte : bytes) {
    const unsigned draw = random() % 512;
    byte = static_cast<std::uint8_t>(draw < 256 ? draw : kFrequent[draw % 6]);
  }
  return bytes;
}

}  // namespace

TEST_CASE("the vectors of the DYNAMIXEL protocol") {
  using namespace dynamixel;
  CHECK(octets(ping(1).view()) == hex("FF FF FD 00 01 03 00 01 19 4E"));
  CHECK(octets(read(1, 132, 4).view()) == hex("FF FF FD 00 01 07 00 02 84 00 04 00 1D 15"));
  CHECK(octets(write(1, 116, 512, 4).view()) ==
        hex("FF FF FD 00 01 09 00 03 74 00 00 02 00 00 CA 89"));
  CHECK(octets(sync_read(132, 4, hex("01 02")).view()) ==
        hex("FF FF FD 00 FE 09 00 82 84 00 04 00 01 02 CE FA"));
  CHECK(octets(encode(kEveryone, Instruction::SyncWrite,
                      hex("74 00 04 00 01 96 00 00 00 02 AA 00 00 00"))
                   .view()) ==
        hex("FF FF FD 00 FE 11 00 83 74 00 04 00 01 96 00 00 00 02 AA 00 00 00 82 87"));
  CHECK(octets(encode(1, Instruction::Write, hex("74 00 FF FF FD 00")).view()) ==
        hex("FF FF FD 00 01 0A 00 03 74 00 FF FF FD FD 00 21 E7"));

  const auto pong = frames_in<Format>(hex("FF FF FD 00 01 07 00 55 00 06 04 26 65 5D"));
  REQUIRE(pong.size() == 1);
  CHECK(pong[0].instruction == Instruction::Status);
  CHECK(pong[0].error == 0);
  CHECK(little16(pong[0].parameters.view(), 0) == 1030);
  CHECK(pong[0].parameters[2] == 38);
  const auto place = frames_in<Format>(hex("FF FF FD 00 01 08 00 55 00 A6 00 00 00 8C C0"));
  REQUIRE(place.size() == 1);
  CHECK(little32(place[0].parameters.view(), 0) == 166);
  CHECK(octets(encode_status(1, 0, hex("A6 00 00 00")).view()) ==
        hex("FF FF FD 00 01 08 00 55 00 A6 00 00 00 8C C0"));
}

TEST_CASE("the vectors of the Feetech protocol") {
  using namespace feetech;
  CHECK(octets(ping(1).view()) == hex("FF FF 01 02 01 FB"));
  CHECK(octets(read(1, 0x38, 2).view()) == hex("FF FF 01 04 02 38 02 BE"));
  CHECK(octets(write(1, 42, hex("00 08 00 00 E8 03")).view()) ==
        hex("FF FF 01 09 03 2A 00 08 00 00 E8 03 D5"));
  CHECK(octets(sync_read(0x38, 8, hex("01 02")).view()) == hex("FF FF FE 06 82 38 08 01 02 36"));
  const auto answers = frames_in<Format>(hex("FF FF 01 02 00 FC FF FF 01 04 00 18 05 DD"));
  REQUIRE(answers.size() == 2);
  CHECK(answers[0].code == 0);
  CHECK(little16(answers[1].parameters.view(), 0) == 1304);
}

TEST_CASE("Feetech's signs are a bit of their own") {
  CHECK(feetech::sign_magnitude(-100) == 0x8064);
  CHECK(feetech::from_sign_magnitude(0x8064) == -100);
  CHECK(feetech::from_sign_magnitude(0x0864, 11) == -100);
  for (const int value : {0, 1, -1, 4095, -4095, 32767, -32767})
    CHECK(feetech::from_sign_magnitude(feetech::sign_magnitude(value)) == value);
}

TEST_CASE("the vectors of Rob's own protocol") {
  const std::string digits = "123456789";
  CHECK(wire::crc16({reinterpret_cast<const std::uint8_t*>(digits.data()), 9}) == 0x29B1);
  CHECK(octets(wire::encode(wire::Type::Hello, 42, {}).view()) == hex("A5 5A 01 2A 00 81 12"));
  const wire::Info info{1, 1, 500, 16, 1};
  CHECK(octets(wire::encode(wire::Type::Info, 42, wire::payload_of(info).view()).view()) ==
        hex("A5 5A 02 2A 08 01 01 F4 01 10 00 01 00 E7 1A"));
  const std::uint8_t on = 1;
  CHECK(octets(wire::encode(wire::Type::Enable, 43, {&on, 1}).view()) ==
        hex("A5 5A 30 2B 01 01 0E FD"));
}

TEST_CASE("six axes of Rob's own protocol take 128 bytes a cycle") {
  const auto reference =
      wire::encode(wire::Type::Reference, 1, wire::payload_of(wire::Reference{}, 6).view());
  const auto state = wire::encode(wire::Type::State, 1, wire::payload_of(wire::State{}, 6).view());
  CHECK(reference.size() + state.size() == 128);
}

TEST_CASE("what Rob's own protocol carries comes out as it went in") {
  wire::State state{0xFFFFFFF0, 5, 3, {1, -2, 2147483647}, {-7, 8, -2147483647}, 513, 77};
  wire::State read;
  REQUIRE(wire::parse(wire::payload_of(state, 3).view(), 3, read));
  CHECK(read.time == state.time);
  CHECK(read.flags == 5);
  CHECK(read.position == state.position);
  CHECK(read.velocity == state.velocity);
  CHECK(read.last == 513);
  CHECK(read.broken == 77);
  CHECK_FALSE(wire::parse(wire::payload_of(state, 3).view(), 4, read));

  const wire::Reference reference{4000000000U, 10000, {-5, 6}, {7, -8}};
  wire::Reference got;
  REQUIRE(wire::parse(wire::payload_of(reference, 2).view(), 2, got));
  CHECK(got.apply == 4000000000U);
  CHECK(got.period == 10000);
  CHECK(got.position == reference.position);
  CHECK(got.velocity == reference.velocity);
}

TEST_CASE("instants that wrap are compared modulo 2^32") {
  CHECK(wire::between(5, 4294967290U) == 11);
  CHECK(wire::between(4294967290U, 5) == -11);
}

TEST_CASE_TEMPLATE("any parameters come out of the frame as they went in", Kind, DynamixelFrames,
                   FeetechFrames, Robs) {
  std::mt19937 random(1);
  for (int i = 0; i < 2000; ++i) {
    const Octets parameters = random_octets(random, Kind::kMost);
    const auto found = frames_in<typename Kind::Format>(Kind::encode(parameters));
    REQUIRE(found.size() == 1);
    CHECK(Kind::payload(found[0]) == parameters);
  }
}

TEST_CASE_TEMPLATE("a single bit that is wrong is always found", Kind, DynamixelFrames,
                   FeetechFrames, Robs) {
  std::mt19937 random(2);
  for (int i = 0; i < 30; ++i) {
    const Octets parameters = random_octets(random, 24);
    const Octets whole = Kind::encode(parameters);
    for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
      Octets spoilt = whole;
      spoilt[bit / 8] = static_cast<std::uint8_t>(spoilt[bit / 8] ^ 1U << bit % 8);
      CHECK(frames_in<typename Kind::Format>(spoilt, spoilt.size()).empty());
    }
  }
}

TEST_CASE_TEMPLATE("fault 24: frames are found behind garbage", Kind, DynamixelFrames,
                   FeetechFrames, Robs) {
  std::mt19937 random(3);
  for (int i = 0; i < 300; ++i) {
    const Octets parameters = random_octets(random, 20);
    Octets stream;
    for (std::size_t n = random() % 40; n > 0; --n)
      stream.push_back(static_cast<std::uint8_t>(random() % 0xA0));  // no header in it
    const Octets whole = Kind::encode(parameters);
    stream.insert(stream.end(), whole.begin(), whole.end());
    const auto found = frames_in<typename Kind::Format>(stream, 1 + random() % 9);
    REQUIRE(found.size() == 1);
    CHECK(Kind::payload(found[0]) == parameters);
  }
}

TEST_CASE_TEMPLATE("fault 26: what was half a frame is forgotten on command", Kind, DynamixelFrames,
                   FeetechFrames, Robs) {
  const Octets whole = Kind::encode({1, 2, 3, 4});
  FrameReader<typename Kind::Format> reader;
  typename Kind::Format::Frame frame;
  reader.add(Bytes(whole).first(whole.size() / 2));
  CHECK_FALSE(reader.next(frame));
  reader.clear();
  reader.add(Bytes(whole).subspan(whole.size() / 2));
  CHECK_FALSE(reader.next(frame));
  reader.add(whole);
  CHECK(reader.next(frame));
}

TEST_CASE_TEMPLATE("a reader takes no memory, whatever comes", Kind, DynamixelFrames, FeetechFrames,
                   Robs) {
  std::mt19937 random(4);
  const Octets noise = random_octets(random, 4000);
  FrameReader<typename Kind::Format> reader;
  typename Kind::Format::Frame frame;
  test::NoAllocation guard;
  reader.add(noise);
  while (reader.next(frame)) {
  }
  CHECK(guard.count() == 0);
}

}  // namespace rob::drivers
