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

/// A stop that makes the target of a motion exact belongs to it.
void ContactWatch::begin(const LoggedSegment& motion, double time) {
  if (motion.further) return;
  next_ = true;
  begins_ = static_cast<int>(motion.tag);
  at_ = time;
}

void ContactWatch::end(const LoggedSegment& motion, bool early) {
  if (!contact_ && motion.known_by != 0) (early ? cut_ : whole_).push_back(motion.known_by);
}

void ContactWatch::take(const Snapshot& snapshot) {
  if (clearance_.pairs().empty() || contact_) return;
  const motion::JointReference& reference = snapshot.sample.reference;
  if (!first_) {
    if (const auto touch = proof_.follow(reference.q)) {
      contact_ = described(*touch, snapshot);
      return;
    }
  }
  if (!first_ && !next_) return;
  go_on_in(begins_);
  proof_.begin(reference.q);
  first_ = next_ = false;
}

/// What is passed closely is told once a line.
void ContactWatch::go_on_in(int line) {
  keep_nearest();
  line_ = line;
  begun_ = at_;
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

void ContactWatch::keep_nearest() {
  if (first_ || line_ == 0 || !proof_.nearest()) return;
  const auto [kept, first] = nearest_.try_emplace(line_, *proof_.nearest());
  if (!first && proof_.nearest()->distance < kept->second.distance)
    kept->second = *proof_.nearest();
}

lang::Diagnostic ContactWatch::warning_of(int line, const motion::PathProof::Contact& near) const {
  return {lang::Severity::Warning, code::kNearObstacle, lang::tagged_place(line),
          near_words(clearance_.name_of_body(near.pair), clearance_.name_of_other(near.pair),
                     near.distance),
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
