// Records of runs, read by a reader that was written from the specification of MCAP alone.
#include <doctest/doctest.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "motion/robots/robot_library.h"
#include "runtime/record/mcap_reader.h"
#include "runtime/record/mcap_writer.h"
#include "runtime/record/recorded_run.h"
#include "runtime/record/run_record.h"
#include "runtime/run/run.h"
#include "tests/support/scratch_folder.h"

using nlohmann::json;
using rob::runtime::FileError;
using rob::runtime::McapReader;
using rob::runtime::McapWriter;
using rob::test::ScratchFolder;

namespace {

/// CRC-32 as ISO 3309 defines it, bit by bit.
std::uint32_t crc(const std::string& bytes) {
  std::uint32_t remainder = 0xFFFFFFFFU;
  for (const char c : bytes) {
    remainder ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit)
      remainder = (remainder & 1U) != 0 ? remainder >> 1U ^ 0xEDB88320U : remainder >> 1U;
  }
  return ~remainder;
}

std::uint64_t number(const std::string& bytes, std::size_t at, int size) {
  std::uint64_t value = 0;
  for (int i = size - 1; i >= 0; --i)
    value = value << 8U | static_cast<unsigned char>(bytes.at(at + static_cast<std::size_t>(i)));
  return value;
}

struct Record {
  int opcode;
  std::size_t begin;  ///< in the file, or in its chunk
  std::string content;
};

std::vector<Record> records(const std::string& bytes, std::size_t at, std::size_t end) {
  std::vector<Record> found;
  while (at < end) {
    const auto size = static_cast<std::size_t>(number(bytes, at + 1, 8));
    found.push_back({static_cast<unsigned char>(bytes[at]), at, bytes.substr(at + 9, size)});
    REQUIRE(found.back().content.size() == size);
    at += 9 + size;
  }
  CHECK(at == end);
  return found;
}

std::string whole(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::vector<Record> records_of(const std::string& bytes) {
  const std::string magic = "\x89MCAP0\r\n";
  REQUIRE(bytes.size() > 2 * magic.size());
  CHECK(bytes.substr(0, 8) == magic);
  CHECK(bytes.substr(bytes.size() - 8) == magic);
  return records(bytes, 8, bytes.size() - 8);
}

std::vector<Record> of(const std::vector<Record>& all, int opcode) {
  std::vector<Record> found;
  for (const Record& record : all)
    if (record.opcode == opcode) found.push_back(record);
  return found;
}

/// A program that ran on the virtual clock, recorded.
void record_run(const std::string& path, const std::string& text) {
  const auto robot = rob::motion::embedded_robot("gantry");
  const auto program = rob::runtime::compile_program("t.rob", text, robot);
  REQUIRE(program.runnable());
  rob::runtime::RunRecord record(path, program.robot, "folder/t.rob", {},
                                 {{"t.rob", "text/x-rob", text}});
  rob::runtime::RunOptions options;
  options.fast = true;
  rob::runtime::RunListener listener;
  listener.row = [&](const rob::runtime::Snapshot& snapshot) { record.row(snapshot); };
  listener.signal = [&](const rob::runtime::SignalChange& change) { record.signal(change); };
  listener.said = [&](const std::string& said, double time, int line) {
    record.print(time, line, said);
  };
  const auto result = rob::runtime::run(program, program.robot, options, listener);
  CHECK(record.finish(result));
}

constexpr const char* kText =
    "MOVE(40,40,0)\nDOUT[1] = ON\nPRINT \"half \\\"way\\\"\"\nMOVE(140,40,0)\n";

}  // namespace

TEST_CASE("a record has the parts of MCAP, with checksums, and indexes that lead to messages") {
  const ScratchFolder folder;
  const std::string path = folder.file("run.mcap");
  record_run(path, kText);
  const std::string bytes = whole(path);
  const std::vector<Record> all = records_of(bytes);
  CHECK(all.front().opcode == 0x01);
  CHECK(all.back().opcode == 0x02);

  // The data section ends with the checksum of all before it.
  REQUIRE(of(all, 0x0F).size() == 1);
  const Record end = of(all, 0x0F).front();
  CHECK(number(end.content, 0, 4) == crc(bytes.substr(0, end.begin)));
  // The footer says where the summary begins, and has its checksum.
  const std::string footer = all.back().content;
  const auto summary = static_cast<std::size_t>(number(footer, 0, 8));
  CHECK(summary == end.begin + 9 + 4);
  CHECK(number(footer, 16, 4) == crc(bytes.substr(summary, all.back().begin + 9 + 16 - summary)));

  std::size_t messages = 0;
  for (const Record& chunk : of(all, 0x06)) {
    const auto size = static_cast<std::size_t>(number(chunk.content, 16, 8));
    CHECK(size <= McapWriter::kChunk);
    CHECK(number(chunk.content, 28, 4) == 0);  // no compression
    const std::string inside = chunk.content.substr(40);
    REQUIRE(inside.size() == size);
    CHECK(number(chunk.content, 24, 4) == crc(inside));
    const auto in_chunk = records(inside, 0, inside.size());
    messages += in_chunk.size();
    std::map<std::size_t, std::uint64_t> times;
    for (const Record& message : in_chunk) times[message.begin] = number(message.content, 6, 8);
    // The indexes after it name each of its messages once.
    std::size_t indexed = 0;
    for (const Record& index : of(all, 0x07)) {
      if (index.begin < chunk.begin) continue;
      for (std::size_t at = 6; at < index.content.size(); at += 16) {
        const auto place = times.find(static_cast<std::size_t>(number(index.content, at + 8, 8)));
        if (place == times.end()) continue;
        indexed += place->second == number(index.content, at, 8) ? 1 : 0;
      }
    }
    CHECK(indexed >= in_chunk.size());
  }
  const Record statistics = of(all, 0x0B).front();
  CHECK(number(statistics.content, 0, 8) == messages);
  CHECK(number(statistics.content, 10, 4) == 5);  // channels
  // Schemas and channels stand before the messages, and in the summary again.
  CHECK(of(all, 0x03).size() == 10);
  CHECK(of(all, 0x04).size() == 10);
  for (const Record& attachment : of(all, 0x09)) {
    const std::string& content = attachment.content;
    CHECK(number(content, content.size() - 4, 4) == crc(content.substr(0, content.size() - 4)));
  }
}

TEST_CASE("a record has each reference as the trace has it, outputs and prints at their times") {
  const ScratchFolder folder;
  const std::string path = folder.file("run.mcap");
  record_run(path, kText);
  McapReader reader(path);
  const auto files = reader.attachments();
  REQUIRE(files.size() == 1);
  CHECK(files.front().text == kText);
  McapReader::Message message;
  std::int64_t rows = 0;
  json last;
  while (reader.next("/joints", message)) {
    CHECK(message.time == static_cast<std::uint64_t>(rows) * 10'000'000);  // 100 Hz
    last = json::parse(message.text);
    ++rows;
  }
  CHECK(rows > 400);
  CHECK(last["q"] == json::parse("[140.0,40.0,0.0]"));
  CHECK(last["line"] == "5");  // the end of the program, where the last target is made exact
  McapReader signals(path);
  REQUIRE(signals.next("/signals", message));
  CHECK(json::parse(message.text) == json::parse(R"({"name":"DOUT[1]","value":true,"line":"2"})"));
  McapReader log(path);
  REQUIRE(log.next("/log", message));
  const json said = json::parse(message.text);
  CHECK(said["message"] == "half \"way\"");
  CHECK(said["file"] == "t.rob");
  CHECK(said["line"] == 3);
}

TEST_CASE("the same run gives the same bytes") {
  const ScratchFolder folder;
  record_run(folder.file("one.mcap"), kText);
  record_run(folder.file("two.mcap"), kText);
  CHECK(whole(folder.file("one.mcap")) == whole(folder.file("two.mcap")));
}

TEST_CASE("two records that differ are told apart at the first reference that does") {
  const ScratchFolder folder;
  record_run(folder.file("one.mcap"), "MOVE(40,40,0)\nMOVE(140,40,0)\n");
  record_run(folder.file("two.mcap"), "MOVE(40,40,0)\nMOVE(140,41,0)\n");
  const auto same =
      rob::runtime::compare_records(folder.file("one.mcap"), folder.file("one.mcap"), true);
  CHECK_FALSE(same.differs_from);
  CHECK(same.references > 400);
  const auto other =
      rob::runtime::compare_records(folder.file("one.mcap"), folder.file("two.mcap"), false);
  REQUIRE(other.differs_from);
  CHECK(*other.differs_from > 1);  // not before the corner of line 1
  CHECK(*other.differs_from < 3);
}

TEST_CASE("a record that was cut off anywhere is read as far as it goes, or refused") {
  const ScratchFolder folder;
  record_run(folder.file("run.mcap"), kText);
  const std::string bytes = whole(folder.file("run.mcap"));
  for (std::size_t size = 0; size < bytes.size(); size += 1 + bytes.size() / 200) {
    const std::string path = folder.file("cut.mcap");
    std::ofstream(path, std::ios::binary) << bytes.substr(0, size);
    try {
      McapReader reader(path);
      reader.attachments();
      McapReader::Message message;
      while (reader.next("/joints", message)) CHECK_FALSE(message.text.empty());
    } catch (const FileError&) {
      CHECK(size < 8);  // no magic
    }
  }
}

TEST_CASE("a record that names files outside its folder writes none of them") {
  const ScratchFolder folder;
  for (const std::string place : {"../evil.rob", "/tmp/evil.rob", "a/../../evil.rob"}) {
    CAPTURE(place);
    const json options{{"program", "t.rob"}, {"robot", ""},
                       {"law", ""},          {"signals", ""},
                       {"seed", 1},          {"cell", nullptr},
                       {"override", 1.0},    {"date", {{"unix", 0.0}, {"offset", 0}}},
                       {"clock", "virtual"}, {"files", {{"t.rob", place}}}};
    CHECK_THROWS_AS(rob::runtime::unpack({{"t.rob", "text/x-rob", "MOVE(1,1,1)\n"},
                                          {"options.json", "application/json", options.dump()}},
                                         folder.file("inside")),
                    FileError);
    CHECK_FALSE(std::filesystem::exists(folder.file("evil.rob")));
  }
}
