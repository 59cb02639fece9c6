#pragma once

#include <chrono>
#include <thread>

namespace rob::test {

/// Waits until the condition holds, and returns whether it does. What runs in another thread or
/// process may be slower than the test, so the limit of 60 s only guards against hanging.
template <typename Condition>
bool eventually(const Condition& condition) {
  for (int i = 0; i < 6000 && !condition(); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  return condition();
}

}  // namespace rob::test
