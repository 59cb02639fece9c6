#include "motion/generate/path_record.h"

#include <algorithm>
#include <cmath>

#include "motion/space/quintic.h"

namespace rob::motion {

PathRecord::PathRecord(std::size_t most) : places_(most), marks_(most == 0 ? 0 : kMarks) {}

const JointVector& PathRecord::place(std::int64_t number) const noexcept {
  const auto kept = std::clamp(number, static_cast<std::int64_t>(first()), end_ - 1);
  return places_[static_cast<std::size_t>(kept) % places_.size()];
}

double PathRecord::first() const noexcept {
  return static_cast<double>(std::max(begin_, end_ - std::ssize(places_)));
}

void PathRecord::add(const JointVector& q) noexcept {
  grew_ = !places_.empty() && (end_ == 0 || place(end_ - 1) != q);
  if (!grew_) return;
  places_[static_cast<std::size_t>(end_) % places_.size()] = q;
  ++end_;
}

double PathRecord::last_mark() const noexcept {
  return mark_count_ > mark_first_ ? marks_[(mark_count_ - 1) % kMarks].place : -1;
}

/// Where motions begin at one place, since the axes have not moved between them, the last counts.
void PathRecord::mark(Tag tag, bool before) noexcept {
  if (empty()) return;
  const double here = before && grew_ ? std::max(last() - 1, first()) : last();
  if (last_mark() == here) --mark_count_;
  marks_[mark_count_ % kMarks] = {here, tag};
  ++mark_count_;
  if (mark_count_ - mark_first_ > kMarks) ++mark_first_;
}

void PathRecord::cut(double where) noexcept {
  const JointVector here = at(where).q;
  begin_ = static_cast<std::int64_t>(first());  // what is overwritten does not come back
  end_ = static_cast<std::int64_t>(std::floor(where)) + 1;
  while (mark_count_ > mark_first_ && marks_[(mark_count_ - 1) % kMarks].place > where)
    --mark_count_;
  add(here);
}

JointReference PathRecord::at(double where) const noexcept {
  const auto before = static_cast<std::int64_t>(std::floor(where));
  const auto node = [&](std::int64_t number) {
    const JointVector& q = place(number);
    const JointVector& next = place(number + 1);
    const JointVector& last = place(number - 1);
    return JointReference{static_cast<double>(number), q, (next - last) / 2, next - 2 * q + last};
  };
  return quintic_between(node(before), node(before + 1), where);
}

std::optional<PathRecord::Mark> PathRecord::mark_before(double where) const noexcept {
  for (std::size_t i = mark_count_; i > mark_first_; --i) {
    const Mark& mark = marks_[(i - 1) % kMarks];
    if (mark.place < first()) return std::nullopt;
    if (mark.place < where) return mark;
  }
  return std::nullopt;
}

}  // namespace rob::motion
