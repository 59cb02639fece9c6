// What Tab offers, by the place of the cursor.

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "runtime/prompt/completion.h"

using namespace rob::runtime;

namespace {

using Words = std::vector<std::string>;

Vocabulary known() {
  Vocabulary known;
  known.names = {"pick", "pallet", "vacuum"};
  known.robots = {"gantry", "irb120"};
  known.files = [](const std::string& folder) {
    if (folder == "lib/") return Words{"tools.rob", "notes.txt", ".hidden.rob"};
    return Words{"main.rob", "cell.toml", "lib/", ".git/"};
  };
  return known;
}

Words offered(const std::string& before) { return complete(before, known()).words; }

bool offers(const std::string& before, const std::string& word) {
  return std::ranges::count(offered(before), word) == 1;
}

}  // namespace

TEST_CASE("at the beginning of a statement: its words, and names") {
  CHECK(offered("MOV") == Words{"MOVE", "MOVEC", "MOVEL", "MOVES"});
  CHECK(offered("  mov") == Words{"MOVE", "MOVEC", "MOVEL", "MOVES"});
  CHECK(complete("  mov", known()).begin == 2);
  CHECK(offered("pa") == Words{"pallet"});
  CHECK(offered("IF vacuum THEN MOVEL") == Words{"MOVEL"});
  CHECK(offered("WHEN vacuum : PUL") == Words{"PULSE"});
  CHECK(!offers("MO", "MOD"));  // joins values, begins nothing
}

TEST_CASE("behind the target of a motion: its clauses") {
  CHECK(offered("MOVE(10,0,0) A") == Words{"ACCEL", "AT"});
  CHECK(offered("MOVE pick Z") == Words{"ZONE"});
  CHECK(offered("MOVE(10,0,0) AT 50mm/s U") == Words{"UNTIL"});
  CHECK(!offers("MOVE(10,0,0) ", "MOVE"));
  CHECK(!offers("MOVE(10,0,0) ", "pick"));
  // Inside the target values stand.
  CHECK(!offers("MOVE(10 ", "AT"));
  CHECK(offers("MOVE(10 ", "DIV"));
  CHECK(offered("MOVE(10,0,0) PROFILE C") == Words{"COSINE"});
  CHECK(offered("JOG W") == Words{"WORLD"});
}

TEST_CASE("where a value stands: names, functions and readings") {
  CHECK(offered("MOVE pi") == Words{"pick"});
  CHECK(offered("PRINT AT") == Words{"ATAN", "ATAN2"});
  CHECK(offered("PRINT HER") == Words{"HERE"});
  CHECK(offered("vacuum = O") == Words{"OFF", "ON"});
  CHECK(offered("PRINT pick.p").empty());
}

TEST_CASE(
    "directly behind a number: its units, of lengths and angles also what they are a second") {
  CHECK(offered("WAIT 10m") == Words{"m", "m/s", "m/s^2", "min", "mm", "mm/s", "mm/s^2", "ms"});
  CHECK(offered("MOVE(0,0,0) AT 10.5mm/") == Words{"mm/s", "mm/s^2"});
  CHECK(complete("AT 10.5mm/", known()).begin == 7);
  CHECK(offered("PRESS Z 5k") == Words{"kN", "kg"});
  CHECK(!offers("PRINT p1m", "mm"));  // a name
}

TEST_CASE("behind a colon: commands, and what they take") {
  CHECK(offers(":", "where"));
  CHECK(offered(":whe") == Words{"where"});
  CHECK(complete(":whe", known()).begin == 1);
  CHECK(offered(":law ") == Words{"lookahead", "paul"});
  CHECK(offered(":robot irb") == Words{"irb120"});
  CHECK(offered(":robot c") == Words{"cell.toml"});
  CHECK(offered(":load ") == Words{"lib/", "main.rob"});
  CHECK(offered(":rename p") == Words{"pallet", "pick"});
  CHECK(offers(":help MOVE", "MOVEL"));
  CHECK(offers(":help E40", "E401"));
  CHECK(offered(":nonsense x").empty());
}

TEST_CASE("behind USE: programs here and in lib; in texts nothing") {
  CHECK(offered("USE ") == Words{"main", "tools"});
  CHECK(offered("use t") == Words{"tools"});
  CHECK(complete("USE to", known()).begin == 4);
  CHECK(offered("PRINT \"ma").empty());
  CHECK(offers("PRINT \"ma\" + pi", "pick"));
  CHECK(offered("STOP // MO").empty());
}
