#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "motion/plan/segment_descriptor.h"
#include "motion/space/joint_vector.h"

namespace rob::motion {

/// The way that the axes have come: the reference of every period in which they moved, numbered on
/// without end, and where motions have begun on it. The last ones are kept. SI. Every call but the
/// constructor may be used in the tick.
class PathRecord {
 public:
  /// Where a motion has begun.
  struct Mark {
    double place = 0;
    Tag tag = 0;
  };

  /// So many periods are kept; 0: nothing is. Takes memory; nothing else here does.
  explicit PathRecord(std::size_t most);

  /// The axes are here; nothing if they were before.
  void add(const JointVector& q) noexcept;
  /// Here a motion begins; `before`: at the place before, if the last add() has led on from there.
  void mark(Tag tag, bool before = false) noexcept;
  /// The way ends at this place; what was recorded after it is forgotten.
  void cut(double where) noexcept;

  /// Its ends, once something has been added.
  bool empty() const noexcept { return end_ == 0; }
  double first() const noexcept;
  double last() const noexcept { return static_cast<double>(end_) - 1; }
  /// Place of the last mark; −1: there is none.
  double last_mark() const noexcept;
  /// Position at a place between its ends, and its derivatives by the place; they are continuous.
  JointReference at(double where) const noexcept;
  /// The last motion that has begun before this place; none where the record begins sooner.
  std::optional<Mark> mark_before(double where) const noexcept;

 private:
  static constexpr std::size_t kMarks = 4096;  ///< [choice] motions of a long program

  const JointVector& place(std::int64_t number) const noexcept;

  std::vector<JointVector> places_;
  std::int64_t end_ = 0;    ///< number of the next place
  bool grew_ = false;       ///< by the last add()
  std::int64_t begin_ = 0;  ///< of the first one of this way
  std::vector<Mark> marks_;
  std::size_t mark_count_ = 0;  ///< of all that have been set and not cut
  std::size_t mark_first_ = 0;  ///< those before are overwritten
};

}  // namespace rob::motion
