#include "motion/ahead/path_intake.h"

#include <utility>

#include "motion/ahead/run_mean.h"

namespace rob::motion {

namespace {

/// The open leg's successor, and two after it.
constexpr std::size_t kFew = 3;

}  // namespace

std::size_t PathIntake::most(bool at_rest) const {
  if (robot_.tool_coordinates) return at_rest && begins_with_curve() ? kMostParts : kMostLegs;
  return at_rest && awaits_curve() ? kMostBeforeCurve : kFew;
}

void PathIntake::fetch(bool at_rest) {
  while (!full(at_rest)) {
    auto next = merger_.next();
    if (!next) return;
    items_.push_back(*std::move(next));
  }
}

PathItem PathIntake::take() {
  PathItem item = std::move(items_.front());
  items_.pop_front();
  return item;
}

bool PathIntake::nothing_comes() const {
  const bool closed = buffer_.closed();  // before looking: all that was pushed is then seen
  return closed && buffer_.next_segment() == nullptr && !merger_.holds();
}

bool PathIntake::begins_with_curve() const {
  if (items_.empty() || !robot_.tool_coordinates) return false;
  const PathItem& first = items_.front();
  return first.segment.ahead.window > 0 && first.stretch && first.stretch->goes_on;
}

bool PathIntake::awaits_curve() const {
  return !items_.empty() && motion::awaits_curve(robot_, items_);
}

/// [choice] Four legs in two periods: a program that has to measure or wait between them is slower.
bool PathIntake::curve_grows() {
  constexpr std::uint64_t kPeriods = 2;
  constexpr std::size_t kSome = 4;
  const std::uint64_t now = ring_.periods.load(std::memory_order_relaxed);
  grown_ += merger_.grown();
  if (grown_ >= kSome) {
    grown_ = 0;
    grows_until_ = now + kPeriods;
  }
  return now < grows_until_;
}

std::size_t PathIntake::parts_of_curve() const {
  for (std::size_t i = 0; i < items_.size() && items_[i].stretch; ++i)
    if (!items_[i].stretch->goes_on) return i + 1;
  return 0;
}

std::vector<PathItem> PathIntake::legs_of(std::size_t items) const {
  std::vector<PathItem> legs;
  for (std::size_t i = 0; i < items; ++i) {
    for (const PathStretch::Member& member : items_[i].stretch->members) {
      if (member.begins) legs.push_back({member.segment, nullptr});
      if (legs.empty() || member.segment.on_the_way.size() > 0) return {};
      if (legs.size() > 1) legs.back().segment.from_rest = true;
    }
  }
  return legs;
}

void PathIntake::replace(std::size_t items, const std::vector<PathItem>& legs) {
  items_.erase(items_.begin(), items_.begin() + static_cast<std::ptrdiff_t>(items));
  items_.insert(items_.begin(), legs.begin(), legs.end());
}

}  // namespace rob::motion
