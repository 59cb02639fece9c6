#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>
#include <variant>
#include <vector>

#include "motion/ahead/path_planner.h"
#include "motion/generate/look_ahead_generator.h"
#include "tests/motion/generate/gantry_run.h"

namespace rob::test {

/// The gantry of S1 under the look-ahead law: 20 mm/s, 100 mm/s², 1000 mm/s³ an axis.
inline motion::RobotModel gantry_looking_ahead() {
  motion::RobotModel robot = motion::embedded_robot("gantry");
  robot.law = motion::Law::LookAhead;
  return robot;
}

/// Planner, buffer, path and generator of a gantry, stepped by hand.
class LookAheadRun {
 public:
  explicit LookAheadRun(motion::RobotModel robot = gantry_looking_ahead())
      : robot_(std::move(robot)),
        buffer_(static_cast<std::size_t>(robot_.look_ahead)),
        planner_(robot_, robot_.start),
        ring_(4096, static_cast<std::size_t>(robot_.look_ahead)),
        path_planner_(robot_, buffer_, ring_),
        generator_(robot_, buffer_, ring_, robot_.start) {}

  // The program's side.
  void move(double x_mm, double y_mm, double theta_deg = 0, motion::Watch guard = {}) {
    auto outcome = planner_.plan(move_to(gantry_q(x_mm, y_mm, theta_deg)));
    motion::SegmentDescriptor segment = std::get<motion::PlannedSegment>(outcome).segment;
    segment.guard = guard;
    push(segment);
  }
  void stop(const motion::SettleWindow& settle = {}) {
    auto segment = planner_.stop(0);
    if (!segment) return;
    segment->settle = settle;
    push(*segment);
  }
  void push(const motion::SegmentDescriptor& segment) {
    if (!buffer_.push(segment)) throw std::logic_error("no room for a segment");
  }
  void effect(std::uint32_t id) {
    motion::Effect effect;
    effect.id = id;
    effect.after = planner_.last_number();
    if (!buffer_.push(effect)) throw std::logic_error("no room for an effect");
  }
  void close() { buffer_.close(); }
  motion::MotionPlanner& planner() { return planner_; }
  motion::LookAheadBuffer& buffer() { return buffer_; }
  std::uint64_t inputs = 0;
  double behind_mm = 0;  ///< by which x is measured short of its reference

  // One cycle: the path is planned, then the tick.
  const motion::GeneratorSample& step() { return advance(period_ + 1); }
  const motion::GeneratorSample& advance(std::int64_t period) {
    path_planner_.work();
    look();
    period_ = period;
    samples_.push_back(generator_.advance(period));
    motion::MotionEvent event;
    while (generator_.take_event(event)) events_.push_back(event);
    motion::Rest rest;
    while (generator_.take_rest(rest)) rests_.push_back(rest);
    return samples_.back();
  }
  void look() {
    motion::CycleView view;
    view.inputs = inputs;
    view.reference = samples_.empty() ? robot_.start : samples_.back().reference.q;
    view.measured = view.reference;
    view.measured[0] -= behind_mm / 1000;
    view.time = samples_.empty() ? 0 : samples_.back().reference.time;
    generator_.look(view);
  }
  void until(double time) {
    while (static_cast<double>(period_ + 1) * robot_.reference_period <= time + 1e-9) step();
  }
  /// Until Finished, but at most `most` periods.
  void finish(std::int64_t most = 100'000) {
    while (all(motion::MotionEvent::Kind::Finished).empty() && most-- > 0) step();
  }

  std::vector<motion::MotionEvent> all(motion::MotionEvent::Kind kind) const {
    std::vector<motion::MotionEvent> found;
    for (const motion::MotionEvent& event : events_)
      if (event.kind == kind) found.push_back(event);
    return found;
  }
  const std::vector<motion::MotionEvent>& events() const { return events_; }
  motion::PathPlanner& path_planner() { return path_planner_; }
  motion::LookAheadGenerator& generator() { return generator_; }
  const motion::RobotModel& robot() const { return robot_; }
  std::int64_t period() const { return period_; }
  const std::vector<motion::GeneratorSample>& samples() const { return samples_; }
  const std::vector<motion::Rest>& rests() const { return rests_; }
  const motion::JointReference& last() const { return samples_.back().reference; }

  /// The greatest share that any reference takes of what an axis may: speed, acceleration, and
  /// jerk, as differences of accelerations.
  struct Peak {
    double speed = 0;
    double acceleration = 0;
    double jerk = 0;
  };
  Peak peak() const {
    Peak peak;
    for (std::size_t k = 0; k < samples_.size(); ++k) {
      const motion::JointReference& r = samples_[k].reference;
      for (int i = 0; i < r.q.size(); ++i) {
        const motion::Axis& axis = robot_.axes[static_cast<std::size_t>(i)];
        peak.speed = std::max(peak.speed, std::abs(r.qd[i]) / axis.v_max);
        peak.acceleration = std::max(peak.acceleration, std::abs(r.qdd[i]) / axis.a_max);
        if (k == 0) continue;
        const motion::JointReference& before = samples_[k - 1].reference;
        const double jerk = std::abs(r.qdd[i] - before.qdd[i]) / (r.time - before.time);
        peak.jerk = std::max(peak.jerk, jerk / axis.j_max);
        const double mean_speed = std::abs(r.q[i] - before.q[i]) / (r.time - before.time);
        peak.speed = std::max(peak.speed, mean_speed / axis.v_max);
      }
    }
    return peak;
  }

 private:
  motion::RobotModel robot_;
  motion::LookAheadBuffer buffer_;
  motion::MotionPlanner planner_;
  motion::PathRing ring_;
  motion::PathPlanner path_planner_;
  motion::LookAheadGenerator generator_;
  std::int64_t period_ = -1;
  std::vector<motion::GeneratorSample> samples_;
  std::vector<motion::MotionEvent> events_;
  std::vector<motion::Rest> rests_;
};

/// The program that S1 measures.
inline void give_published_program(LookAheadRun& run) {
  run.move(40, 40);
  run.move(140, 40);
  run.move(90, 126);
  run.move(40, 40);
  run.stop();
  run.close();
}

}  // namespace rob::test
