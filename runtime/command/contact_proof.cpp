#include "runtime/command/contact_proof.h"

#include <utility>

#include "motion/ahead/corner_ways.h"
#include "runtime/words/contact_words.h"

namespace rob::runtime {

void ContactProof::watch(const Shared& clearance) {
  if (clearance == clearance_) return;
  clearance_ = clearance;
  clearance_mark_ = mark_of(*clearance);
  proof_.emplace(*clearance_, 0);
}

std::optional<Words> ContactProof::hit(int line, const Shared& clearance,
                                       const motion::MotionPlanner::Mark& before,
                                       const motion::SegmentDescriptor& segment) {
  watch(clearance);
  if (clearance_->pairs().empty()) return std::nullopt;
  const std::uint64_t corner_of = before.exact || segment.from_rest ? 0 : known_by_;
  const std::uint64_t known_by = way_mark(corner_of ^ clearance_mark_, before.q, segment);
  const bool cleared = cleared_ != nullptr && cleared_->contains(known_by);
  if (!cleared && !assumptions_.foretelling())
    if (auto words = judge(line, before, segment)) return words;
  known_by_ = known_by;
  if (segment.ahead.length > 0) last_ = segment;
  return std::nullopt;
}

std::optional<Words> ContactProof::judge(int line, const motion::MotionPlanner::Mark& before,
                                         const motion::SegmentDescriptor& segment) {
  Contact contact;
  contact.line = line;
  Touch touch = around(before, segment, contact.q);
  if (touch) {
    contact.corner = true;
  } else {
    proof_->begin(before.q);
    touch = along(segment, contact.share, contact.q);
    contact.at = contact.share * segment.duration;
  }
  if (!touch) return std::nullopt;
  contact.body = clearance_->name_of_body(touch->pair);
  contact.other = clearance_->name_of_other(touch->pair);
  contact.from_start = touch->from_start;
  return words_for(contact, robot_);
}

/// The corner between the motion before and this one.
ContactProof::Touch ContactProof::around(const motion::MotionPlanner::Mark& before,
                                         const motion::SegmentMotion& segment,
                                         motion::JointVector& q) {
  const bool known = last_.number != 0 && last_.target == before.q;
  const motion::CornerWays corner =
      motion::corner_ways(robot_, before, known ? &last_ : nullptr, segment);
  for (const std::vector<motion::JointVector>& way : corner.ways) {
    proof_->begin(way.front());
    proof_->widen(corner.beside);
    for (const motion::JointVector& place : way) {
      q = place;
      if (auto touch = proof_->follow(place)) return touch;
    }
  }
  return std::nullopt;
}

/// Straight on, or along the path from place to place: there are so many between two of its nodes
/// that the axes go straight, but for far less than the distance that counts as contact.
ContactProof::Touch ContactProof::along(const motion::SegmentDescriptor& segment, double& share,
                                        motion::JointVector& q) {
  constexpr int kPlaces = 8;      // [choice] of a piece, which turns an axis by 0.05 rad at most
  constexpr int kStraight = 256;  // [choice] so finely a contact of a straight way is placed
  Touch touch;
  const auto look = [&](double at, const motion::JointVector& place) {
    if (touch) return;
    touch = proof_->follow(place);
    share = at;
    q = place;
  };
  if (segment.path != nullptr) {
    segment.path->survey(kPlaces,
                         [&](double at, const motion::PathPoint& point) { look(at, point.q); });
    return touch;
  }
  const motion::JointVector from = proof_->last();
  for (int i = 1; i <= kStraight; ++i) {
    const double at = static_cast<double>(i) / kStraight;
    look(at, from + at * (segment.target - from));
  }
  return touch;
}

}  // namespace rob::runtime
