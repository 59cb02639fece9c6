// What Tab offers, by the place of the cursor.

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "runtime/prompt/completion.h"

using namespace rob::runtime;

namespace {

using Offers = std::vector<std::string>;

Vocabulary known() {
  Vocabulary known;
  known.names = {"pick", "pallet", "vacuum"};
  known.points = {"pick", "pallet"};
  known.bodies = {"gripper", "part", "forearm"};
  known.robots = {"gantry", "irb120"};
  known.files = [](const std::string& folder) {
    if (folder == "lib/") return Offers{"tools.rob", "notes.txt", ".hidden.rob"};
    return Offers{"main.rob", "cell.toml", "lib/", ".git/"};
  };
  return known;
}

Offers offered(const std::string& before) { return complete(before, known()).words; }

bool offers(const std::string& before, const std::string& word) {
  return std::ranges::count(offered(before), word) == 1;
}

}  // namespace

TEST_CASE("at the beginning of a statement: its words, and names") {
  CHECK(offered("MOV") == Offers{"MOVE", "MOVEC", "MOVEL", "MOVES"});
  CHECK(offered("  mov") == Offers{"MOVE", "MOVEC", "MOVEL", "MOVES"});
  CHECK(complete("  mov", known()).begin == 2);
  CHECK(offered("pa") == Offers{"pallet"});
  CHECK(offered("IF vacuum THEN MOVEL") == Offers{"MOVEL"});
  CHECK(offered("WHEN vacuum : PUL") == Offers{"PULSE"});
  CHECK(!offers("MO", "MOD"));  // joins values, begins nothing
}

TEST_CASE("behind the target of a motion: its clauses") {
  CHECK(offered("MOVE(10,0,0) A") == Offers{"ACCEL", "AT"});
  CHECK(offered("MOVE pick Z") == Offers{"ZONE"});
  CHECK(offered("MOVE(10,0,0) AT 50mm/s U") == Offers{"UNTIL"});
  CHECK(!offers("MOVE(10,0,0) ", "MOVE"));
  CHECK(!offers("MOVE(10,0,0) ", "pick"));
  // Inside the target values stand.
  CHECK(!offers("MOVE(10 ", "AT"));
  CHECK(offers("MOVE(10 ", "DIV"));
  CHECK(offered("MOVE(10,0,0) PROFILE C") == Offers{"COSINE"});
  CHECK(offered("MOVE pick NE") == Offers{"NEAR"});
  CHECK(offered("MOVE pick FREE S") == Offers{"SPIN"});
  CHECK(offers("MOVE pick NEAR ", "JOINTS"));
  CHECK(offered("JOG W") == Offers{"WORLD"});
}

TEST_CASE("where a value stands: names, functions and readings") {
  CHECK(offered("MOVE pi") == Offers{"pick"});
  CHECK(offered("PRINT AT") == Offers{"ATAN", "ATAN2"});
  CHECK(offered("PRINT HER") == Offers{"HERE"});
  CHECK(offered("vacuum = OF") == Offers{"OFF"});
  CHECK(offered("PRINT pick.p").empty());
}

TEST_CASE(
    "directly behind a number: its units, of lengths and angles also what they are a second") {
  CHECK(offered("WAIT 10m") == Offers{"m", "m/s", "m/s^2", "min", "mm", "mm/s", "mm/s^2", "ms"});
  CHECK(offered("MOVE(0,0,0) AT 10.5mm/") == Offers{"mm/s", "mm/s^2"});
  CHECK(complete("AT 10.5mm/", known()).begin == 7);
  CHECK(offered("PRESS Z 5k") == Offers{"kN", "kg"});
  CHECK(!offers("PRINT p1m", "mm"));  // a name
}

TEST_CASE("behind a colon: commands, and what they take") {
  CHECK(offers(":", "where"));
  CHECK(offered(":whe") == Offers{"where"});
  CHECK(complete(":whe", known()).begin == 1);
  CHECK(offered(":law ") == Offers{"lookahead", "paul"});
  CHECK(offered(":robot irb") == Offers{"irb120"});
  CHECK(offered(":robot c") == Offers{"cell.toml"});
  CHECK(offered(":load ") == Offers{"lib/", "main.rob"});
  CHECK(offered(":rename p") == Offers{"pallet", "pick"});
  CHECK(offers(":help MOVE", "MOVEL"));
  CHECK(offers(":help E40", "E401"));
  CHECK(offered(":nonsense x").empty());
}

TEST_CASE("behind USE: programs here and in lib; in texts nothing") {
  CHECK(offered("USE ") == Offers{"main", "tools"});
  CHECK(offered("use t") == Offers{"tools"});
  CHECK(complete("USE to", known()).begin == 4);
  CHECK(offered("PRINT \"ma").empty());
  CHECK(offers("PRINT \"ma\" + pi", "pick"));
  CHECK(offered("STOP // MO").empty());
}

TEST_CASE("after ALLOW: bodies and obstacles; after OBSTACLE its shapes") {
  CHECK(offered("AL") == Offers{"ALLOW"});
  CHECK(offered("OBST") == Offers{"OBSTACLE"});
  CHECK(offered("ALLOW ") == Offers{"forearm", "gripper", "part"});
  CHECK(offered("ALLOW gripper, pa") == Offers{"part"});
  CHECK(offered("ALLOW gripper D") == Offers{"DIV", "DO"});
  CHECK(offered("OBSTACLE box = ") == Offers{"BOX", "CAPSULE", "MESH", "SPHERE"});
}
