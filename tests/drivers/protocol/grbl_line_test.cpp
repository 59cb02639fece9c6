#include <doctest/doctest.h>

#include <random>
#include <string>
#include <vector>

#include "drivers/protocol/grbl_line.h"

namespace rob::drivers::grbl {
namespace {

Line parsed(std::string_view text) {
  Line line;
  CHECK_MESSAGE(parse(text, line), text);
  return line;
}

std::vector<std::string> lines_in(const std::string& text, LineReader& reader) {
  Bytes bytes(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
  std::vector<std::string> lines;
  std::string_view line;
  while (reader.next(bytes, line)) lines.emplace_back(line);
  return lines;
}

}  // namespace

TEST_CASE("the parameters of $#, and what a report shows of the machine") {
  const Line offset = parsed("[G54:-100.000,-80.000,4.500]");
  CHECK(offset.kind == Line::Kind::Parameter);
  CHECK(offset.name == "G54");
  CHECK(offset.values == 3);
  CHECK(offset.parameter[1] == -80);
  CHECK(parsed("[TLO:2.000]").values == 1);
  CHECK(parsed("[GC:G0 G54 G17 G21 G90 G94 M5 M9 T0 F0 S0]").kind == Line::Kind::Message);
  CHECK(parsed("[PRB:0.000,0.000,0.000:0]").kind == Line::Kind::Message);
  const Status held = parsed("<Hold:1|MPos:1.000,0.000,0.000|FS:0,0|Ov:50,100,100>").status;
  CHECK(held.machine == Machine::Hold);
  CHECK(held.phase == 1);
  CHECK(held.feed_override == 50);
  CHECK(parsed("<Tool|MPos:1.000,0.000,0.000|FS:0,0>").status.machine == Machine::Tool);
  CHECK(parsed("<Idle|MPos:1.000,0.000,0.000|FS:0,0>").status.feed_override == 0);
  Line line;
  CHECK_FALSE(parse("<Hold:x|MPos:1.000,0.000,0.000>", line));
  CHECK_FALSE(parse("<Idle|MPos:1.000,0.000,0.000|Ov:a>", line));
}

TEST_CASE("the answers of grbl") {
  CHECK(parsed("ok").kind == Line::Kind::Ok);
  CHECK(parsed("error:22").kind == Line::Kind::Error);
  CHECK(parsed("error:22").number == 22);
  CHECK(parsed("error: Bad number format").kind == Line::Kind::Error);  // grbl 0.9
  CHECK(parsed("ALARM:1").kind == Line::Kind::Alarm);
  CHECK(parsed("ALARM:1").number == 1);
  CHECK(parsed("[MSG:'$H'|'$X' to unlock]").kind == Line::Kind::Message);
  CHECK(parsed("Grbl 1.1h ['$' for help]").kind == Line::Kind::Banner);
  CHECK(parsed("Grbl 1.1h ['$' for help]").version == 101);
  CHECK(parsed("GrblHAL 1.1f ['$' or '$HELP' for help]").version == 101);
  CHECK(parsed("Grbl 0.9j ['$' for help]").version == 9);
  CHECK(parsed("$110=5000.000").kind == Line::Kind::Setting);
  CHECK(parsed("$110=5000.000").number == 110);
  CHECK(parsed("$110=5000.000").value == 5000);
  CHECK(parsed("$11=0.010 (junction deviation, mm)").value == 0.010);
}

TEST_CASE("a status report of grbl") {
  const Status full =
      parsed("<Run|MPos:1.000,-2.500,0.125|Bf:12,100|FS:600,0|WCO:1.000,2.000,3.000>").status;
  CHECK(full.machine == Machine::Run);
  CHECK(full.axes == 3);
  CHECK(full.position[1] == -2.5);
  CHECK_FALSE(full.of_work);
  CHECK(full.has_offset);
  CHECK(full.offset[2] == 3);
  CHECK(full.has_buffer);
  CHECK(full.free_blocks == 12);
  CHECK(full.free_bytes == 100);
  const Status work = parsed("<Hold:1|WPos:0.000,0.000,0.000,5.000|F:0>").status;
  CHECK(work.machine == Machine::Hold);
  CHECK(work.of_work);
  CHECK(work.axes == 4);
  CHECK_FALSE(work.has_offset);
}

TEST_CASE("fault 24: a mutilated report is refused") {
  Line line;
  for (const char* text :
       {"<Run|MPos:1.000,2.0>x", "<Run|MPos:1.000,2.x,0.000>", "<Rnu|MPos:1.000,2.000,0.000>",
        "<Run|MPos:1.0", "<Run|MPos:>", "<Run>", "<>", "$110=", "$x=1", "<Run|MPos:1,2,3,4,5,6,7>"})
    CHECK_MESSAGE(!parse(text, line), text);
}

TEST_CASE("lines come in any pieces") {
  std::mt19937 random(1);
  for (int turn = 0; turn < 100; ++turn) {
    LineReader reader;
    std::vector<std::string> found;
    const std::string text = "ok\r\n\r\n<Idle|MPos:0.000,0.000,0.000>\nerror:9\r\n";
    for (std::size_t i = 0; i < text.size();) {
      const std::size_t step = 1 + random() % 6;
      for (const std::string& line : lines_in(text.substr(i, step), reader)) found.push_back(line);
      i += step;
    }
    REQUIRE(found.size() == 3);
    CHECK(found[1] == "<Idle|MPos:0.000,0.000,0.000>");
    CHECK(reader.broken() == 0);
  }
}

TEST_CASE("fault 24: a line with bytes that no line has is dropped, and the next is read") {
  LineReader reader;
  const auto found = lines_in("o\x80k\nok\n" + std::string(500, 'x') + "\nerror:1\n", reader);
  REQUIRE(found.size() == 2);
  CHECK(found[0] == "ok");
  CHECK(found[1] == "error:1");
  CHECK(reader.broken() == 2);
}

TEST_CASE("errors and alarms have words, and it is known which alarms lose the position") {
  for (const int alarm : {1, 2, 3, 4, 5, 6, 7, 8, 9, 10}) CHECK(*alarm_text(alarm) != '\0');
  CHECK(loses_position(1));
  CHECK(loses_position(3));
  CHECK_FALSE(loses_position(2));
  CHECK(*error_text(22) != '\0');
  CHECK(*error_text(999) == '\0');
}

}  // namespace rob::drivers::grbl
