#pragma once

#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "tests/support/paul_model.h"

namespace rob::test {

/// One row of a trace, in the units of the file: s, mm, deg and their rates.
struct TraceRow {
  double t = 0;
  int line = 0;
  double sigma = 0;
  double rate = 0;
  int state = 0;
  double override_share = 0;
  double late_us = 0;
  AxisValues q, qd, qdd;           ///< references
  AxisValues measured;             ///< measured positions
  std::array<double, 6> pose{};    ///< x, y, z, a, b, c of the tool, from the references
  std::array<double, 6> wrench{};  ///< N, then Nm, along the world; 0 without a sensor
  AxisValues drive;                ///< what the servo puts out
};

struct TraceFile {
  std::size_t axes = 0;
  std::vector<TraceRow> rows;
};

/// A trace that is not what `rob run --trace` promises: what() names the row and the column.
class TraceError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Reads the text of a trace. The header must hold exactly the promised columns in their order,
/// for any number of axes, and every cell must be a finite number. Throws TraceError.
TraceFile parse_trace(std::string_view text);

/// The columns of a trace for so many axes, in their order.
std::vector<std::string> trace_columns(std::size_t axes, bool felt = false);

}  // namespace rob::test
