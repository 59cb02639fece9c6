#include "motion/collision/path_proof.h"

#include <algorithm>

namespace rob::motion {

PathProof::PathProof(const Clearance& clearance, double near)
    : clearance_(&clearance),
      near_(near),
      watched_(clearance.pairs().size()),
      due_(clearance.pairs().size()) {}

/// Where the way goes on, pairs that are known to be far need no look.
void PathProof::begin(const JointVector& q) {
  const bool goes_on = last_.size() == q.size() && last_ == q;
  if (!goes_on) {
    gone_ = JointVector::Zero(q.size());
    approached_ = 0;
  }
  last_ = q;
  nearest_.reset();
  at_start_.reset();
  if (watched_.empty()) return;
  const LinkFrames frames = clearance_->frames(q);
  for (std::size_t i = 0; i < watched_.size(); ++i) {
    if (!goes_on || !far(i, gone_)) {
      measure(i, frames);
      continue;
    }
    watched_[i].least = kContact;
    watched_[i].margin = 0;
  }
}

void PathProof::measure(std::size_t i, const LinkFrames& frames) {
  const Contact here{clearance_->pairs()[i], clearance_->distance(clearance_->pairs()[i], frames)};
  watched_[i] = {
      .distance = here.distance, .since = gone_, .least = std::min(kContact, here.distance)};
  due_[i] = approached_ + here.distance - enough(i);
  if (here.distance < kContact && (!at_start_ || here.distance < at_start_->distance))
    at_start_ = here;
  note(here);
}

void PathProof::widen(const JointVector& beside) {
  for (std::size_t i = 0; i < watched_.size(); ++i) {
    if (watched_[i].least < kContact) continue;
    watched_[i].margin = clearance_->approach(i, beside);
    due_[i] -= watched_[i].margin;
  }
}

/// Whether the pair need not be looked at before the axes have gone so far.
bool PathProof::far(std::size_t i, const JointVector& gone) {
  if (due_[i] > approached_) return true;
  const double nearer = clearance_->approach(i, gone - watched_[i].since);
  const double left = watched_[i].distance - nearer - enough(i);
  if (left > 0) due_[i] = approached_ + left;
  return left > 0;
}

std::optional<PathProof::Contact> PathProof::follow(const JointVector& q) {
  if (watched_.empty()) return std::nullopt;
  const JointVector step = q - last_;
  const JointVector way = step.cwiseAbs();
  approached_ += clearance_->greatest_approach(way);
  std::optional<LinkFrames> at_end;
  // A pair that is so far apart at the end of the step was so all along it.
  const auto is_free = [&](std::size_t i) {
    if (!at_end) at_end = clearance_->frames(q);
    const double distance = clearance_->distance(clearance_->pairs()[i], *at_end);
    if (distance - clearance_->approach(i, way) <= enough(i)) return false;
    watched_[i].distance = distance;
    watched_[i].since = gone_ + way;
    watched_[i].least = kContact;
    due_[i] = approached_ + distance - enough(i);
    return true;
  };
  std::optional<Contact> first;
  double earliest = 1;
  for (std::size_t i = 0; i < watched_.size(); ++i) {
    if (far(i, gone_ + way) || is_free(i)) continue;
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
  const double contact = kContact + watched_[i].margin;
  return clearance_->pairs()[i].obstacle ? std::max(near_, contact) : contact;
}

/// From look to look, each as far from the one before as the pair's distance there allows, up to a
/// share of the step. No two are more than kContact apart where the pair is that near.
PathProof::Along PathProof::look_along(std::size_t i, const JointVector& step, double until) {
  const JointVector way = step.cwiseAbs();
  const double whole = clearance_->approach(i, way);
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
  const double distance = clearance_->distance(clearance_->pairs()[i], clearance_->frames(q));
  pair.touched = distance < pair.least + pair.margin - kSame;
  pair.from_start = pair.least < kContact;
  pair.distance = distance;
  pair.since = gone;
  // A pair that has parted may not come into contact again.
  pair.least = std::max(pair.least, std::min(kContact, distance));
  if (!pair.touched) note({clearance_->pairs()[i], distance});
  return distance;
}

PathProof::Contact PathProof::contact_of(std::size_t i, double distance) const {
  return {clearance_->pairs()[i], distance, watched_[i].from_start};
}

void PathProof::note(const Contact& contact) {
  if (!contact.pair.obstacle || contact.distance >= near_) return;
  if (!nearest_ || contact.distance < nearest_->distance) nearest_ = contact;
}

}  // namespace rob::motion
