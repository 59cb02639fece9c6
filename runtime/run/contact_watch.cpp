#include "runtime/run/contact_watch.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "motion/robots/robot_clearance.h"
#include "runtime/words/codes.h"
#include "runtime/words/units.h"

namespace rob::runtime {

ContactWatch::ContactWatch(const motion::RobotModel& robot)
    : robot_(robot),
      next_clearance_(std::make_shared<const motion::Clearance>(motion::clearance_of(robot))),
      clearance_(next_clearance_),
      watched_(clearance_),
      proof_(*watched_, robot.collision.clearance) {}

/// A stop that makes the target of a motion exact belongs to it.
void ContactWatch::begin(const LoggedSegment& motion, double time) {
  if (motion.clearance) next_clearance_ = motion.clearance;
  if (motion.further) return;
  next_ = true;
  begins_ = static_cast<int>(motion.tag);
  at_ = time;
}

void ContactWatch::end(const LoggedSegment& motion, bool early) {
  if (!contact_ && motion.known_by != 0) (early ? cut_ : whole_).push_back(motion.known_by);
}

/// From here on; the part that is held is as long as the cell's model knows.
void ContactWatch::watch(const Shared& clearance) {
  clearance_ = watched_ = clearance;
  held_ = holds_;
  if (held_ > 0 && robot_.cell) {
    const double tip = robot_.cell->gripper.tip;
    const double radius = robot_.cell->tube.radius;
    const motion::Capsule part{Eigen::Vector3d(0, 0, tip),
                               Eigen::Vector3d(0, 0, tip + std::max(held_ - radius, 0.0)), radius};
    watched_ = std::make_shared<const motion::Clearance>(
        clearance->with({"part", robot_.axis_count() + 1, {part}}));
  }
  proof_ = motion::PathProof(*watched_, robot_.collision.clearance);
}

void ContactWatch::take(const Snapshot& snapshot) {
  if (contact_) return;
  const motion::JointReference& reference = snapshot.sample.reference;
  if (!first_) {
    if (const auto touch = proof_.follow(reference.q)) {
      contact_ = described(*touch, snapshot);
      return;
    }
  }
  const bool held = holds_ != held_;
  if (!first_ && !next_ && !held) return;
  keep_nearest();
  if (first_ || next_) go_on_in(begins_);
  if (held || next_clearance_ != clearance_) watch(next_clearance_);
  proof_.begin(reference.q);
  first_ = next_ = false;
}

void ContactWatch::go_on_in(int line) {
  line_ = line;
  begun_ = at_;
}

Contact ContactWatch::described(const motion::PathProof::Contact& touch,
                                const Snapshot& snapshot) const {
  const motion::JointReference& reference = snapshot.sample.reference;
  return {.line = line_,
          .body = watched_->name_of_body(touch.pair),
          .other = watched_->name_of_other(touch.pair),
          .from_start = touch.from_start,
          .at = reference.time - begun_,
          .q = reference.q};
}

/// An obstacle that is passed closely is named once a line.
void ContactWatch::keep_nearest() {
  if (first_ || line_ == 0 || !proof_.nearest()) return;
  const motion::PathProof::Contact& passed = *proof_.nearest();
  const Near near{watched_->name_of_body(passed.pair), watched_->name_of_other(passed.pair),
                  passed.distance};
  const auto [kept, first] = nearest_.try_emplace(line_, near);
  if (!first && near.distance < kept->second.distance) kept->second = near;
}

lang::Diagnostic ContactWatch::warning_of(int line, const Near& near) const {
  return {lang::Severity::Warning, code::kNearObstacle, lang::tagged_place(line),
          near_words(near.body, near.other, near.distance),
          fmt::format("keep {} mm, or lower `clearance` in the robot file",
                      shown(robot_.collision.clearance * kMillimetresPerMetre, 1))};
}

std::vector<lang::Diagnostic> ContactWatch::finish() {
  keep_nearest();
  std::vector<lang::Diagnostic> close;
  for (const auto& [line, near] : nearest_)
    if (!contact_ || contact_->line != line) close.push_back(warning_of(line, near));
  return close;
}

std::shared_ptr<const ClearedWays> ContactWatch::cleared(bool early_ones) const {
  auto ways = std::make_shared<ClearedWays>(whole_.begin(), whole_.end());
  if (early_ones) ways->insert(cut_.begin(), cut_.end());
  return ways;
}

}  // namespace rob::runtime
