#include "tests/support/random_program.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cctype>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/gantry.h"
#include "tests/support/random_text.h"

using namespace rob::test;

namespace {

constexpr std::uint64_t kPrograms = 200;

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    std::transform(line.begin(), line.end(), line.begin(),
                   [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    lines.push_back(line);
  }
  return lines;
}

bool begins_with(std::string line, const char* word) {
  line.erase(0, line.find_first_not_of(" \t"));
  return line.starts_with(word);
}

}  // namespace

TEST_CASE("a decimal is written without rounding and without idle zeros") {
  CHECK(decimal(1234, 2) == "12.34");
  CHECK(decimal(-5, 3) == "-0.005");
  CHECK(decimal(4000, 1) == "400");
  CHECK(decimal(0, 2) == "0");
  CHECK(decimal(100, 0) == "100");
}

TEST_CASE("the same number gives the same program, another number another") {
  CHECK(random_gantry_program(7).text == random_gantry_program(7).text);
  CHECK(random_gantry_program(7).text != random_gantry_program(8).text);
}

TEST_CASE("every step of the model names the line that it comes from") {
  for (std::uint64_t seed = 0; seed < kPrograms; ++seed) {
    const RandomProgram program = random_gantry_program(seed);
    const std::vector<std::string> lines = lines_of(program.text);
    for (const PaulStep& step : program.steps) {
      REQUIRE(step.line >= 1);
      REQUIRE(step.line <= static_cast<int>(lines.size()));
      const std::string& line = lines[static_cast<std::size_t>(step.line) - 1];
      CHECK(begins_with(line, "MOVE") == !step.stop);
      CHECK((begins_with(line, "STOP") || begins_with(line, "END")) == step.stop);
    }
  }
}

TEST_CASE("every target lies within the limits, and some lie on them") {
  int at_limit = 0;
  for (std::uint64_t seed = 0; seed < kPrograms; ++seed) {
    for (const PaulStep& step : random_gantry_program(seed).steps) {
      if (step.stop) continue;
      for (std::size_t i = 0; i < 3; ++i) {
        CHECK(step.target[i] >= gantry_limits().min[i]);
        CHECK(step.target[i] <= gantry_limits().max[i]);
        at_limit += step.target[i] == gantry_limits().max[i] ? 1 : 0;
      }
    }
  }
  CHECK(at_limit > 10);
}

TEST_CASE("the programs use all that they promise") {
  std::string all;
  for (std::uint64_t seed = 0; seed < kPrograms; ++seed) all += random_gantry_program(seed).text;
  for (const char* part :
       {"MOVE(", "move(", "STOP",  "END",  "PRINT",  "FOR i", "STEP -1", "theta:", "AT ", "OVER ",
        "%",     "mm/s",  "deg/s", "rpm",  "mm/min", "cm",    "um",      "rad",    "rev", "ms",
        "us",    "min",   " + ",   "2 * ", ", )",    "( ,",   "//",      "ZONE ",  "FINE"}) {
    CHECK_MESSAGE(all.find(part) != std::string::npos, part);
  }
}
