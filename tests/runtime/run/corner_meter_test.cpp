#include "runtime/run/corner_meter.h"

#include <doctest/doctest.h>

#include <memory>
#include <vector>

#include "motion/robots/robot_library.h"

namespace rob::runtime {
namespace {

motion::JointVector place(double x, double y) {
  motion::JointVector q(3);
  q << x, y, 0;
  return q;
}

/// A tip that goes 0.15 mm a period along x, past points that are 0.05 mm beside its way; each is
/// watched from `late` periods after the tip has passed it, or before where that is negative, and
/// left a period later.
std::vector<double> misses(int late) {
  const motion::RobotModel robot = motion::embedded_robot("gantry");
  CornerMeter meter(*robot.kinematics);
  constexpr double kStep = 0.15e-3;
  std::vector<double> found;
  const auto take = [&](bool all) {
    while (const auto miss = meter.take(all)) {
      CHECK(miss->tag == 7);
      found.push_back(miss->least);
    }
  };
  for (int k = 0; k < 30; ++k) {
    meter.measured(place(kStep * k, 0));
    take(false);
    if (k < 10 || k >= 20) continue;
    for (int part = 0; part < 3; ++part) {  // motions of 0.05 mm
      const auto number = static_cast<std::uint32_t>(3 * k + part + 1);
      const double x = kStep * (k - late) - kStep * part / 3;
      meter.watch(number, place(x, 0.05e-3), Eigen::Vector3d::Zero());
      if (number > 31) meter.leave(number - 1, 7);
    }
  }
  take(true);
  return found;
}

}  // namespace

TEST_CASE(
    "a point is measured though the tip passes it before its motion begins, or after the next") {
  for (const int late : {-2, -1, 0, 1, 2}) {
    CAPTURE(late);
    const std::vector<double> found = misses(late);
    CHECK(found.size() == 29);
    for (const double miss : found) CHECK(miss == doctest::Approx(0.05e-3).epsilon(1e-6));
  }
}

TEST_CASE("a place that the tip has left on its long way is not what it comes back to") {
  const motion::RobotModel robot = motion::embedded_robot("gantry");
  CornerMeter meter(*robot.kinematics);
  for (int k = 0; k <= 10; ++k) meter.measured(place(1e-3 * k, 0));
  meter.watch(1, place(0.5e-3, 0), Eigen::Vector3d::Zero());  // passed more than four periods ago
  for (int k = 10; k >= 2; --k) meter.measured(place(1e-3 * k, 0));
  meter.leave(1, 3);
  const auto miss = meter.take(true);
  REQUIRE(miss.has_value());
  CHECK(miss->least == doctest::Approx(1.5e-3));
}

TEST_CASE("a point that is never left is forgotten") {
  const motion::RobotModel robot = motion::embedded_robot("gantry");
  CornerMeter meter(*robot.kinematics);
  for (std::uint32_t number = 1; number <= 6; ++number)
    meter.watch(number, place(0, 0), Eigen::Vector3d::Zero());
  meter.measured(place(0, 0));
  for (std::uint32_t number = 1; number <= 6; ++number) meter.leave(number, number);
  std::vector<std::uint32_t> tags;
  while (const auto miss = meter.take(true)) tags.push_back(miss->tag);
  CHECK(tags == std::vector<std::uint32_t>{3, 4, 5, 6});
}

}  // namespace rob::runtime
