#pragma once

#include <doctest/doctest.h>

#include <cstddef>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/eventually.h"

namespace rob::test {

inline std::size_t lines_in(const std::string& path) {
  std::ifstream file(path);
  std::size_t count = 0;
  for (std::string line; std::getline(file, line);) ++count;
  return count;
}

/// The newest complete row of a trace that may still be growing; empty if there is none.
inline std::vector<double> newest_row(const std::string& trace) {
  std::ifstream file(trace);
  std::string newest;
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line) && !file.eof()) newest = line;
  std::istringstream cells(newest);
  std::vector<double> row;
  for (std::string cell; std::getline(cells, cell, ',');) row.push_back(std::stod(cell));
  return row;
}

// Columns of the trace of three axes.
inline constexpr std::size_t kXSpeed = 12;  ///< of the reference
inline constexpr std::size_t kMeasuredX = 18;

/// Waits until a column of the newest row meets the condition.
template <typename Condition>
void wait_for_row(const std::string& trace, std::size_t column, const Condition& condition) {
  REQUIRE(eventually([&] {
    const std::vector<double> row = newest_row(trace);
    return row.size() > column && condition(row[column]);
  }));
}

/// Waits until the run's trace shows that the robot moves.
inline void wait_until_it_moves(const std::string& trace) {
  REQUIRE(eventually([&] { return lines_in(trace) >= 60; }));
}

}  // namespace rob::test
