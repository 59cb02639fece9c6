#include "motion/robots/closest_name.h"

#include <doctest/doctest.h>

#include <string>

using rob::motion::closest_name;

TEST_CASE("a slip of one or two letters is recognised") {
  CHECK(closest_name("v_maks", {"min", "v_max", "a_max"}) == "v_max");
  CHECK(closest_name("chanel", {"name", "channel"}) == "channel");
  CHECK(closest_name("gantyr", {"gantry", "ums7"}) == "gantry");
}

TEST_CASE("of two candidates the closer one is taken, of equals the first") {
  CHECK(closest_name("a_mix", {"v_max", "a_max"}) == "a_max");
  CHECK(closest_name("_max", {"v_max", "a_max"}) == "v_max");
}

TEST_CASE("another word is no slip") {
  CHECK(closest_name("colour", {"min", "max", "start"}).empty());
  CHECK(closest_name("ab", {"min", "max"}).empty());
  CHECK(closest_name("", {"a"}).empty());
  CHECK(closest_name(std::string(10'000, 'a'), {"aa"}).empty());
}
