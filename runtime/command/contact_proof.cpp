#include "runtime/command/contact_proof.h"

#include "motion/robots/robot_clearance.h"
#include "runtime/words/contact_words.h"

namespace rob::runtime {

ContactProof::ContactProof(const motion::RobotModel& robot, const Assumptions& assumptions)
    : robot_(robot),
      assumptions_(assumptions),
      clearance_(motion::clearance_of(robot)),
      proof_(clearance_, 0) {}

std::optional<Words> ContactProof::hit(int line, const motion::JointVector& from,
                                       const motion::SegmentDescriptor& segment) {
  if (clearance_.pairs().empty() || assumptions_.foretelling()) return std::nullopt;
  proof_.begin(from);
  double share = 0;
  motion::JointVector q;
  const auto touch = follow(segment, share, q);
  if (!touch) return std::nullopt;
  return words_for({.line = line,
                    .body = clearance_.name_of_body(touch->pair),
                    .other = clearance_.name_of_other(touch->pair),
                    .from_start = touch->from_start,
                    .at = share * segment.duration,
                    .share = share,
                    .q = q},
                   robot_);
}

/// Straight on, or along the path from place to place: there are so many between two of its nodes
/// that the axes go straight, but for far less than the distance that counts as contact.
std::optional<motion::PathProof::Contact> ContactProof::follow(
    const motion::SegmentDescriptor& segment, double& share, motion::JointVector& q) {
  constexpr int kPlaces = 8;      // [choice] of a piece, which turns an axis by 0.05 rad at most
  constexpr int kStraight = 256;  // [choice] so finely a contact of a straight way is placed
  std::optional<motion::PathProof::Contact> touch;
  const auto look = [&](double at, const motion::JointVector& place) {
    if (touch) return;
    touch = proof_.follow(place);
    share = at;
    q = place;
  };
  if (segment.path != nullptr) {
    segment.path->survey(kPlaces,
                         [&](double at, const motion::PathPoint& point) { look(at, point.q); });
    return touch;
  }
  const motion::JointVector from = proof_.last();
  for (int i = 1; i <= kStraight; ++i) {
    const double at = static_cast<double>(i) / kStraight;
    look(at, from + at * (segment.target - from));
  }
  return touch;
}

}  // namespace rob::runtime
