#include "motion/ahead/leg_writer.h"

#include <algorithm>

namespace rob::motion {

/// A motion without a way may stand after each of them.
std::size_t LegWriter::most_members() const noexcept {
  return std::clamp<std::size_t>(ring_.leg_capacity() / 4, 1, kMostMembers);
}

bool LegWriter::fits() noexcept {
  const std::uint64_t read = written_ - (ring_.leg_capacity() - ring_.leg_room());
  while (!singles_.empty() && singles_.front() < read) singles_.pop_front();
  const std::size_t needed = most_members() > 1 ? 2 * most_members() : 1;
  return singles_.size() < single_ && ring_.leg_room() >= needed;
}

void LegWriter::write(const ShapedLeg& leg, double decides, const PathLeg& like) {
  PathLeg made = like;
  if (!leg.stretch) {
    if (leg.segment.duration >= few_periods(robot_)) singles_.push_back(written_);
    made.segment = leg.segment;
    made.begin = leg.begin;
    made.end = leg.end();
    made.decides = decides;
    made.before = leg.length();
    push(made);
    return;
  }
  for (const PathStretch::Member& member : leg.stretch->members) {
    if (!member.begins) continue;
    const bool last = &member == &leg.stretch->members.back();
    made.segment = member.segment;
    made.begin = leg.begin + member.begin;
    made.end = leg.begin + member.end;
    made.decides = last ? std::max(made.begin, decides) : made.begin;
    made.before = member.before;
    made.beyond = member.beyond;
    push(made);
  }
}

void LegWriter::push(const PathLeg& leg) {
  boxes_.keep(leg.segment);
  ring_.push(leg);
  ++written_;
}

void LegWriter::write_at(const SegmentDescriptor& segment, double sigma) {
  push({segment, sigma, sigma, sigma, 1});
}

void LegWriter::write_at(const PathItem& item, double sigma) {
  if (!item.stretch) return write_at(item.segment, sigma);
  for (const PathStretch::Member& member : item.stretch->members)
    if (member.begins) write_at(member.segment, sigma);
}

}  // namespace rob::motion
