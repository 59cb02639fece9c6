#pragma once

#include <limits>

#include "motion/space/joint_vector.h"

namespace rob::motion {

/// Whether the axes of a machine have come to rest, by what it reports: no axis has moved by more
/// than a count of its encoder for kStill, since they were last sent elsewhere. (Axes that nobody
/// sends anywhere, because the computer is late, stand too.) Every call but the constructor may be
/// used in the tick.
class StillWatch {
 public:
  /// s. [choice] two reports of a machine that reports ten times a second
  static constexpr double kStill = 0.1;

  /// `counts`: of each encoder, m or rad.
  explicit StillWatch(const JointVector& counts) : counts_(counts), still_(counts), sent_(counts) {
    still_.setZero();
    sent_.setConstant(std::numeric_limits<double>::quiet_NaN());
  }

  /// The axes were sent to `q` at `time`, s: what was reported before no longer counts.
  void send(const JointVector& q, double time) noexcept {
    if (near(q, sent_)) return;
    sent_ = q;
    sent_at_ = time;
    begun_ = false;
  }
  /// A position that was reported at `time`, s.
  void look(const JointVector& q, double time) noexcept {
    if (time < sent_at_) return;
    if (begun_ && near(q, still_)) {
      last_ = time;
      return;
    }
    begun_ = true;
    still_ = q;
    since_ = last_ = time;
  }
  bool still() const noexcept { return begun_ && last_ - since_ >= kStill; }

 private:
  bool near(const JointVector& a, const JointVector& b) const noexcept {
    return ((a - b).cwiseAbs().array() <= counts_.array()).all();
  }

  JointVector counts_;
  JointVector still_;  ///< where they have been since since_
  JointVector sent_;
  double sent_at_ = -std::numeric_limits<double>::infinity();
  bool begun_ = false;
  double since_ = 0;
  double last_ = 0;
};

}  // namespace rob::motion
