#include "drivers/contact/sim_cell.h"

#include <doctest/doctest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include "drivers/sim/sim_gantry.h"
#include "motion/kinematics/arm_kinematics.h"
#include "tests/drivers/contact/cell_bench.h"
#include "tests/support/no_allocation.h"
#include "tests/support/relative.h"

namespace rob::drivers {
namespace {

using Eigen::Vector3d;
using motion::JointVector;
using motion::Pose;

/// S4's arm.
std::shared_ptr<const motion::ArmKinematics> arm() {
  motion::ArmParameters p;
  p.c1 = 0.205;
  p.c2 = 0.35;
  p.c3 = 0.305;
  p.c4 = 0.075;
  p.sign = {1, 1, -1, 1, -1, 1};
  return std::make_shared<motion::ArmKinematics>(p);
}

/// Its axes go where they are told: encoders without error, drives without mass.
class CarriedArm final : public SimMachine {
 public:
  explicit CarriedArm(const JointVector& start) : SimMachine(start, {{0, 1, 0, 0.2}}), q_(start) {}
  double true_position(int axis) const noexcept override { return q_[axis]; }
  void stand_at(const JointVector& q) noexcept { q_ = q; }

 private:
  void place(const JointVector& q) noexcept override { q_ = q; }
  void push(const JointVector&) noexcept override {}
  void hold() noexcept override {}
  void release() noexcept override {}
  void advance(double) noexcept override {}
  void sample() noexcept override {}
  void settle() noexcept override {}
  void measure(JointVector& q, JointVector& qd) const noexcept override {
    q = q_;
    qd.setZero();
  }

  JointVector q_;
};

/// Carries the tip of a hand that points down through the cell of cell_bench.h, 0.1 m further from
/// its base.
class Hand {
 public:
  explicit Hand(motion::CellData cell, double delay = 0.02, double period = 2e-3)
      : arm_(arm()), period_(period) {
    for (motion::RackData& rack : cell.racks) rack.x += 0.1;
    for (motion::CapSupplyData& supply : cell.cap_supplies) supply.place.x() += 0.1;
    cell.table = 0.05;
    q_ = JointVector::Zero(6);
    q_ << 0, 0.5, -1.5, 0, -1, 0;
    q_ = posture(Vector3d(0.45, 0.2, 0.15));
    auto machine = std::make_unique<CarriedArm>(q_);
    machine_ = machine.get();
    cell_ = std::make_unique<SimCell>(std::move(machine), arm_, cell, delay);
    cell_->open();
    read();
  }

  SimCell& cell() { return *cell_; }
  const motion::ServoState& state() const { return state_; }
  double time() const { return time_; }
  /// The reaction's component upwards: the flange's z points down.
  double up() const { return -state_.wrench.force.z(); }

  void go(const Vector3d& tip, double speed) {
    const Vector3d from = tip_;
    const double span = (tip - from).norm() / speed;
    const int steps = std::max(1, static_cast<int>(std::lround(span / period_)));
    for (int i = 1; i <= steps; ++i) {
      machine_->stand_at(posture(from + (tip - from) * i / steps));
      tick();
    }
  }
  void rest(double time) {
    for (double t = 0; t < time - 1e-9; t += period_) tick();
  }
  void jaws(bool closed) {
    outputs_ = closed ? 1 : 0;
    rest(0.22);
  }

 private:
  JointVector posture(const Vector3d& tip) {
    tip_ = tip;
    const Pose flange{tip + Vector3d(0, 0, 0.12), Eigen::Quaterniond(0, 1, 0, 0)};
    q_ = arm_->inverse(flange, q_).value();
    return q_;
  }
  void read() { cell_->read(time_, state_); }
  void tick() {
    motion::ServoCommand command;
    command.drive = JointVector::Zero(6);
    command.outputs = outputs_;
    cell_->write(time_, command);
    time_ += period_;
    read();
  }

  std::shared_ptr<const motion::ArmKinematics> arm_;
  CarriedArm* machine_ = nullptr;
  std::unique_ptr<SimCell> cell_;
  JointVector q_;
  Vector3d tip_ = Vector3d::Zero();
  motion::ServoState state_;
  std::uint64_t outputs_ = 0;
  double time_ = 1;
  double period_;
};

}  // namespace

TEST_CASE("a tool that is lowered on the table feels stiffness times depth, late by the delay") {
  Hand hand(test::small_cell());
  hand.go(Vector3d(0.45, 0.2, 0.055), 0.05);  // the fingers' ends, 5 mm beyond, at the table
  hand.go(Vector3d(0.45, 0.2, 0.053), 0.005);
  // 20 ms before the end of the way it was 0.1 mm higher.
  CHECK(hand.up() == test::relative(50e3 * 1.9e-3, 1e-6));
  CHECK(hand.state().wrench_time == test::relative(hand.time() - 0.02));
  hand.rest(0.03);
  CHECK(hand.up() == test::relative(50e3 * 2e-3, 1e-6));
}

TEST_CASE("a wrench is about the flange and along its axes") {
  motion::CellData cell = test::small_cell();
  cell.contact.friction = 0.5;
  Hand hand(cell, 0);
  hand.go(Vector3d(0.45, 0.2, 0.0548), 0.01);
  hand.go(Vector3d(0.46, 0.2, 0.0548), 0.01);
  // 10 N up, 5 N against the way along world x: flange x. Flange y and z are world −y and −z.
  const motion::Wrench& wrench = hand.state().wrench;
  CHECK(wrench.force.x() == test::relative(-5, 1e-6));
  CHECK(std::abs(wrench.force.y()) < 1e-6);
  CHECK(wrench.force.z() == test::relative(-10, 1e-6));
  // Acting on the tip, which stands 0.2 mm above where it is carried and is held back by 0.1 mm:
  // τ = r × F with r = (−0.1 mm, 0, 0.1198 m) and F = (−5, 0, −10) N.
  CHECK(wrench.torque.y() == test::relative(0.1198 * -5 - -0.1e-3 * -10, 1e-6));
}

TEST_CASE("the jaws take a tube when they have closed, and say so") {
  Hand hand(test::small_cell());
  hand.go(Vector3d(0.4, 0, 0.15), 0.1);
  CHECK(hand.state().inputs == 0b010);  // open
  hand.jaws(true);
  CHECK(hand.state().inputs == 0b001);  // closed on nothing
  hand.jaws(false);
  hand.go(Vector3d(0.4, 0, 0.25), 0.1);
  hand.go(Vector3d(0.5, 0, 0.25), 0.1);
  hand.go(Vector3d(0.5, 0, 0.11), 0.1);
  hand.jaws(true);
  CHECK(hand.state().inputs == 0b101);
  CHECK(hand.cell().scene().holds_cap());
  hand.jaws(false);
  CHECK(hand.state().inputs == 0b010);
  CHECK_FALSE(hand.cell().scene().holds_something());
}

TEST_CASE("what is felt depends on the way, not on how often it is asked for") {
  // A sample that is 3 ms old: between two readings that are 2 ms apart, or 8 ms.
  const auto felt = [](double period) {
    Hand hand(test::small_cell(), 3e-3, period);
    hand.go(Vector3d(0.45, 0.2, 0.0622), 0.1);
    hand.go(Vector3d(0.45, 0.2, 0.0542), 0.1);
    return hand.up();
  };
  const double expected = 50e3 * (0.8e-3 - 0.1 * 3e-3);
  CHECK(felt(2e-3) == test::relative(expected, 1e-6));
  CHECK(felt(8e-3) == test::relative(expected, 1e-6));
}

TEST_CASE("the cell begins anew when the machine is powered up") {
  Hand hand(test::small_cell());
  hand.go(Vector3d(0.122, 0, 0.25), 0.2);
  hand.go(Vector3d(0.122, 0, 0.1), 0.2);
  hand.jaws(true);
  hand.go(Vector3d(0.122, 0, 0.25), 0.2);
  CHECK(hand.cell().scene().holds_tube());
  CHECK_FALSE(hand.cell().scene().occupied(1));
  hand.cell().open();
  CHECK(hand.cell().scene().occupied(1));
  CHECK_FALSE(hand.cell().scene().holds_something());
}

TEST_CASE("the cell takes no memory in the tick") {
  Hand hand(test::small_cell());
  const test::NoAllocation guard;
  hand.go(Vector3d(0.45, 0.2, 0.0545), 0.05);
  CHECK(guard.count() == 0);
}

}  // namespace rob::drivers
