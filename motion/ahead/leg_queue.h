#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <optional>

#include "motion/ahead/merge_rules.h"
#include "motion/ahead/path_item.h"
#include "motion/plan/look_ahead_buffer.h"
#include "motion/robots/robot_model.h"

namespace rob::motion {

/// The next motions out of the LookAheadBuffer, and whether they crowd. Belongs to the planner's
/// thread.
class LegQueue {
 public:
  static constexpr double kUnknown = -1;
  /// The longest way, in knots, that a curve takes of the straight leg after it:
  /// CurveFit::end_straight().
  static constexpr double kTail = 4;

  struct Waiting {
    SegmentDescriptor segment;
    bool begins = true;                       ///< not the rest of one
    double wanted = kUnknown;                 ///< m, by the corner at its end
    std::shared_ptr<const PathStretch> part;  ///< of a tool's line: what is left of it
  };
  /// The motion that follows another one in the queue.
  struct Next {
    bool known = true;
    const SegmentDescriptor* segment = nullptr;  ///< null: nothing with a way
    std::size_t at = 0;
  };

  LegQueue(const RobotModel& robot, const MergeRules& rules, LookAheadBuffer& buffer)
      : robot_(robot), rules_(rules), buffer_(buffer) {}

  bool empty() const { return waiting_.empty(); }
  Waiting& front() { return waiting_.front(); }
  void pop_front() { waiting_.pop_front(); }
  /// Removes the first `length` m of it; the caller has them.
  void split_front(double length);
  void clear() { waiting_.clear(); }
  auto begin() const { return waiting_.begin(); }
  auto end() const { return waiting_.end(); }

  /// Before take(): whether more can come.
  void look() { closed_ = buffer_.closed(); }
  /// Fills the queue with as many motions as it takes to decide on the first.
  void take();
  /// Makes do with what is known, until wait().
  void flush() { flushed_ = true; }
  void wait() { flushed_ = false; }
  bool final() const;

  /// The next motion with a way after motion i.
  Next next_way(std::size_t i) const;
  bool rounds_by_jerk() const;
  double wanted(std::size_t i, const Next& next);
  bool crowded(std::size_t i, const Next& next, double before);
  std::optional<bool> crowd_begins(std::size_t i, const Next& next, double before);

 private:
  bool full() const;
  bool averaged(const SegmentDescriptor& segment) const;
  double longest_on_arm(std::size_t i, const Next& next, double before);

  const RobotModel& robot_;
  const MergeRules& rules_;
  LookAheadBuffer& buffer_;
  std::deque<Waiting> waiting_;
  bool flushed_ = false;
  bool closed_ = false;  ///< nothing comes after what is in the buffer
};

}  // namespace rob::motion
