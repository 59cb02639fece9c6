#include "motion/space/spsc_queue.h"

#include <doctest/doctest.h>

#include <memory>
#include <thread>

using rob::motion::SpscQueue;

TEST_CASE("a queue gives back all that it was given, in order") {
  SpscQueue<int> queue;
  int next = 0;
  int expected = 0;
  for (int turn = 1; turn <= 20; ++turn) {
    for (int i = 0; i < turn; ++i) queue.push(next++);
    for (int i = 0; i < turn - 1; ++i, ++expected) {
      REQUIRE(queue.front() != nullptr);
      CHECK(*queue.front() == expected);
      queue.pop();
    }
  }
  for (; expected < next; ++expected) {
    REQUIRE(queue.front() != nullptr);
    CHECK(*queue.front() == expected);
    queue.pop();
  }
  CHECK(queue.front() == nullptr);
}

TEST_CASE("a queue destroys the values that nobody has taken, once") {
  const auto value = std::make_shared<int>(1);
  {
    SpscQueue<std::shared_ptr<int>> queue;
    for (int i = 0; i < 5; ++i) queue.push(value);
    queue.pop();
    CHECK(value.use_count() == 6);  // the last one taken goes with the next
    queue.pop();
    CHECK(value.use_count() == 5);
  }
  CHECK(value.use_count() == 1);
}

TEST_CASE("a queue between two threads passes every value on, once and in order") {
  constexpr int kValues = 100'000;
  SpscQueue<int> queue;
  std::thread writer([&] {
    for (int i = 0; i < kValues; ++i) queue.push(i);
  });
  int wrong = 0;
  for (int expected = 0; expected < kValues;) {
    const int* const value = queue.front();
    if (value == nullptr) {
      std::this_thread::yield();
      continue;
    }
    wrong += *value == expected++ ? 0 : 1;
    queue.pop();
  }
  writer.join();
  CHECK(wrong == 0);
}
