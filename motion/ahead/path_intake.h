#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

#include "motion/ahead/path_item.h"
#include "motion/ahead/path_merger.h"
#include "motion/ahead/path_ring.h"
#include "motion/plan/look_ahead_buffer.h"
#include "motion/robots/robot_model.h"

namespace rob::motion {

/// The items that have not been taken up: what the PathMerger makes of the motions in the
/// LookAheadBuffer, as far as it is known. Belongs to the planner's thread.
class PathIntake {
 public:
  /// On an arm so many items at most are looked at to choose between a corner and a stop.
  static constexpr std::size_t kMostLegs = 8;
  /// The same of the parts of a curve. [choice] 40 mm of chords of 0.01 mm
  static constexpr std::size_t kMostParts = 64;

  /// `most_members`: motions that may begin in one item.
  PathIntake(const RobotModel& robot, LookAheadBuffer& buffer, const PathRing& ring,
             std::size_t most_members)
      : robot_(robot), buffer_(buffer), ring_(ring), merger_(robot, buffer, most_members) {}

  /// Takes what can be had, as many items as are looked at. `at_rest`: the first of them begins a
  /// run.
  void fetch(bool at_rest);
  /// So many items are looked at, and they are here.
  bool full(bool at_rest) const { return items_.size() >= most(at_rest); }
  const std::deque<PathItem>& items() const { return items_; }
  /// The i-th item; null: not known.
  const PathItem* at(std::size_t i) const { return i < items_.size() ? &items_[i] : nullptr; }
  PathItem take();

  /// Motions wait for others, with which they may become one item.
  bool holds() const { return merger_.holds(); }
  /// They make do with what is known.
  void flush() { merger_.flush(); }
  /// Nothing comes after the items.
  bool nothing_comes() const;
  /// For how many motions the program has room.
  std::size_t room() const { return buffer_.room(); }
  bool closed() const { return buffer_.closed(); }
  /// Gives up all that is here, and what the program has sent; calls give_up(segment) for each.
  template <typename GiveUp>
  void drop(GiveUp&& give_up) {
    for (const PathItem& item : items_) give_up(item.segment);
    items_.clear();
    merger_.drop(give_up);
    while (const SegmentDescriptor* next = buffer_.next_segment()) {
      give_up(*next);
      buffer_.pop_segment();
    }
  }

  // Curves.
  /// A run on an arm begins with a curve: the more is known of it, the better is its mean.
  bool begins_with_curve() const;
  /// The mean of a run that begins here depends on a curve that is not known yet.
  bool awaits_curve() const;
  /// The program adds to a curve leg after leg, so it is worth waiting for more of it.
  bool curve_grows();
  /// The number of items that belong to the curve at their front; 0 if there is no curve, or its
  /// end is not known yet.
  std::size_t parts_of_curve() const;
  /// The motions on the first items as the program commanded them, each from rest. Empty if one has
  /// path events, or begins before these items.
  std::vector<PathItem> legs_of(std::size_t items) const;
  void replace(std::size_t items, const std::vector<PathItem>& legs);

 private:
  std::size_t most(bool at_rest) const;

  const RobotModel& robot_;
  LookAheadBuffer& buffer_;
  const PathRing& ring_;
  PathMerger merger_;
  std::deque<PathItem> items_;
  std::uint64_t grows_until_ = 0;  ///< PathRing::periods up to which a curve counts as growing
  std::size_t grown_ = 0;          ///< legs that it has taken since then
};

}  // namespace rob::motion
