#include "motion/servo/servo_law.h"

#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <limits>

#include "tests/support/no_allocation.h"
#include "tests/support/relative.h"

namespace rob::motion {
namespace {

constexpr double kLawPeriod = 0.005;

// The x axis of a gantry: 12 kg, 4 N/(m/s), 60 N, 40 rad/s.
DriveData linear_drive() {
  DriveData drive;
  drive.inertia = 12;
  drive.viscous_friction = 4;
  drive.force_max = 60;
  drive.bandwidth = 40;
  return drive;
}

JointVector one_axis_at(double x) { return JointVector::Constant(1, x); }

JointReference reference(double q, double qd, double qdd) {
  return {0, one_axis_at(q), one_axis_at(qd), one_axis_at(qdd)};
}
JointMeasurement measured_at(double q, double qd) { return {0, one_axis_at(q), one_axis_at(qd)}; }

ServoLaw law_of(const DriveData& drive, double period = kLawPeriod) {
  ServoLaw law(std::array{drive}, period);
  law.reset(0);
  return law;
}

// H·v' = u − Dc·v over T under constant u: v and the way.
struct Plant {
  double fade, way_of_v, v_of_u, way_of_u;
  Plant(const DriveData& d, double T) {
    const double tau = d.inertia / d.viscous_friction;
    fade = std::exp(-T / tau);
    way_of_v = tau * (1 - fade);
    v_of_u = (1 - fade) / d.viscous_friction;
    way_of_u = (T - way_of_v) / d.viscous_friction;
  }
};

// One period of the loop as a matrix over (q, v, q a period ago, e), the velocity being the
// difference of two positions, the reference standing at 0.
Eigen::Matrix4d sampled_loop(const DriveData& d, const ServoGains& g, double T) {
  const Plant p(d, T);
  const Eigen::RowVector4d u{-g.kp - g.kv / T - g.ki * T, 0, g.kv / T, g.ki};
  Eigen::Matrix4d A;
  A.row(0) = Eigen::RowVector4d{1, p.way_of_v, 0, 0} + p.way_of_u * u;
  A.row(1) = Eigen::RowVector4d{0, p.fade, 0, 0} + p.v_of_u * u;
  A.row(2) = Eigen::RowVector4d{1, 0, 0, 0};
  A.row(3) = Eigen::RowVector4d{-T, 0, 0, 1};
  return A;
}

double spectral_radius(const Eigen::Matrix4d& A) { return A.eigenvalues().cwiseAbs().maxCoeff(); }

}  // namespace

TEST_CASE("the gains put both error poles at the bandwidth") {
  DriveData drive = linear_drive();
  const ServoGains gains = servo_gains(drive, kLawPeriod);
  CHECK(gains.kp == test::relative(40.0 * 40 * 12));
  CHECK(gains.kv == test::relative(2 * 40.0 * 12 - 4));
  CHECK(gains.ki == test::relative(0.1 * 40 * 19200));
  drive.bandwidth = 10;
  CHECK(servo_gains(drive, kLawPeriod).kp == test::relative(1200));
}

TEST_CASE("a longer servo period lowers the bandwidth") {
  const ServoGains gains = servo_gains(linear_drive(), 0.010);  // 0.2/T = 20 rad/s
  CHECK(gains.kp == test::relative(20.0 * 20 * 12));
}

TEST_CASE("the force is feed-forward, proportional, derivative and integral part") {
  ServoLaw law = law_of(linear_drive());
  // 12·0.1 + 4·0.02 = 1.28; 19200·0.1 mm = 1.92; 956·1 mm/s = 0.956; 76800·0.1 mm·5 ms = 0.0384
  const JointVector u =
      law.update(kLawPeriod, reference(0.1001, 0.020, 0.1), measured_at(0.1, 0.019));
  CHECK(u[0] == test::relative(1.28 + 1.92 + 0.956 + 0.0384));
}

TEST_CASE("the integral grows with the time that has really passed") {
  ServoLaw steady = law_of(linear_drive());
  ServoLaw late = law_of(linear_drive());
  const auto target = reference(1e-4, 0, 0);
  for (int k = 1; k <= 7; ++k) steady.update(k * kLawPeriod, target, measured_at(0, 0));
  late.update(2 * kLawPeriod, target, measured_at(0, 0));
  late.update(2 * kLawPeriod, target, measured_at(0, 0));
  const double u = late.update(7 * kLawPeriod, target, measured_at(0, 0))[0];
  CHECK(u == test::relative(1.92 + 76800 * 1e-4 * 7 * kLawPeriod));
  CHECK(steady.update(7 * kLawPeriod, target, measured_at(0, 0))[0] == test::relative(u));
}

TEST_CASE("the integral never takes more than half of the drive") {
  ServoLaw law = law_of(linear_drive());
  for (const double sign : {1.0, -1.0}) {
    double u = 0;
    law.reset(0);
    for (int k = 1; k < 10000; ++k)
      u = law.update(k * kLawPeriod, reference(sign * 1e-4, 0, 0), measured_at(0, 0))[0];
    CHECK(u == test::relative(sign * (1.92 + 30)));
  }
}

TEST_CASE("the force stays within the drive, and the integral stands still meanwhile") {
  ServoLaw law = law_of(linear_drive());
  for (int k = 1; k <= 1000; ++k)  // 10 mm: 192 N are asked for
    CHECK(law.update(k * kLawPeriod, reference(-0.010, 0, 0), measured_at(0, 0))[0] == -60);
  // Nothing has been wound up: without error there is no force.
  CHECK(law.update(1001 * kLawPeriod, reference(0, 0, 0), measured_at(0, 0))[0] == 0);
}

TEST_CASE("saturation is the greatest share of the drive since it was last asked for") {
  ServoLaw law = law_of(linear_drive());
  law.update(0, reference(0.010, 0, 0), measured_at(0, 0));
  law.update(0, reference(0.001, 0, 0), measured_at(0, 0));
  CHECK(law.take_saturation() == test::relative(192.0 / 60));
  law.update(0, reference(-0.001, 0, 0), measured_at(0, 0));
  CHECK(law.take_saturation() == test::relative(19.2 / 60));
  CHECK(law.take_saturation() == 0);
}

TEST_CASE("an axis whose values are no numbers gets no force, the others theirs") {
  ServoLaw law(std::array{linear_drive(), linear_drive()}, kLawPeriod);
  law.reset(0);
  const JointVector zero = JointVector::Zero(2);
  const JointReference target{0, JointVector::Constant(2, 1e-4), zero, zero};
  JointMeasurement broken{0, zero, zero};
  broken.q[0] = std::numeric_limits<double>::quiet_NaN();
  const JointVector u = law.update(kLawPeriod, target, broken);
  CHECK(u[0] == 0);
  CHECK(u[1] == test::relative(1.92 + 0.0384));
  // The integral of the first has not become NaN: it begins now.
  const JointVector next = law.update(2 * kLawPeriod, target, {0, zero, zero});
  CHECK(next[0] == test::relative(1.92 + 0.0384));
}

TEST_CASE("reset forgets the integral and the time before") {
  ServoLaw law = law_of(linear_drive());
  law.update(1, reference(1e-4, 0, 0), measured_at(0, 0));
  law.reset(100);
  CHECK(law.update(100, reference(1e-4, 0, 0), measured_at(0, 0))[0] == test::relative(1.92));
}

TEST_CASE("without its integral an error dies away as (1 + ωt)·exp(−ωt)") {
  constexpr double T = 1e-4;  // sampling is then not felt
  const DriveData drive = linear_drive();
  const Plant plant(drive, T);
  ServoLaw law = law_of(drive, T);
  double q = 1e-4;
  double v = 0;
  for (int k = 0; k < 2000; ++k) {
    const double t = k * T;
    CHECK(q == test::relative(1e-4 * (1 + 40 * t) * std::exp(-40 * t), 0.005));
    law.reset(t);
    const double u = law.update(t, reference(0, 0, 0), measured_at(q, v))[0];
    q += plant.way_of_v * v + plant.way_of_u * u;
    v = plant.fade * v + plant.v_of_u * u;
  }
}

TEST_CASE("the sampled loop with an estimated velocity is stable, and damped") {
  for (const double inertia : {0.02, 1.0, 12.0, 100.0}) {
    for (const double friction : {1e-3, 0.1, 1.0}) {
      for (const double T : {0.001, 0.005, 0.02}) {
        DriveData drive = linear_drive();
        drive.inertia = inertia;
        drive.viscous_friction = friction * inertia;
        drive.bandwidth = 1e9;  // the servo period alone bounds it: ω·T = 0.2
        const double radius = spectral_radius(sampled_loop(drive, servo_gains(drive, T), T));
        // The slowest pole of s³ + 2ωs² + ω²s + ω³/10 is −0.133·ω: exp(−0.0266) = 0.974 a period.
        CHECK(radius < 0.98);
        CHECK(radius > 0.97);
      }
    }
  }
}

TEST_CASE("five times that bandwidth would be unstable") {
  DriveData fast = linear_drive();
  fast.bandwidth = 200;
  const ServoGains too_high = servo_gains(fast, kLawPeriod / 5);
  CHECK(spectral_radius(sampled_loop(fast, too_high, kLawPeriod)) > 1);
}

TEST_CASE("the law moves a sampled axis as its matrix foretells") {
  const DriveData drive = linear_drive();
  const Plant plant(drive, kLawPeriod);
  const Eigen::Matrix4d A = sampled_loop(drive, servo_gains(drive, kLawPeriod), kLawPeriod);
  ServoLaw law = law_of(drive);
  Eigen::Vector4d x{1e-4, 0, 1e-4, 0};
  double q = 1e-4;
  double v = 0;
  double before = q;
  for (int k = 1; k <= 400; ++k) {
    const double estimate = (q - before) / kLawPeriod;
    before = q;
    const double u = law.update(k * kLawPeriod, reference(0, 0, 0), measured_at(q, estimate))[0];
    q += plant.way_of_v * v + plant.way_of_u * u;
    v = plant.fade * v + plant.v_of_u * u;
    x = A * x;
    REQUIRE(std::abs(q - x[0]) < 1e-15);
  }
  CHECK(std::abs(q) < 1e-7);
}

TEST_CASE("the servo law takes no memory") {
  ServoLaw law = law_of(linear_drive());
  const JointReference target = reference(1e-4, 0, 0);
  const JointMeasurement at = measured_at(0, 0);
  test::NoAllocation guard;
  law.reset(0);
  const double u = law.update(kLawPeriod, target, at)[0] + law.take_saturation();
  CHECK(guard.count() == 0);
  CHECK(u > 0);
}

}  // namespace rob::motion
