#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/support/rob_command.h"
#include "tests/support/trace_file.h"

using namespace rob::test;

namespace {

/// The references of a run under the look-ahead law; none where the machine stalled for too long.
std::vector<TraceRow> references(const RobCommand& rob, std::vector<std::string> how) {
  const std::string trace = rob.file("trace.csv");
  how.insert(how.end(), {"--trace", trace});
  if (rob("run", how).exit_code != 0) return {};
  return parse_trace(read_whole_file(trace)).rows;
}

}  // namespace

// Whether the program, the planner and the cycle have threads of their own or take turns must not
// change a bit; what the servo makes of it does depend on when it is called.
TEST_CASE("under the look-ahead law a run with threads has the references of the stepped one") {
  for (const char* text :
       {"LAW LOOKAHEAD\nMOVE(10, 0, 0)\nMOVE(10, 10, 0) ZONE 1mm\nMOVE(0, 10, 20)\nMOVEL(0, 0, "
        "0)\n",
        "ROBOT \"irb120\"\nLAW LOOKAHEAD\nMOVE(330, 0, 520)\nMOVEL(330, 60, 500)\n"
        "MOVEC VIA (310, 80, 490) TO (300, 60, 480)\nMOVE(302, 0, 558)\n"}) {
    CAPTURE(text);
    const RobCommand rob(text);
    const auto stepped = references(rob, {"--fast"});
    auto threaded = references(rob, {});
    if (threaded.empty()) threaded = references(rob, {});  // a stall of the machine, once
    REQUIRE(threaded.size() > 100);
    auto same = stepped.begin();
    for (const TraceRow& row : threaded) {  // of a late cycle only the last reference is there
      same = std::find_if(same, stepped.end(), [&](const TraceRow& one) { return one.t == row.t; });
      REQUIRE(same != stepped.end());
      CHECK(same->line == row.line);
      CHECK(same->sigma == row.sigma);
      REQUIRE(same->q == row.q);
      REQUIRE(same->qd == row.qd);
      REQUIRE(same->qdd == row.qdd);
    }
    CHECK(threaded.back().t == stepped.back().t);
  }
}
