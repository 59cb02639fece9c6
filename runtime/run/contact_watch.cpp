#include "runtime/run/contact_watch.h"

#include <fmt/format.h>

#include <algorithm>

#include "motion/robots/robot_clearance.h"
#include "runtime/words/codes.h"
#include "runtime/words/units.h"

namespace rob::runtime {

namespace {

/// "JOINTS(0deg, -90deg, …)": as the program would write it.
std::string joints_words(const motion::RobotModel& robot, const motion::JointVector& q) {
  std::string text;
  for (int i = 0; i < robot.axis_count(); ++i) {
    const motion::AxisKind kind = axis_of(robot, i).kind;
    text += fmt::format("{}{}{}", i == 0 ? "" : ", ", shown(q[i] * shown_per_si(kind), 2),
                        unit_name(kind));
  }
  return "JOINTS(" + text + ")";
}

}  // namespace

ContactWatch::ContactWatch(const motion::RobotModel& robot)
    : robot_(robot),
      clearance_(motion::clearance_of(robot)),
      proof_(clearance_, robot.collision.clearance) {}

void ContactWatch::take(const Snapshot& snapshot, int line) {
  if (clearance_.pairs().empty() || contact_) return;
  const motion::JointReference& reference = snapshot.sample.reference;
  if (!first_) {
    if (const auto touch = proof_.follow(reference.q)) {
      contact_ = described(*touch, snapshot);
      return;
    }
  }
  if (!first_ && line == line_) return;
  close_line();
  line_ = line;
  begun_ = reference.time;
  proof_.begin(reference.q);
  first_ = false;
}

Contact ContactWatch::described(const motion::PathProof::Contact& touch,
                                const Snapshot& snapshot) const {
  const motion::JointReference& reference = snapshot.sample.reference;
  return {.line = line_,
          .body = clearance_.name_of_body(touch.pair),
          .other = clearance_.name_of_other(touch.pair),
          .from_start = touch.from_start,
          .at = reference.time - begun_,
          .joints = shown_joints(robot_, reference.q),
          .joints_words = joints_words(robot_, reference.q)};
}

void ContactWatch::close_line() {
  const bool hits = contact_ && contact_->line == line_;
  if (first_ || line_ == 0 || hits || !proof_.nearest()) return;
  const motion::PathProof::Contact& near = *proof_.nearest();
  close_.push_back(
      {lang::Severity::Warning, code::kNearObstacle, lang::tagged_place(line_),
       fmt::format("{} passes {} at a distance of {} mm", clearance_.name_of_body(near.pair),
                   clearance_.name_of_other(near.pair),
                   shown(near.distance * kMillimetresPerMetre, 1)),
       fmt::format("keep {} mm, or lower `clearance` in the robot file",
                   shown(robot_.collision.clearance * kMillimetresPerMetre, 1))});
}

std::vector<lang::Diagnostic> ContactWatch::finish() {
  close_line();
  return std::move(close_);
}

Problem problem_of(const Contact& contact, const std::string& file) {
  const lang::Place place = lang::tagged_place(contact.line);
  if (contact.from_start) {
    return {code::kBeginsInContact, file, place,
            fmt::format("{} touches {} where the motion begins, and would be pressed on at {}",
                        contact.body, contact.other, contact.joints_words),
            "move away from it first: a way on which they part is allowed"};
  }
  return {code::kHits, file, place,
          fmt::format("{} hits {} {} s after the start of line {}, at {}", contact.body,
                      contact.other, shown(contact.at, 2), place.line, contact.joints_words),
          "go round it by other points, or take it out of the robot file if it is not there"};
}

}  // namespace rob::runtime
