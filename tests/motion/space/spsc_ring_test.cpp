#include "motion/space/spsc_ring.h"

#include <doctest/doctest.h>

#include <thread>

#include "tests/support/no_allocation.h"

using rob::motion::SpscRing;

TEST_CASE("a ring holds exactly its capacity and gives it back in order") {
  SpscRing<int> ring(3);
  for (int round = 0; round < 5; ++round) {
    CHECK(ring.front() == nullptr);
    for (int i = 0; i < 3; ++i) CHECK(ring.push(10 * round + i));
    CHECK(ring.full());
    CHECK_FALSE(ring.push(99));
    for (int i = 0; i < 3; ++i) {
      int value = -1;
      CHECK(ring.take(value));
      CHECK(value == 10 * round + i);
    }
    CHECK_FALSE(ring.full());
  }
}

TEST_CASE("two threads pass every value on, once and in order") {
  constexpr int kValues = 100'000;
  SpscRing<int> ring(64);
  std::thread writer([&] {
    for (int i = 0; i < kValues;)
      if (ring.push(i)) {
        ++i;
      } else {
        std::this_thread::yield();
      }
  });
  int wrong = 0;
  for (int expected = 0; expected < kValues;) {
    int value = 0;
    if (!ring.take(value)) {
      std::this_thread::yield();
      continue;
    }
    wrong += value == expected++ ? 0 : 1;
  }
  writer.join();
  CHECK(wrong == 0);
}

TEST_CASE("a ring takes no memory after it is made") {
  SpscRing<int> ring(8);
  rob::test::NoAllocation guard;
  int value = 0;
  for (int i = 0; i < 100; ++i) {
    ring.push(i);
    ring.take(value);
  }
  CHECK(value == 99);
  CHECK(guard.count() == 0);
}

TEST_CASE("a ring tells how much room it has, wherever in it the values lie") {
  rob::motion::SpscRing<int> ring(3);
  for (int turn = 0; turn < 5; ++turn) {
    CHECK(ring.room() == 3);
    CHECK(ring.push(1));
    CHECK(ring.room() == 2);
    CHECK(ring.push(2));
    ring.pop();
    CHECK(ring.room() == 2);
    CHECK(ring.push(3));
    CHECK(ring.push(4));
    CHECK(ring.room() == 0);
    for (int k = 0; k < 3; ++k) ring.pop();
  }
}
