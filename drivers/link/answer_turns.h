#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "drivers/link/servo_dialect.h"
#include "motion/space/joint_vector.h"

namespace rob::drivers {

/// The turn of each cycle on a bus of servos, which separates answers of this cycle from late ones,
/// and which servos have answered late.
class AnswerTurns {
 public:
  /// A new cycle. After one that was not whole, its answers may still be on the way, and none of
  /// them may pass for an answer of this cycle: its position would get a wrong instant. A whole
  /// cycle has had the last of them, as no answer overtakes another.
  void begin() noexcept {
    ++cycle_;
    turn_ = whole_ ? 0 : turn_ % (kTurns - 1) + 1;
  }
  int turn() const noexcept { return turn_; }
  /// `whole`: all servos have answered, each to one question.
  void end(bool whole) noexcept { whole_ = whole; }

  /// An answer of servo i to an earlier cycle has come.
  void hear_late(std::size_t i) noexcept { heard_[i] = cycle_; }
  bool late(std::size_t i) const noexcept { return cycle_ - heard_[i] < kRemembered; }
  bool any_late() const noexcept {
    return std::ranges::any_of(heard_,
                               [&](std::uint32_t heard) { return cycle_ - heard < kRemembered; });
  }

 private:
  // Cycles. [choice] Rob stops after three without an answer; an adapter may keep the bytes of some
  // cycles back and then give them out together.
  static constexpr std::uint32_t kRemembered = 10;

  std::uint32_t cycle_ = kRemembered;  ///< so that none counts as late yet
  std::array<std::uint32_t, motion::kMaxJoints> heard_{};
  int turn_ = 0;
  bool whole_ = true;
};

}  // namespace rob::drivers
