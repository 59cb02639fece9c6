#include "runtime/run/contact_watch.h"

#include <fmt/format.h>

#include <algorithm>

#include "motion/robots/robot_clearance.h"
#include "runtime/words/codes.h"
#include "runtime/words/units.h"

namespace rob::runtime {

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
          .q = reference.q};
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

}  // namespace rob::runtime
