// Every value of every robot file that is carried in the program, spoilt in every way.
#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "motion/robots/robot_file.h"
#include "motion/robots/robot_library.h"

using namespace rob::motion;

namespace {

/// `key = "number unit"` in a line of a robot file.
struct Value {
  int line = 0;
  std::size_t at = 0;  ///< of the opening quotation mark
  std::size_t size = 0;
  std::string key;
  std::string unit;
};

std::vector<Value> values_of(const std::string& text) {
  std::vector<Value> values;
  int line = 0;
  for (std::size_t begin = 0; begin < text.size(); begin = text.find('\n', begin) + 1) {
    ++line;
    const std::string row = text.substr(begin, text.find('\n', begin) - begin);
    const std::size_t equal = row.find(" = \"");
    if (equal == std::string::npos || row.find_first_of("#[") < equal) continue;
    const std::size_t open = equal + 3;
    const std::size_t close = row.find('"', open + 1);
    const std::string inside = row.substr(open + 1, close - open - 1);
    const std::size_t space = inside.find(' ');
    const bool number = inside.find_first_of("0123456789") <= 1;
    if (!number || space == std::string::npos || inside.find(' ', space + 1) != std::string::npos)
      continue;
    values.push_back(
        {line, begin + open, close - open + 1, row.substr(0, equal), inside.substr(space + 1)});
  }
  return values;
}

std::string error_with(std::string text, const Value& value, const std::string& instead) {
  text.replace(value.at, value.size, instead);
  try {
    parse_robot_file(text, "my.toml");
    return "";
  } catch (const RobotFileError& error) {
    return error.what();
  }
}

std::string value_text(const std::string& text) { return "\"" + text + "\""; }

/// The message names the file, the line and the key.
void check_refused(const std::string& text, const Value& value, const std::string& instead) {
  const std::string error = error_with(text, value, instead);
  CAPTURE(value.key);
  CAPTURE(instead);
  CAPTURE(error);
  CHECK(error.starts_with("my.toml:" + std::to_string(value.line) + ":"));
  CHECK(error.find(": " + value.key) != std::string::npos);
}

/// Of these 0 or less than that means something, or is refused with the whole table (c0 … c8).
bool may_be_less(const std::string& key) {
  static const std::vector<std::string> keys = {"c0",
                                                "min",
                                                "max",
                                                "start",
                                                "a1",
                                                "a2",
                                                "b",
                                                "c1",
                                                "c2",
                                                "c3",
                                                "c4",
                                                "c5",
                                                "c6",
                                                "c7",
                                                "c8",
                                                "ripple",
                                                "viscous_friction",
                                                "coulomb_friction",
                                                "x",
                                                "y",
                                                "face",
                                                "table",
                                                "delay",
                                                "damping_time",
                                                "force_noise",
                                                "torque_noise"};
  return std::ranges::find(keys, key) != keys.end();
}

}  // namespace

TEST_CASE(
    "any value that is no number, beyond all measure, or of another type is refused by name") {
  int looked_at = 0;
  for (const EmbeddedRobot& robot : embedded_robots()) {
    CAPTURE(robot.name);
    const std::string text(robot.text);
    for (const Value& value : values_of(text)) {
      ++looked_at;
      for (const char* number : {"nan", "inf", "-inf", "1e300", "-1e300", "1e400", ""})
        check_refused(text, value, value_text(std::string(number) + " " + value.unit));
      for (const char* other : {"1", "nan", "inf", "true", "[]", "\"\"", "\"1\"", "1979-05-27"})
        check_refused(text, value, other);
      check_refused(text, value, value_text("1 furlong"));
    }
  }
  CHECK(looked_at > 200);  // six robots of three to six axes with twelve values each
}

TEST_CASE("limits, periods and masses of nothing or less are refused, and the bounds are told") {
  for (const EmbeddedRobot& robot : embedded_robots()) {
    CAPTURE(robot.name);
    const std::string text(robot.text);
    for (const Value& value : values_of(text)) {
      if (may_be_less(value.key)) continue;
      for (const char* number : {"0", "-1"}) {
        check_refused(text, value, value_text(std::string(number) + " " + value.unit));
        const std::string error =
            error_with(text, value, value_text(std::string(number) + " " + value.unit));
        CHECK(error.find("it must lie from") != std::string::npos);
      }
    }
  }
}
