#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "motion/ahead/path_planner.h"
#include "motion/ahead/reference_average.h"
#include "motion/kinematics/gantry_kinematics.h"
#include "motion/robots/robot_library.h"

namespace rob::test {

/// Three linear axes: ±1000 mm, 1000 mm/s, 1000 mm/s², references every millisecond; jerk as the
/// means of the legs say.
inline motion::RobotModel fast_table() {
  motion::RobotModel robot = motion::embedded_robot("gantry");
  robot.law = motion::Law::LookAhead;
  robot.reference_period = 0.001;
  robot.servo_period = 0.001;
  for (motion::Axis& axis : robot.axes) {
    const bool linear = axis.kind == motion::AxisKind::Linear;
    axis.min = linear ? -1 : -10;
    axis.max = -axis.min;
    axis.v_max = linear ? 1 : 10;
    axis.a_max = linear ? 1 : 10;
  }
  return robot;
}

/// Path planner, guide and mean alone, stepped by hand: what makes references out of descriptors.
class AheadRun {
 public:
  explicit AheadRun(motion::RobotModel robot = fast_table(), std::size_t legs = 4096)
      : robot_(std::move(robot)),
        buffer_(legs),
        ring_(8192, 2 * legs),
        planner_(robot_, buffer_, ring_),
        guide_(ring_, robot_.start),
        average_(ring_, robot_.start),
        last_(robot_.start) {}

  /// What the next legs ask for.
  motion::LegBounds bounds;
  bool from_rest = false;

  /// Where the axes stand before the first line.
  void from(double x_mm, double y_mm) {
    last_[0] = x_mm / 1000;
    last_[1] = y_mm / 1000;
    guide_.restart(0, last_);
  }

  /// Straight in the axes to q, m and rad; σ is the way of x and y, or 1 mm a degree.
  void line(const motion::JointVector& q) {
    motion::SegmentDescriptor segment;
    segment.number = ++number_;
    segment.target = q;
    segment.from_rest = from_rest;
    segment.ahead = bounds;
    segment.ahead.from = last_;
    segment.ahead.length = (q - last_).head<2>().norm();
    if (segment.ahead.length == 0)
      segment.ahead.length = std::abs(q[2] - last_[2]) * 180 / std::acos(-1.0) * 1e-3;
    last_ = q;
    buffer_.push(segment);
  }
  void line(double x_mm, double y_mm, double turn = 0) {
    motion::JointVector q(3);
    q << x_mm / 1000, y_mm / 1000, turn;
    line(q);
  }
  /// Where the axes will be behind the last line.
  const motion::JointVector& end() const { return last_; }
  void close() { buffer_.close(); }
  motion::LookAheadBuffer& buffer() { return buffer_; }

  /// One period: what the program has commanded, then the tick.
  void step() {
    planner_.work();
    tick();
    references_.push_back(average_.mean());
  }
  /// The tick alone.
  void tick() {
    start_run();
    guide_.set_share(ring_.share.load());
    guide_.step(static_cast<double>(++period_) * robot_.reference_period,
                [](const motion::Guide::Part&) {});
    ring_.sigma.store(guide_.sigma());
    ring_.rate.store(guide_.rate());
    ring_.periods.fetch_add(1);
    average_.take(guide_);
    ring_.release(average_.oldest());
  }
  /// Until the references stand at the end of what was closed; s, or −1 if they never do.
  double run(double at_most = 1000) {
    while (static_cast<double>(period_) * robot_.reference_period < at_most) {
      step();
      if (ended()) return static_cast<double>(period_) * robot_.reference_period;
    }
    return -1;
  }
  /// The references stand at the end of all that is known.
  bool ended() const {
    return guide_.at_run_end() && ring_.next_leg() == nullptr && average_.stands() &&
           ring_.piece(guide_.index()) == nullptr;
  }

  bool stands() const { return average_.stands(); }

  const std::vector<motion::PathPoint>& references() const { return references_; }
  /// Of axis i, over all references: |q''|, and |q'''| as third differences.
  double peak_acceleration(int i) const {
    double peak = 0;
    for (const motion::PathPoint& point : references_)
      peak = std::max(peak, std::abs(point.qdd[i]));
    return peak;
  }
  double peak_jerk(int i) const {
    const double t = robot_.reference_period;
    double peak = 0;
    for (std::size_t k = 3; k < references_.size(); ++k) {
      const auto q = [&](std::size_t at) { return references_[at].q[i]; };
      peak = std::max(peak, std::abs(q(k) - 3 * q(k - 1) + 3 * q(k - 2) - q(k - 3)) / (t * t * t));
    }
    return peak;
  }
  /// The least distance of any reference from a place, m.
  double miss(double x_mm, double y_mm) const {
    double least = std::numeric_limits<double>::infinity();
    for (const motion::PathPoint& point : references_)
      least = std::min(least, std::hypot(point.q[0] - x_mm / 1000, point.q[1] - y_mm / 1000));
    return least;
  }

  motion::PathRing& ring() { return ring_; }
  motion::Guide& guide() { return guide_; }
  motion::PathPlanner& planner() { return planner_; }
  const motion::RobotModel& robot() const { return robot_; }

 private:
  void start_run() {
    while (const motion::PathLeg* leg = ring_.next_leg()) {
      if (guide_.at_run_end() && !average_.stands()) break;
      if (guide_.at_run_end() && ring_.piece(guide_.index()) != nullptr) begin_run(*leg);
      if (leg->begin > guide_.sigma()) break;
      if (leg->begin == guide_.sigma() && !guide_.stands()) break;  // but for rounding
      if (guide_.stands() && guide_.sigma() == 0) begin_run(*leg);
      ring_.pop_leg();
    }
  }

  void begin_run(const motion::PathLeg& leg) {
    const double period = robot_.reference_period;
    const bool first = guide_.sigma() == 0;  // else the last of the mean's jerk is yet to come
    guide_.begin_run(leg.begin, guide_.time() + (first ? 0 : period),
                     leg.pauses ? leg.average * period : 0);
    average_.begin_run(leg.average, leg.of_sigma, guide_);
  }

  const motion::RobotModel robot_;
  motion::LookAheadBuffer buffer_;
  motion::PathRing ring_;
  motion::PathPlanner planner_;
  motion::Guide guide_;
  motion::ReferenceAverage average_;
  motion::JointVector last_;
  std::uint32_t number_ = 0;
  std::int64_t period_ = 0;
  std::vector<motion::PathPoint> references_;
};

}  // namespace rob::test
