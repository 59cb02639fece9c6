#include "runtime/tick/path_pause.h"

#include <doctest/doctest.h>

#include <atomic>
#include <thread>

using rob::runtime::PathPause;

TEST_CASE("what the operator asks for holds from the next cycle on") {
  PathPause pause;
  CHECK_FALSE(pause.on());
  CHECK_FALSE(pause.update());
  pause.ask(true);
  CHECK(pause.on());  // before the tick has seen it
  CHECK(pause.update());
  CHECK(pause.update());
  pause.ask(true);
  pause.ask(false);
  CHECK_FALSE(pause.on());
  CHECK_FALSE(pause.update());
}

TEST_CASE("of operator and motion the last to say whether the path pauses counts") {
  PathPause pause;
  pause.set(true);
  CHECK(pause.on());
  CHECK(pause.update());
  pause.ask(false);
  CHECK_FALSE(pause.update());
  pause.ask(false);
  pause.set(true);  // after it: as the tick has not seen what was asked before
  CHECK(pause.on());
  CHECK(pause.update());
  pause.set(true);
  pause.ask(false);
  CHECK_FALSE(pause.on());
  CHECK_FALSE(pause.update());
}

TEST_CASE("a pause that is withdrawn while the tick takes it does not stay") {
  PathPause pause;
  std::atomic<bool> over{false};
  std::thread operator_side([&] {
    for (int i = 0; i < 100'000; ++i) pause.ask(i % 2 == 0);
    over = true;
  });
  while (!over) pause.update();
  operator_side.join();
  CHECK_FALSE(pause.on());  // the last one asked was the 99,999th
  CHECK_FALSE(pause.update());
}
