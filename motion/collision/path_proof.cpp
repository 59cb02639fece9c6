#include "motion/collision/path_proof.h"

#include <algorithm>

namespace rob::motion {

PathProof::PathProof(const Clearance& clearance, double near)
    : clearance_(clearance), near_(near), watched_(clearance.pairs().size()) {}

void PathProof::begin(const JointVector& q) {
  last_ = q;
  gone_ = JointVector::Zero(q.size());
  nearest_.reset();
  at_start_.reset();
  if (watched_.empty()) return;
  const LinkFrames frames = clearance_.frames(q);
  for (std::size_t i = 0; i < watched_.size(); ++i) {
    const Contact here{clearance_.pairs()[i], clearance_.distance(clearance_.pairs()[i], frames)};
    watched_[i] = {
        .distance = here.distance, .since = gone_, .least = std::min(kContact, here.distance)};
    if (here.distance < kContact && (!at_start_ || here.distance < at_start_->distance))
      at_start_ = here;
    note(here);
  }
}

std::optional<PathProof::Contact> PathProof::follow(const JointVector& q) {
  const JointVector step = q - last_;
  const JointVector way = step.cwiseAbs();
  std::optional<Contact> first;
  double earliest = 1;
  for (std::size_t i = 0; i < watched_.size(); ++i) {
    const double nearer = clearance_.approach(i, gone_ + way - watched_[i].since);
    if (watched_[i].distance - nearer > enough(i)) continue;
    const Along along = look_along(i, step, earliest);
    if (!along.contact) continue;
    first = along.contact;
    earliest = along.share;
  }
  gone_ += way;
  last_ = q;
  return first;
}

/// m: a pair that is farther apart need not be looked at.
double PathProof::enough(std::size_t i) const noexcept {
  return clearance_.pairs()[i].obstacle ? std::max(near_, kContact) : kContact;
}

/// From look to look, each as far from the one before as the pair's distance there allows, up to a
/// share of the step. No two are more than kContact apart where the pair is that near.
PathProof::Along PathProof::look_along(std::size_t i, const JointVector& step, double until) {
  const JointVector way = step.cwiseAbs();
  const double whole = clearance_.approach(i, way);
  double share = 0;
  while (share <= until) {
    const double distance = look(i, last_ + share * step, gone_ + share * way);
    if (watched_[i].touched) return {contact_of(i, distance), share};
    if (share >= until || !(whole > 0)) break;
    const double allowed = std::max(distance - enough(i), kContact) / whole;
    share = std::min(share + allowed, until);
  }
  return {};
}

/// m; notes the distance, and whether the pair has come into contact.
double PathProof::look(std::size_t i, const JointVector& q, const JointVector& gone) {
  constexpr double kSame = 1e-9;  // m [choice] rounding is no approach
  Watched& pair = watched_[i];
  const double distance = clearance_.distance(clearance_.pairs()[i], clearance_.frames(q));
  pair.touched = distance < pair.least - kSame;
  pair.from_start = pair.least < kContact;
  pair.distance = distance;
  pair.since = gone;
  // A pair that has parted may not come into contact again.
  pair.least = std::max(pair.least, std::min(kContact, distance));
  if (!pair.touched) note({clearance_.pairs()[i], distance});
  return distance;
}

PathProof::Contact PathProof::contact_of(std::size_t i, double distance) const {
  return {clearance_.pairs()[i], distance, watched_[i].from_start};
}

void PathProof::note(const Contact& contact) {
  if (!contact.pair.obstacle || contact.distance >= near_) return;
  if (!nearest_ || contact.distance < nearest_->distance) nearest_ = contact;
}

}  // namespace rob::motion
