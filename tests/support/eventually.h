#pragma once

#include <chrono>
#include <thread>

namespace rob::test {

/// Whether it comes to hold within 5 s: what runs in another thread or process may be slower than
/// the test.
template <typename Condition>
bool eventually(const Condition& condition) {
  for (int i = 0; i < 500 && !condition(); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  return condition();
}

}  // namespace rob::test
