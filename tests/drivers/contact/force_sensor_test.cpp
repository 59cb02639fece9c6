#include "drivers/contact/force_sensor.h"

#include <doctest/doctest.h>

#include <cmath>
#include <stdexcept>

#include "tests/support/no_allocation.h"
#include "tests/support/relative.h"

namespace rob::drivers {
namespace {

using Eigen::Vector3d;

motion::Wrench down(double force) { return {Vector3d(0, 0, -force), Vector3d(0.1, 0, 0)}; }

}  // namespace

TEST_CASE("the force sensor tells what it took the delay before, and nothing before that") {
  ForceSensor sensor({}, 0.02, 0);
  for (int k = 0; k <= 100; ++k) sensor.take(k * 1e-3, down(k));
  CHECK(sensor.told(0.0195).time == 0);
  CHECK(sensor.told(0.1).time == test::relative(0.08));
  CHECK(sensor.told(0.1).wrench.force.z() == -80);
  CHECK(sensor.told(0.0999).wrench.force.z() == -79);
}

TEST_CASE("bias is added to what acts, and noise has its mean and deviation") {
  motion::SensorErrors errors;
  errors.force_noise = 0.2;
  errors.torque_noise = 0.01;
  errors.force_bias = Vector3d(1, 2, 3);
  errors.torque_bias = Vector3d(0.1, 0, -0.1);
  ForceSensor sensor(errors, 0, 7);
  constexpr int kCount = 20000;
  Vector3d mean = Vector3d::Zero();
  Vector3d square = Vector3d::Zero();
  double torque_square = 0;
  for (int k = 1; k <= kCount; ++k) {
    sensor.take(k * 1e-3, down(10));
    const motion::Wrench told = sensor.told(k * 1e-3).wrench;
    const Vector3d error = told.force - Vector3d(1, 2, -7);
    mean += error / kCount;
    square += error.cwiseAbs2() / kCount;
    torque_square += std::pow(told.torque.x() - 0.2, 2) / kCount;
  }
  // Four standard errors: of the mean σ/√n, of the variance σ²·√(2/n).
  CHECK(mean.cwiseAbs().maxCoeff() < 4 * 0.2 / std::sqrt(kCount));
  for (const double s : {square.x(), square.y(), square.z()})
    CHECK(std::abs(s / 0.04 - 1) < 4 * std::sqrt(2.0 / kCount));
  CHECK(std::abs(torque_square / 1e-4 - 1) < 4 * std::sqrt(2.0 / kCount));
}

TEST_CASE("the same seed gives the same noise, another seed another") {
  motion::SensorErrors errors;
  errors.force_noise = 0.2;
  const auto told = [&](std::uint64_t seed) {
    ForceSensor sensor(errors, 0, seed);
    sensor.take(0.001, down(0));
    return sensor.told(0.001).wrench.force;
  };
  CHECK(told(3) == told(3));
  CHECK(told(3) != told(4));
}

TEST_CASE("fault 21: a sensor that is silent grows old, one that is stuck does not") {
  ForceSensor sensor({}, 0, 0);
  sensor.take(0.001, down(1));
  sensor.fail(ForceSensor::Fault::Silent);
  sensor.take(0.002, down(2));
  CHECK(sensor.told(0.002).time == 0.001);
  sensor.fail(ForceSensor::Fault::Stuck);
  sensor.take(0.003, down(3));
  CHECK(sensor.told(0.003).time == 0.003);
  CHECK(sensor.told(0.003).wrench.force.z() == -1);
}

TEST_CASE("a sensor refuses a delay that it cannot remember, and takes no memory in the tick") {
  CHECK_THROWS_AS(ForceSensor({}, 0.5, 0), std::invalid_argument);
  ForceSensor sensor({}, 0.02, 0);
  const test::NoAllocation guard;
  for (int k = 1; k < 300; ++k) {
    sensor.take(k * 1e-3, down(1));
    (void)sensor.told(k * 1e-3);
  }
  CHECK(guard.count() == 0);
}

}  // namespace rob::drivers
