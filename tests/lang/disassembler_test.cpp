#include "lang/code/disassembler.h"

#include <doctest/doctest.h>

#include <regex>
#include <set>
#include <sstream>

#include "tests/lang/program_run.h"

using namespace rob::lang;
using rob::test::ProgramRun;

namespace {

std::vector<std::string> lines_of(const std::string& listing) {
  std::vector<std::string> lines;
  std::istringstream stream(listing);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

}  // namespace

TEST_CASE("a listing shows offset, source line, instruction, registers and constants") {
  const ProgramRun program("VAR x = 40mm\nMOVE(x, 20, 0) AT 50%\n");
  const std::string listing = disassemble(program.chunk());
  const std::vector<std::string> lines = lines_of(listing);
  REQUIRE(lines.size() == 7);
  CHECK(std::regex_search(lines[0], std::regex("^ +0 +1 +load_constant +r0\\(x\\) k0 +// 40mm$")));
  CHECK(std::regex_search(lines[1], std::regex("^ +1 +2 +copy +r1 r0\\(x\\)$")));
  CHECK(std::regex_search(lines[2], std::regex("^ +2 +load_constant +r2 k1 +// 20mm$")));
  CHECK(std::regex_search(lines[3], std::regex("^ +3 +load_constant +r3 k2 +// 0deg$")));
  CHECK(std::regex_search(lines[4], std::regex("^ +4 +load_constant +r4 k3 +// 0.5$")));
  CHECK(std::regex_search(lines[5], std::regex("^ +5 +move +r1 m0 .*AT$")));
  CHECK(std::regex_search(lines[6], std::regex("^ +6 +3 +end$")));
}

TEST_CASE("every jump of a listing arrives at an instruction of the listing") {
  const ProgramRun program(
      "VAR n = 3\nWHILE n > 0 AND NOT lift_up DO\n  IF n == 2 THEN\n    PRINT n, \"x\"\n"
      "  ELSIF n == 1 THEN\n    STOP\n  ELSE\n    lift = ON\n  ENDIF\n  n = n - 1\nENDWHILE\n"
      "FOR i = 0mm TO 1mm STEP 1mm DO\n  PRINT i\nENDFOR\n");
  const std::string listing = disassemble(program.chunk());
  std::set<int> offsets;
  std::set<int> aims;
  for (const std::string& line : lines_of(listing)) {
    offsets.insert(std::stoi(line));
    const auto arrow = line.find("-> ");
    if (arrow != std::string::npos) aims.insert(std::stoi(line.substr(arrow + 3)));
  }
  CHECK(aims.size() >= 6);
  for (const int aim : aims) CHECK(offsets.contains(aim));
}

TEST_CASE("the farthest jump is the farthest that its word holds, both ways") {
  const auto held = [](std::int64_t distance) {
    return Instruction::jump(Opcode::jump, static_cast<std::int32_t>(distance)).distance() ==
           distance;
  };
  const auto farthest = static_cast<std::int64_t>(kFarthestJump);
  CHECK(held(farthest));
  CHECK(held(-farthest));
  CHECK_FALSE(held(farthest + 1));
}

TEST_CASE("the two words of a long instruction are one line") {
  const ProgramRun program("PRINT \"hello\"\n");
  const std::string listing = disassemble(program.chunk());
  CHECK(lines_of(listing).size() == 3);
  CHECK(listing.find("// \"hello\"") != std::string::npos);
}
