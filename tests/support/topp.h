#pragma once

#include <cstddef>
#include <limits>
#include <string_view>
#include <vector>

#include "tests/support/paul_model.h"

namespace rob::test {

/// A place of a path with the derivatives of the axes by the path's parameter.
struct ToppNode {
  double sigma = 0;
  AxisValues q, dq, ddq;
  double rate = std::numeric_limits<double>::infinity();  ///< the greatest from here to the next
};

/// What the axes may do, per s and s², and the path's parameter, per s.
struct ToppLimits {
  AxisValues v, a;
  double rate = std::numeric_limits<double>::infinity();  ///< everywhere
};

/// The fastest motion along a path, from rest to rest.
struct ToppMotion {
  double time = 0;  ///< s; infinite where the path cannot be gone at all
  std::vector<double> sigma;
  std::vector<double> rate;  ///< dσ/dt there
  std::vector<double> most;  ///< the greatest from which the rest can be gone
};

/// Reads what `rob check --path` writes: a header row sigma, q1 … qn, dq1 …, ddq1 …, then the
/// nodes. Throws std::runtime_error with the row that is wrong.
std::vector<ToppNode> parse_topp_path(std::string_view text);

/// The time-optimal motion (after Pham, Pham: TOPP-RA, 2018), made slowly and plainly to judge
/// quicker planners by: a grid of about `grid` intervals, each with constant σ'', all limits held
/// at both its ends; the greatest σ'² of each place from which the rest can be gone is found by
/// bisection from the end, then the path is gone as fast as these let it.
///
/// Between nodes axes are quintics through values and both derivatives. Two nodes at one σ: the
/// derivatives leap there.
ToppMotion time_optimal(const std::vector<ToppNode>& nodes, const ToppLimits& limits,
                        std::size_t grid = 100'000);

}  // namespace rob::test
