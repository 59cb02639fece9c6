#include "tests/support/topp.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string>

namespace rob::test {

namespace {

/// Derivatives of the axes at one end of an interval.
struct End {
  AxisValues dq, ddq;
};

struct Interval {
  double sigma = 0;  ///< where it begins
  double length = 0;
  End begin, end;
  double rate = 0;  ///< the greatest that is asked for
};

/// First and second derivative at the share s of the quintic between two nodes, for axis i.
void derive(const ToppNode& a, const ToppNode& b, std::size_t i, double s, double& d, double& dd) {
  const double h = b.sigma - a.sigma;
  // In the unit interval: values p0, p1 and derivatives by s. Coefficients of s^3 … s^5 follow from
  // the three conditions at s = 1.
  const double v0 = a.dq[i] * h, v1 = b.dq[i] * h, w0 = a.ddq[i] * h * h, w1 = b.ddq[i] * h * h;
  const double p = b.q[i] - a.q[i] - v0 - w0 / 2, v = v1 - v0 - w0, w = w1 - w0;
  const double c3 = 10 * p - 4 * v + w / 2, c4 = -15 * p + 7 * v - w, c5 = 6 * p - 3 * v + w / 2;
  d = (v0 + s * (w0 + s * (3 * c3 + s * (4 * c4 + s * 5 * c5)))) / h;
  dd = (w0 + s * (6 * c3 + s * (12 * c4 + s * 20 * c5))) / (h * h);
}

End end_at(const ToppNode& a, const ToppNode& b, double share) {
  End end{AxisValues(a.q.size()), AxisValues(a.q.size())};
  for (std::size_t i = 0; i < a.q.size(); ++i) derive(a, b, i, share, end.dq[i], end.ddq[i]);
  return end;
}

std::vector<Interval> intervals_of(const std::vector<ToppNode>& nodes, std::size_t grid) {
  constexpr std::size_t kLeastParts = 8;  // in each piece, however short
  constexpr double kSame = 1e-12;         // of the path: two nodes at one place, but for rounding
  const double whole = nodes.back().sigma - nodes.front().sigma;
  std::vector<Interval> intervals;
  for (std::size_t k = 0; k + 1 < nodes.size(); ++k) {
    const double length = nodes[k + 1].sigma - nodes[k].sigma;
    if (length <= kSame * whole) continue;
    const double share = static_cast<double>(grid) * length / whole;
    const std::size_t parts = std::max(kLeastParts, static_cast<std::size_t>(share));
    const auto at = [&](std::size_t j) {
      return static_cast<double>(j) / static_cast<double>(parts);
    };
    for (std::size_t j = 0; j < parts; ++j)
      intervals.push_back({nodes[k].sigma + at(j) * length, length / static_cast<double>(parts),
                           end_at(nodes[k], nodes[k + 1], at(j)),
                           end_at(nodes[k], nodes[k + 1], at(j + 1)), nodes[k].rate});
  }
  return intervals;
}

/// The values of σ'' that are allowed.
struct InputRange {
  double least = -std::numeric_limits<double>::infinity();
  double greatest = std::numeric_limits<double>::infinity();

  /// |factor·u + offset| <= most
  void bound(double factor, double offset, double most) {
    if (factor == 0) {
      if (std::abs(offset) > most) greatest = -std::numeric_limits<double>::infinity();
      return;
    }
    const double one = (-most - offset) / factor, other = (most - offset) / factor;
    least = std::max(least, std::min(one, other));
    greatest = std::min(greatest, std::max(one, other));
  }
  bool empty() const { return least > greatest; }
};

/// What σ'' may be in an interval that is entered with σ'² = x and left with `after` at most.
InputRange allowed(const Interval& part, const ToppLimits& limits, double x, double after) {
  InputRange u;
  const double h = 2 * part.length;  // σ'² grows by h·u
  for (std::size_t i = 0; i < limits.a.size(); ++i) {
    u.bound(part.begin.dq[i], part.begin.ddq[i] * x, limits.a[i]);
    u.bound(part.end.dq[i] + h * part.end.ddq[i], part.end.ddq[i] * x, limits.a[i]);
  }
  u.bound(h, x - after / 2, after / 2);  // 0 <= x + h·u <= after
  return u;
}

/// The greatest σ'² that the speeds of the axes and the given rates allow at an end of a part.
double speed_cap(const Interval& part, const End& end, const ToppLimits& limits) {
  const double rate = std::min(limits.rate, part.rate);
  double cap = rate * rate;
  for (std::size_t i = 0; i < limits.v.size(); ++i)
    if (end.dq[i] != 0) cap = std::min(cap, std::pow(limits.v[i] / end.dq[i], 2));
  return cap;
}

/// The greatest x in 0 … most with values of σ'' that are allowed. x = 0, at rest, always has.
double greatest_entry(const Interval& part, const ToppLimits& limits, double most, double after) {
  constexpr int kHalvings = 60;
  if (!allowed(part, limits, most, after).empty()) return most;
  double good = 0, bad = most;
  for (int k = 0; k < kHalvings; ++k) {
    const double middle = (good + bad) / 2;
    (allowed(part, limits, middle, after).empty() ? bad : good) = middle;
  }
  return good;
}

/// σ'² where nothing else bounds it: far above what any axis reaches.
double uncapped(const std::vector<Interval>& parts, const ToppLimits& limits) {
  double most = 0;
  for (const double a : limits.a) most = std::max(most, a);
  const double way = parts.back().sigma + parts.back().length - parts.front().sigma;
  double least_rate = std::numeric_limits<double>::infinity();
  for (const Interval& part : parts) {
    double rate = 0;
    for (const double d : part.begin.dq) rate = std::max(rate, std::abs(d));
    if (rate > 0) least_rate = std::min(least_rate, rate);
  }
  return 1e3 * most * way / least_rate;
}

}  // namespace

ToppMotion time_optimal(const std::vector<ToppNode>& nodes, const ToppLimits& limits,
                        std::size_t grid) {
  const std::vector<Interval> parts = intervals_of(nodes, grid);
  const std::size_t count = parts.size();
  const double uncapped_x = uncapped(parts, limits);
  std::vector<double> most(count + 1, 0.0);  // σ'² from which the rest can be gone
  for (std::size_t k = count; k-- > 0;) {
    double cap = std::min(speed_cap(parts[k], parts[k].begin, limits), uncapped_x);
    if (k > 0) cap = std::min(cap, speed_cap(parts[k - 1], parts[k - 1].end, limits));
    most[k] = greatest_entry(parts[k], limits, cap, most[k + 1]);
  }
  ToppMotion motion;
  double x = 0;
  for (std::size_t k = 0; k < count; ++k) {
    motion.sigma.push_back(parts[k].sigma);
    motion.rate.push_back(std::sqrt(x));
    const InputRange u = allowed(parts[k], limits, x, most[k + 1]);
    const double next = std::clamp(x + 2 * parts[k].length * u.greatest, 0.0, most[k + 1]);
    motion.time += 2 * parts[k].length / (std::sqrt(x) + std::sqrt(next));
    x = next;
  }
  motion.sigma.push_back(parts.back().sigma + parts.back().length);
  motion.rate.push_back(std::sqrt(x));
  for (const double square : most) motion.most.push_back(std::sqrt(square));
  return motion;
}

namespace {

std::vector<std::string_view> cells_of(std::string_view row) {
  std::vector<std::string_view> cells;
  for (std::size_t end = 0; end != std::string_view::npos; row.remove_prefix(end + 1)) {
    end = row.find(',');
    cells.push_back(row.substr(0, end));
    if (end == std::string_view::npos) break;
  }
  return cells;
}

[[noreturn]] void fail(std::size_t row, const std::string& what) {
  throw std::runtime_error("row " + std::to_string(row) + " of the path: " + what);
}

void check_header(const std::vector<std::string_view>& header, std::size_t axes) {
  std::vector<std::string> expected{"sigma"};
  for (const char* prefix : {"q", "dq", "ddq"})
    for (std::size_t i = 1; i <= axes; ++i) expected.push_back(prefix + std::to_string(i));
  if (axes == 0 || !std::equal(header.begin(), header.end(), expected.begin(), expected.end()))
    fail(0, "the header is not sigma, q1 …, dq1 …, ddq1 …");
}

double number(std::string_view cell, std::size_t row) {
  double value = 0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc{} || end != cell.data() + cell.size() || !std::isfinite(value))
    fail(row, "'" + std::string(cell) + "' is not a finite number");
  return value;
}

}  // namespace

std::vector<ToppNode> parse_topp_path(std::string_view text) {
  std::vector<ToppNode> nodes;
  std::size_t axes = 0;
  for (std::size_t row = 0; !text.empty(); ++row) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos) fail(row, "is not complete");
    const auto cells = cells_of(text.substr(0, end));
    text.remove_prefix(end + 1);
    if (row == 0) {
      axes = (cells.size() - 1) / 3;
      check_header(cells, axes);
      continue;
    }
    if (cells.size() != 1 + 3 * axes) fail(row, "has " + std::to_string(cells.size()) + " cells");
    std::vector<double> values;
    for (const std::string_view cell : cells) values.push_back(number(cell, row));
    const auto part = [&](std::size_t k) {
      const auto begin = values.begin() + 1 + static_cast<std::ptrdiff_t>(k * axes);
      return AxisValues(begin, begin + static_cast<std::ptrdiff_t>(axes));
    };
    if (!nodes.empty() && values[0] < nodes.back().sigma) fail(row, "sigma goes back");
    nodes.push_back({values[0], part(0), part(1), part(2)});
  }
  if (nodes.size() < 2) fail(nodes.size(), "there are fewer than two nodes");
  return nodes;
}

}  // namespace rob::test
