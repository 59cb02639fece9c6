#include "runtime/command/next_motion.h"

#include "runtime/command/motion_requests.h"

namespace rob::runtime {

bool NextMotion::takes(const motion::Effect& effect) {
  if (!place_) return false;
  events_.push_back({*place_, effect});
  place_.reset();
  return true;
}

/// A place of the ring is free again when its motion is done: no more can have been commanded.
void NextMotion::live_pace(const lang::Watch& pace, lang::MoveCommand::Pace means) {
  const auto most = static_cast<std::size_t>(motion::most_ahead(links_.robot)) + 2;
  if (paces_.size() < most) paces_.emplace_back(links_.signature.signals, links_.robot);
  ProgramWatch& place = paces_[next_pace_++ % most];
  place.set(pace, lang::dimension_of(means));
  live_ = ProgramPace{place.pace(), means};
}

void NextMotion::drop() {
  place_.reset();
  events_.clear();
  via_.clear();
  live_.reset();
}

}  // namespace rob::runtime
