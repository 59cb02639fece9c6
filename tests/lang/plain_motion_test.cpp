#include "lang/syntax/plain_motion.h"

#include <doctest/doctest.h>

#include <random>
#include <string>

#include "lang/syntax/syntax_limits.h"
#include "tests/lang/program_run.h"

using namespace rob::lang;
using rob::test::ProgramRun;

namespace {

bool is_plain(std::string_view text) { return read_plain_motion(text, 4).has_value(); }

/// What a program does, or why it cannot be run.
std::string outcome(const std::string& source) {
  ProgramRun program(source);
  std::string text;
  for (const Diagnostic& diagnostic : program.compilation().diagnostics.all()) {
    text += diagnostic.code + ' ' + diagnostic.message + '\n';
  }
  if (!program.compiled()) return text;
  program.finish();
  for (const auto& call : program.machine().calls()) text += call.text + '\n';
  return text;
}

/// A component, right or wrong, from a seeded generator.
std::string component(std::mt19937& random) {
  static constexpr std::array kNumbers = std::to_array<std::string_view>(
      {"0", "40", "39.99", "0.1", "126.6", "00.50", "123456789012345678", "1234567890123456789",
       "99999999999999999999", "1e2", "5.", ".5", "1_0", "0x1", "x", ""});
  static constexpr std::array kUnits = std::to_array<std::string_view>(
      {"", "", "", "mm", "cm", "in", "deg", "rad", "%", "s", "mm/s", "Mm", " mm", "\u00b0"});
  const auto one_of = [&](const auto& texts) { return texts[random() % texts.size()]; };
  std::string text(random() % 4 == 0 ? "-" : "");
  if (random() % 8 == 0) text += ' ';
  text += one_of(kNumbers);
  text += one_of(kUnits);
  return text;
}

}  // namespace

TEST_CASE("a motion in numbers alone is read straight from the text") {
  CHECK(is_plain("MOVE(1,2,3)"));
  CHECK(is_plain("move ( 140 , , -0.5deg )  // a comment\nSTOP"));
  CHECK(is_plain("MOVE(1,2,3)\r\n"));
  const auto motion = read_plain_motion("MOVEL(-2.5cm, ,7)\n", 5);
  REQUIRE(motion);
  CHECK(motion->count == 3);
  CHECK(motion->length == 17);
  CHECK(motion->components[0].negative);
  CHECK(motion->components[0].number == "2.5");
  CHECK(motion->components[0].unit->exponent10 == 1);
  CHECK(motion->components[1].number.empty());
  CHECK(motion->components[2].number == "7");
  CHECK_FALSE(motion->components[2].unit);
  const auto paced = read_plain_motion("MOVE(1,2,3) zone 2mm  At 50% // both", 4);
  REQUIRE(paced);
  CHECK(paced->pace == MoveCommand::Pace::Share);
  CHECK(paced->pace_value == 0.5);
  CHECK(paced->zone == MoveCommand::Zone::Length);
  CHECK(paced->zone_value == 0.002);
  CHECK(paced->length == 28);
}

TEST_CASE("AT and ZONE of literals go with a motion in numbers, and mean the same as in a tree") {
  static constexpr std::array kClauses = std::to_array<std::string_view>(
      {" AT 20mm/s", " AT 5deg/s", " AT 50%", " AT 100%", " AT 150%", " AT 0.5", " AT 5mm",
       " ZONE 1.5mm", " ZONE 0.2s", " ZONE 30%", " ZONE 200%", " ZONE 0mm", " ZONE 1mm 2deg",
       " FINE", " ACCEL 20%", " OVER 2s", " AT 0mm/s", " ZONE 5mm/s"});
  std::mt19937 random(2);
  for (int i = 0; i < 1000; ++i) {
    std::string motion = random() % 3 == 0 ? "MOVEL(1, 2, 3)" : "MOVE(4, , 6)";
    for (auto n = random() % 4; n > 0; --n) motion += kClauses[random() % kClauses.size()];
    const std::string_view tail = random() % 2 == 0 ? "\nSTOP\n" : "\nMOVE(7, 8, 9)\n";
    // A parenthesis around a component makes a tree of it.
    std::string tree = motion;
    tree.replace(tree.find('(') + 1, 1, tree.starts_with("MOVEL") ? "(1)" : "(4)");
    CAPTURE(motion);
    CHECK(outcome(motion + std::string(tail)) == outcome(tree + std::string(tail)));
  }
}

TEST_CASE("what is written in any other way is left to the parser") {
  for (const char* const text : {"MOVE(1,2,3",
                                 "MOVE(1,2,\n3)",
                                 "MOVE(1,2,3) AT 50",
                                 "MOVE(1,2,3) AT v",
                                 "MOVE(1,2,3) AT 150%",
                                 "MOVE(1,2,3) AT 0mm/s",
                                 "MOVE(1,2,3) AT -1mm/s",
                                 "MOVE(1,2,3) AT 5mm",
                                 "MOVE(1,2,3) AT 5mm/s * 2",
                                 "MOVE(1,2,3) AT 5mm/s AT 5mm/s",
                                 "MOVE(1,2,3) ZONE 0mm",
                                 "MOVE(1,2,3) ZONE 1mm 2deg",
                                 "MOVE(1,2,3) FINE",
                                 "MOVE(1,2,3) ATE 5mm/s",
                                 "MOVE(x: 1)",
                                 "MOVE(1+1,2,3)",
                                 "MOVE p",
                                 "MOVE(1,2,3) STOP",
                                 "MOVE(1e3,2,3)",
                                 "MOVE(50%,2,3)",
                                 "MOVE(1 mm,2,3)",
                                 "MOVE(1,2,3)\r",
                                 "MOVE BY (1,2,3)",
                                 "MOVE(+1,2,3)",
                                 "MOVE(--1,2,3)",
                                 "MOVE()",
                                 "MOVE"}) {
    CAPTURE(text);
    CHECK_FALSE(is_plain(text));
  }
}

TEST_CASE("as numbers and as a tree a motion means the same, and is refused for the same reason") {
  std::mt19937 random(1);
  for (int i = 0; i < 3000; ++i) {
    std::string rest = component(random);
    const auto further = random() % 4 == 0 ? random() % 4 : 2;
    for (std::size_t n = 0; n < further; ++n) rest += ',' + component(random);
    const std::string units = random() % 3 == 0 ? "UNITS cm, rad\n" : "";
    const std::string word = random() % 3 == 0 ? "MOVEL" : "MOVE";
    // Behind THEN there stands a tree.
    const std::string tree = units + "IF TRUE THEN " + word + '(' + rest + ")\n";
    const std::string plain = units + word + '(' + rest + ")\n";
    CAPTURE(plain);
    CHECK(outcome(plain) == outcome(tree));
  }
}

TEST_CASE("what is wrong with one of many motions is told where it stands") {
  const ProgramRun program("MOVE(1,2,3)\n  MOVE(1,2s,3)\nMOVE(1,2,3)\nMOVE(1,2)\nMOOVE(1,2,3)\n");
  const auto& found = program.compilation().diagnostics.all();
  REQUIRE(found.size() == 3);
  CHECK(found[0].code == "E207");
  CHECK(found[0].place == Place{.line = 2, .column = 10, .length = 2});
  CHECK(found[1].place.line == 4);
  CHECK(found[2].code == "E120");
}

TEST_CASE("of more wrong motions than there may be errors the rest is not read") {
  std::string source;
  for (std::size_t i = 0; i <= kMaxSyntaxErrors; ++i) source += "MOVE(1,2,3,4)\n";
  const ProgramRun program(source);
  CHECK(program.compilation().diagnostics.error_count() == kMaxSyntaxErrors);
}

TEST_CASE("many motions in numbers take a few bytes each") {
  std::string source;
  for (int i = 0; i < 1000; ++i) source += "MOVE(" + std::to_string(i) + ", 2, 3)\n";
  const ProgramRun program(source);
  REQUIRE(program.compiled());
  CHECK(program.chunk().constants.empty());
  // One word for the motion, two a component, and END.
  CHECK(program.chunk().code.size() == 1000 * 7 + 1);
  CHECK(program.chunk().places[7 * 500 + 3].line == 501);
}
