#pragma once

#include <doctest/doctest.h>

#include <chrono>
#include <cstddef>
#include <fstream>
#include <string>
#include <thread>

namespace rob::test {

inline std::size_t lines_in(const std::string& path) {
  std::ifstream file(path);
  std::size_t count = 0;
  for (std::string line; std::getline(file, line);) ++count;
  return count;
}

/// Waits until the run's trace shows that the robot moves. Bounded only against hanging: a loaded
/// computer may take its time.
inline void wait_until_it_moves(const std::string& trace) {
  for (int i = 0; i < 6000 && lines_in(trace) < 60; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  REQUIRE(lines_in(trace) >= 60);
}

}  // namespace rob::test
