#pragma once

#include <cstdint>
#include <initializer_list>
#include <numbers>
#include <random>
#include <variant>
#include <vector>

#include "motion/generate/paul_generator.h"
#include "motion/plan/motion_planner.h"
#include "motion/robots/robot_library.h"

namespace rob::test {

/// x, y in mm, theta in deg, as axis values.
inline motion::JointVector gantry_q(double x_mm, double y_mm, double theta_deg) {
  motion::JointVector q(3);
  q << x_mm / 1000, y_mm / 1000, theta_deg * (std::numbers::pi / 180);
  return q;
}

inline motion::MotionRequest move_to(const motion::JointVector& target, motion::Tag tag = 0) {
  motion::MotionRequest request;
  request.tag = tag;
  request.given = static_cast<std::uint8_t>((1 << target.size()) - 1);
  for (int i = 0; i < target.size(); ++i) request.target[static_cast<std::size_t>(i)] = target[i];
  return request;
}

/// Planner, buffer and generator of a gantry, stepped by hand.
class GantryRun {
 public:
  explicit GantryRun(motion::RobotModel robot = motion::embedded_robot("gantry"))
      : robot_(std::move(robot)),
        buffer_(static_cast<std::size_t>(robot_.look_ahead)),
        planner_(robot_, robot_.start),
        generator_(robot_, buffer_, robot_.start) {}

  // The program's side; what cannot be planned is a mistake of the test and throws.
  motion::SegmentDescriptor move(const motion::MotionRequest& request) {
    const auto segment = std::get<motion::PlannedSegment>(planner_.plan(request)).segment;
    push(segment);
    return segment;
  }
  motion::SegmentDescriptor move(double x_mm, double y_mm, double theta_deg, motion::Tag tag = 0) {
    return move(move_to(gantry_q(x_mm, y_mm, theta_deg), tag));
  }
  void stop(motion::Tag tag = 0, const motion::SettleWindow& settle = {}) {
    auto segment = planner_.stop(tag);
    if (!segment) return;
    segment->settle = settle;
    push(*segment);
  }
  void effect(std::uint32_t id) {
    motion::Effect effect;
    effect.id = id;
    effect.after = planner_.last_number();
    effect_after(effect);
  }
  void effect_after(const motion::Effect& effect) {
    if (!buffer_.push(effect)) throw std::logic_error("no room for an effect");
  }
  void push(const motion::SegmentDescriptor& segment) {
    if (!buffer_.push(segment)) throw std::logic_error("no room for a segment");
  }
  void close() { buffer_.close(); }
  motion::LookAheadBuffer& buffer() { return buffer_; }
  std::uint64_t inputs = 0;
  double behind_mm = 0;  ///< by which x is measured short of its reference

  // The tick's side.
  const motion::GeneratorSample& step() { return advance(period_ + 1); }
  const motion::GeneratorSample& advance(std::int64_t period) {
    look();
    period_ = period;
    samples_.push_back(generator_.advance(period));
    motion::MotionEvent event;
    while (generator_.take_event(event)) events_.push_back(event);
    motion::Rest rest;
    while (generator_.take_rest(rest)) rests_.push_back(rest);
    return samples_.back();
  }
  /// The world of the cycle that computes the next reference: the axes stand where they should.
  void look() {
    motion::CycleView view;
    view.inputs = inputs;
    view.reference = samples_.empty() ? robot_.start : samples_.back().reference.q;
    view.measured = view.reference;
    view.measured[0] -= behind_mm / 1000;
    view.time = samples_.empty() ? 0 : samples_.back().reference.time;
    generator_.look(view);
  }
  /// Until Finished, but at most `most` periods.
  void finish(std::int64_t most = 1'000'000) {
    while (!saw(motion::MotionEvent::Kind::Finished) && most-- > 0) step();
  }

  bool saw(motion::MotionEvent::Kind kind) const { return !all(kind).empty(); }
  std::vector<motion::MotionEvent> all(motion::MotionEvent::Kind kind) const {
    std::vector<motion::MotionEvent> found;
    for (const motion::MotionEvent& event : events_)
      if (event.kind == kind) found.push_back(event);
    return found;
  }

  const motion::RobotModel& robot() const { return robot_; }
  motion::MotionPlanner& planner() { return planner_; }
  motion::PaulGenerator& generator() { return generator_; }
  const std::vector<motion::GeneratorSample>& samples() const { return samples_; }
  const std::vector<motion::MotionEvent>& events() const { return events_; }
  const std::vector<motion::Rest>& rests() const { return rests_; }
  std::int64_t period() const { return period_; }

 private:
  motion::RobotModel robot_;
  motion::LookAheadBuffer buffer_;
  motion::MotionPlanner planner_;
  motion::PaulGenerator generator_;
  std::int64_t period_ = -1;
  std::vector<motion::GeneratorSample> samples_;
  std::vector<motion::MotionEvent> events_;
  std::vector<motion::Rest> rests_;
};

/// The program that S1 measures, its STOP, and END.
inline void give_published_program(GantryRun& run) {
  run.move(40, 40, 0, 1);
  run.move(140, 40, 0, 2);
  run.move(90, 126, 0, 3);
  run.move(40, 40, 0, 4);
  run.stop(5);
  run.close();
}

/// Targets within the gantry's limits: now and then on a limit, near the last, or the last again.
class RandomTargets {
 public:
  RandomTargets(const motion::RobotModel& robot, unsigned seed)
      : robot_(robot), random_(seed), last_(robot.start) {}

  motion::JointVector next() {
    const int kind = pick(0, 9);
    if (kind == 0) return last_;
    for (int i = 0; i < robot_.axis_count(); ++i) {
      const motion::Axis& axis = robot_.axes[static_cast<std::size_t>(i)];
      double value = axis.min + (axis.max - axis.min) * share();
      if (kind == 1) value = axis.min;
      if (kind == 2) value = axis.max;
      if (kind <= 5 && kind > 2) value = last_[i] + (value - last_[i]) * 0.05;
      last_[i] = value;
    }
    return last_;
  }
  double share() { return std::uniform_real_distribution<>(0, 1)(random_); }
  int pick(int low, int high) { return std::uniform_int_distribution<>(low, high)(random_); }

 private:
  const motion::RobotModel& robot_;
  std::mt19937 random_;
  motion::JointVector last_;
};

}  // namespace rob::test
