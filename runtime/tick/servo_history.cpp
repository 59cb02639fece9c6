#include "runtime/tick/servo_history.h"

#include <algorithm>
#include <utility>

#include "motion/space/cycle_instant.h"

namespace rob::runtime {

namespace {

// s. [choice] what a machine that follows later lags and reports after the instant; older
// measurements are those of a machine that does not answer
constexpr double kLongestLag = 0.3;

}  // namespace

void ServoHistory::take(const ServoSample& sample) noexcept {
  kept_[taken_++ % kKept] = {sample.measured, sample.drive, sample.settled, sample.joining};
  saturation_ = std::max(saturation_, sample.saturation);
}

const ServoHistory::Seen* ServoHistory::at(double stamp) const noexcept {
  const std::size_t count = std::min(taken_, kKept);
  const Seen* best = nullptr;
  for (std::size_t back = 1; back <= count; ++back) {
    best = &kept_[(taken_ - back) % kKept];
    if (best->measured.time <= stamp + motion::kSameInstant) break;
  }
  return best;
}

const ServoHistory::Seen* ServoHistory::newest() const noexcept {
  return taken_ == 0 ? nullptr : &kept_[(taken_ - 1) % kKept];
}

void ServoHistory::put_into(Snapshot& snapshot) const noexcept {
  const motion::JointReference& reference = snapshot.sample.reference;
  snapshot.measured = snapshot.drive = reference.q;
  snapshot.drive.setZero();
  const Seen* const servo = at(reference.time);
  if (servo == nullptr) return;
  // On the virtual clock both instants are the same; in real time the servo's is the nearer past.
  const double since = reference.time - servo->measured.time;
  snapshot.measured = servo->measured.q;
  if (since < kLongestLag) snapshot.measured += servo->measured.qd * since;
  snapshot.drive = servo->drive;
}

double ServoHistory::take_saturation() noexcept { return std::exchange(saturation_, 0); }

}  // namespace rob::runtime
