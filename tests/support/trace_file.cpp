#include "tests/support/trace_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace rob::test {

namespace {

/// The columns before those that each axis has; `piece` and `limit` are read over.
constexpr const char* kLeading[] = {"t",     "line",     "piece", "sigma",  "rate",
                                    "state", "override", "limit", "late_us"};
constexpr std::size_t kLine = 1;
constexpr std::size_t kLeadingCount = std::size(kLeading);
constexpr const char* kPose[] = {"x", "y", "z", "a", "b", "c"};
constexpr const char* kWrench[] = {"fx", "fy", "fz", "tx", "ty", "tz"};

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t end = text.find(separator);
    parts.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

double number(std::string_view cell, std::size_t row, const std::string& column) {
  double value = 0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc{} || end != cell.data() + cell.size() || !std::isfinite(value)) {
    throw TraceError("row " + std::to_string(row) + ", column " + column + ": '" +
                     std::string(cell) + "' is not a finite number");
  }
  return value;
}

/// Of "tools.rob:5", which names a file that the program USEs, the 5.
std::string_view line_in_file(std::string_view cell) {
  return cell.substr(cell.rfind(':') + 1);  // 0 where there is none
}

/// How many axes a header speaks of: five columns each beside the leading ones, the pose and, where
/// the robot has a sensor, the wrench.
std::size_t axes_of(const std::vector<std::string_view>& header, bool felt) {
  const std::size_t fixed = kLeadingCount + std::size(kPose) + (felt ? std::size(kWrench) : 0);
  const std::size_t axes = header.size() > fixed ? (header.size() - fixed) / 5 : 0;
  const std::vector<std::string> expected = trace_columns(axes, felt);
  if (axes == 0 || !std::equal(header.begin(), header.end(), expected.begin(), expected.end())) {
    throw TraceError("the header is not that of a trace");
  }
  return axes;
}

TraceRow row_from(const std::vector<double>& cells, std::size_t axes, bool felt) {
  TraceRow row;
  row.t = cells[0];
  row.line = static_cast<int>(cells[1]);
  row.sigma = cells[3];
  row.rate = cells[4];
  row.state = static_cast<int>(cells[5]);
  row.override_share = cells[6];
  row.late_us = cells[8];
  auto next = cells.begin() + kLeadingCount;
  const auto take = [&](AxisValues& values) {
    values.assign(next, next + static_cast<std::ptrdiff_t>(axes));
    next += static_cast<std::ptrdiff_t>(axes);
  };
  take(row.q);
  take(row.qd);
  take(row.qdd);
  take(row.measured);
  std::copy_n(next, row.pose.size(), row.pose.begin());
  next += static_cast<std::ptrdiff_t>(row.pose.size());
  if (felt) {
    std::copy_n(next, row.wrench.size(), row.wrench.begin());
    next += static_cast<std::ptrdiff_t>(row.wrench.size());
  }
  take(row.drive);
  return row;
}

}  // namespace

std::vector<std::string> trace_columns(std::size_t axes, bool felt) {
  std::vector<std::string> columns(std::begin(kLeading), std::end(kLeading));
  const auto each_axis = [&](const std::string& prefix) {
    for (std::size_t i = 1; i <= axes; ++i) columns.push_back(prefix + std::to_string(i));
  };
  for (const char* prefix : {"q", "qd", "qdd", "a"}) each_axis(prefix);
  columns.insert(columns.end(), std::begin(kPose), std::end(kPose));
  if (felt) columns.insert(columns.end(), std::begin(kWrench), std::end(kWrench));
  each_axis("drive");
  return columns;
}

TraceFile parse_trace(std::string_view text) {
  if (text.empty() || text.back() != '\n') throw TraceError("the last row is not complete");
  text.remove_suffix(1);
  const std::vector<std::string_view> lines = split(text, '\n');
  TraceFile trace;
  const std::vector<std::string_view> header = split(lines.front(), ',');
  const bool felt = std::ranges::find(header, kWrench[0]) != header.end();
  trace.axes = axes_of(header, felt);
  const std::vector<std::string> columns = trace_columns(trace.axes, felt);
  trace.rows.reserve(lines.size() - 1);
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const std::vector<std::string_view> cells = split(lines[i], ',');
    if (cells.size() != columns.size()) {
      throw TraceError("row " + std::to_string(i) + " has " + std::to_string(cells.size()) +
                       " cells instead of " + std::to_string(columns.size()));
    }
    std::vector<double> numbers;
    for (std::size_t c = 0; c < cells.size(); ++c)
      numbers.push_back(number(c == kLine ? line_in_file(cells[c]) : cells[c], i, columns[c]));
    trace.rows.push_back(row_from(numbers, trace.axes, felt));
  }
  return trace;
}

}  // namespace rob::test
