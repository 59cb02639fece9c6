#include "drivers/contact/drawn_cell.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/drivers/contact/cell_bench.h"

namespace rob::drivers {
namespace {

using motion::Between;
using motion::CellData;

CellData varied_cell() {
  CellData cell = test::small_cell();
  cell.racks[1].error = {1e-3, 0};
  motion::CellSpread spread;
  spread.stiffness = {20e3, 150e3};
  spread.damping_time = {1e-3, 2e-3};
  spread.friction = {0.1, 0.4};
  spread.force_noise = {0, 0.2};
  spread.torque_noise = {0, 0.01};
  spread.force_bias = {-5, 4};
  spread.torque_bias = {-0.1, 0.2};
  spread.delay = {1e-3, 20e-3};
  spread.running_torque = {0.05, 0.3};
  spread.slip_torque = {1.3, 2};
  spread.hole_error = 4e-3;
  cell.spread = spread;
  return cell;
}

/// Every value that differs.
std::vector<double> values_of(const CellData& cell) {
  std::vector<double> values = {
      cell.contact.stiffness,  cell.contact.damping_time,     cell.contact.friction,
      cell.sensor.force_noise, cell.sensor.torque_noise,      cell.sensor.delay,
      cell.cap.running_torque, cell.cap.slip_torque,          cell.racks[1].error.x(),
      cell.racks[1].error.y(), static_cast<double>(cell.seed)};
  for (int i = 0; i < 3; ++i) {
    values.push_back(cell.sensor.force_bias[i]);
    values.push_back(cell.sensor.torque_bias[i]);
  }
  return values;
}

/// Of a thousand even draws all lie within, and the outer hundredths are not empty: that they are
/// has a probability of 2·0.99^1000 < 1e-4.
void check_fills(const std::vector<double>& drawn, const Between& range) {
  CAPTURE(range.low);
  CAPTURE(range.high);
  const auto [least, most] = std::ranges::minmax(drawn);
  const double margin = 0.01 * (range.high - range.low);
  CHECK(least >= range.low);
  CHECK(least < range.low + margin);
  CHECK(most <= range.high);
  CHECK(most > range.high - margin);
}

template <typename Value>
void check_fills(const Between& range, Value value) {
  const CellData cell = varied_cell();
  std::vector<double> drawn;
  for (std::uint64_t seed = 0; seed < 1000; ++seed) drawn.push_back(value(drawn_cell(cell, seed)));
  check_fills(drawn, range);
}

}  // namespace

TEST_CASE("a thousand cells keep and fill the ranges of their kind") {
  const motion::CellSpread s = *varied_cell().spread;
  check_fills(s.stiffness, [](const CellData& c) { return c.contact.stiffness; });
  check_fills(s.damping_time, [](const CellData& c) { return c.contact.damping_time; });
  check_fills(s.friction, [](const CellData& c) { return c.contact.friction; });
  check_fills(s.force_noise, [](const CellData& c) { return c.sensor.force_noise; });
  check_fills(s.torque_noise, [](const CellData& c) { return c.sensor.torque_noise; });
  check_fills(s.delay, [](const CellData& c) { return c.sensor.delay; });
  check_fills(s.running_torque, [](const CellData& c) { return c.cap.running_torque; });
  check_fills(s.slip_torque, [](const CellData& c) { return c.cap.slip_torque; });
  for (int i = 0; i < 3; ++i) {
    check_fills(s.force_bias, [i](const CellData& c) { return c.sensor.force_bias[i]; });
    check_fills(s.torque_bias, [i](const CellData& c) { return c.sensor.torque_bias[i]; });
  }
}

TEST_CASE("side errors of holes fill their disc evenly, and holes without one keep their place") {
  const CellData cell = varied_cell();
  std::vector<double> area;  // share of the disc nearer to its middle
  Eigen::Vector2d sum(0, 0);
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    const CellData other = drawn_cell(cell, seed);
    area.push_back(other.racks[1].error.squaredNorm() / 16e-6);
    sum += other.racks[1].error;
    CHECK(other.racks[0].error.isZero(0));
    CHECK(other.racks[2].error.isZero(0));
  }
  check_fills(area, {0, 1});
  std::ranges::sort(area);
  CHECK(std::abs(area[500] - 0.5) < 0.07);  // four deviations of the median, 0.5/sqrt(1000) each
  CHECK((sum / 1000).norm() < 4 * 4e-3 / std::sqrt(2000.0));  // each component's is r/2
}

TEST_CASE("the same seed is the same cell, another seed another in every value") {
  const CellData cell = varied_cell();
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    const std::vector<double> drawn = values_of(drawn_cell(cell, seed));
    CHECK(drawn == values_of(drawn_cell(cell, seed)));
    const std::vector<double> next = values_of(drawn_cell(cell, seed + 1));
    for (std::size_t i = 0; i < drawn.size(); ++i) CHECK(drawn[i] != next[i]);
  }
}

TEST_CASE("a cell without a spread changes its noise alone") {
  CellData cell = varied_cell();
  cell.spread.reset();
  std::vector<double> nominal = values_of(cell);
  std::vector<double> drawn = values_of(drawn_cell(cell, 7));
  nominal[10] = 7;
  CHECK(drawn == nominal);
}

}  // namespace rob::drivers
