#include "motion/servo/reference_history.h"

#include <algorithm>

namespace rob::motion {

void ReferenceHistory::reset(const JointReference& first) noexcept {
  pushed_ = 0;
  push(first);
}

void ReferenceHistory::push(const JointReference& reference) noexcept {
  ring_[pushed_++ % kKept] = reference;
}

JointReference ReferenceHistory::at(double time) const noexcept {
  const std::size_t kept = std::min(pushed_, kKept);
  std::size_t i = 0;
  while (i < kept && back(i).time > time) ++i;
  if (i == 0) return back(0);
  if (i == kept) return back(kept - 1);
  const JointReference& before = back(i);
  const JointReference& after = back(i - 1);
  const double share = (time - before.time) / (after.time - before.time);
  return {time, before.q + share * (after.q - before.q), before.qd + share * (after.qd - before.qd),
          before.qdd + share * (after.qdd - before.qdd)};
}

}  // namespace rob::motion
