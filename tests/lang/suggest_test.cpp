#include "lang/text/suggest.h"

#include <doctest/doctest.h>

#include <array>
#include <string>

using namespace rob::lang;

TEST_CASE("the distance of two words counts letters missing, added, replaced and exchanged") {
  CHECK(edit_distance("MOVE", "MOVE") == 0);
  CHECK(edit_distance("MOV", "MOVE") == 1);
  CHECK(edit_distance("MOOVE", "MOVE") == 1);
  CHECK(edit_distance("MOKE", "MOVE") == 1);
  CHECK(edit_distance("MVOE", "MOVE") == 1);
  CHECK(edit_distance("move", "MOVE") == 0);
  CHECK(edit_distance("", "MOVE") == 4);
  CHECK(edit_distance("kitten", "sitting") == 3);
  CHECK(edit_distance("ca", "abc") == 3);  // restricted form: no letter is moved twice
}

TEST_CASE("the distance is the same in both directions") {
  constexpr std::array<std::string_view, 5> words{"WHILE", "WHIEL", "WILE", "PRINT", ""};
  for (const auto a : words) {
    for (const auto b : words) CHECK(edit_distance(a, b) == edit_distance(b, a));
  }
}

TEST_CASE("the nearest word is suggested, but only for what looks like a slip") {
  constexpr std::array<std::string_view, 4> words{"MOVE", "MOVEL", "PRINT", "IF"};
  CHECK(suggest("MOV", words) == "MOVE");
  CHECK(suggest("moel", words) == "MOVEL");
  CHECK(suggest("movl", words) == "MOVE");  // as near as MOVEL, and first
  CHECK(nearest("movl", words) == std::vector<std::string_view>{"MOVE", "MOVEL"});
  CHECK(nearest("move", words) == std::vector<std::string_view>{"MOVE"});
  CHECK(suggest("PRNIT", words) == "PRINT");
  CHECK(suggest("IFF", words) == "IF");
  CHECK(suggest("x", words).empty());
  CHECK(suggest("or", words).empty());
  CHECK(suggest("gripper", words).empty());
  CHECK(suggest(std::string(100000, 'M'), words).empty());
}

TEST_CASE("a suggestion is put as a question") {
  CHECK(did_you_mean("MOVE") == "did you mean MOVE?");
  CHECK(did_you_mean("").empty());
}

TEST_CASE("the keys of a robot file are suggested by the same rule") {
  const std::array<std::string_view, 3> keys{"min", "v_max", "a_max"};
  CHECK(suggest("v_maks", keys) == "v_max");
  CHECK(suggest("a_mix", keys) == "a_max");
  CHECK(suggest("_max", keys) == "v_max");  // as near as a_max, and first
  CHECK(suggest("colour", keys).empty());
  CHECK(suggest("", keys).empty());
}
