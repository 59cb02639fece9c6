#include "drivers/link/answer_turns.h"

#include <doctest/doctest.h>

#include <set>
#include <vector>

#include "drivers/link/dynamixel_dialect.h"
#include "drivers/link/feetech_dialect.h"

namespace rob::drivers {

TEST_CASE("cycles after one with a missing answer have turns of their own, until one is whole") {
  AnswerTurns turns;
  std::vector<int> seen;
  for (int i = 0; i < 10; ++i) {
    turns.begin();
    seen.push_back(turns.turn());
    turns.end(i == 0 || i == 9);
  }
  // The first is whole; 7 turns tell apart 7 cycles.
  CHECK(seen == std::vector<int>{0, 0, 1, 2, 3, 4, 5, 6, 7, 1});
  turns.begin();
  CHECK(turns.turn() == 0);
}

TEST_CASE("a late answer is remembered for ten cycles, for its servo alone") {
  AnswerTurns turns;
  CHECK_FALSE(turns.any_late());
  turns.begin();
  CHECK_FALSE(turns.any_late());
  turns.hear_late(2);
  for (int i = 0; i < 10; ++i) {
    CHECK(turns.late(2));
    CHECK(turns.any_late());
    CHECK_FALSE(turns.late(1));
    turns.begin();
  }
  CHECK_FALSE(turns.late(2));
  CHECK_FALSE(turns.any_late());
}

TEST_CASE_TEMPLATE("the size of a reading tells its turn, and that it is no health", Dialect,
                   DynamixelDialect, FeetechDialect, FeetechScsDialect) {
  std::set<int> sizes;
  for (int turn = 0; turn < kTurns; ++turn) sizes.insert(Dialect::reading_size(turn));
  CHECK(sizes.size() == kTurns);
  // A status without parameters: all of its bytes but those of turn 0.
  const int bare = Dialect::kReadingBytes - Dialect::reading_size(0);
  CHECK_FALSE(sizes.contains(Dialect::kHealthBytes - bare));
  CHECK_FALSE(sizes.contains(1));  // the bus watchdog
  CHECK_FALSE(sizes.contains(0));  // an acknowledgement
}

}  // namespace rob::drivers
