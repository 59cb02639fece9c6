#include <string>
#include <utility>

#include "runtime/command/robot_machine.h"
#include "runtime/words/messages.h"

/// Member functions of RobotMachine that set up what is checked in every control cycle.
namespace rob::runtime {

using lang::Reply;

Reply RobotMachine::guard(int /*line*/, const lang::Watch& condition) {
  until_.set(condition);
  guarded_ = true;
  return Reply::Done;
}

/// A place of the ring is free again when its motion is done: no more can have been commanded.
Reply RobotMachine::live_pace(int /*line*/, const lang::Watch& pace,
                              lang::MoveCommand::Pace means) {
  const auto most = static_cast<std::size_t>(robot_.most_ahead()) + 2;
  if (paces_.size() < most) paces_.emplace_back(signals_, robot_);
  ProgramWatch& place = paces_[next_pace_++ % most];
  place.set(pace);
  live_ = ProgramPace{place.pace(), pace_of(means)};
  return Reply::Done;
}

/// The motion is made exact; its Rest tells how it ended.
Reply RobotMachine::ended(int line, bool& hit) {
  if (!exact_ && !jogging_) {
    if (buffer_.full()) return Reply::Later;
    if (const auto segment = planner_.stop(static_cast<motion::Tag>(line))) {
      queue(*segment, true, true);
    }
  }
  motion::Rest rest;
  if (left_) {
    rest = *std::exchange(left_, std::nullopt);
  } else if (jogging_ ? !take_jog_rest(rest) : !take_rest(rest)) {
    return Reply::Later;
  }
  guarded_ = false;
  brakable_ = 0;
  if (rest.early()) {
    restart_from(rest.q);
  } else if (jogging_) {
    come_to_rest(rest.q);
  }
  hit_ = rest.early() ? rest.trip_q : pressing_ != Pressing::No ? channels_.joints.load() : rest.q;
  hit = rest.outcome == motion::Rest::Outcome::Hit;
  if (rest.outcome != motion::Rest::Outcome::Failed) return Reply::Done;
  refuse(words_for_condition(until_.error()));
  return Reply::Refused;
}

Reply RobotMachine::when(int line, const lang::Watch& condition, int& id) {
  motion::WatchedAction* const action = whens_.set_up(line, condition, id);
  if (action == nullptr) return Reply::Later;
  recording_ = action;
  ++armed_;
  return Reply::Done;
}

Reply RobotMachine::when_raise(const lang::Place& place, std::string_view text) {
  whens_.set_error(*recording_, place, std::string(text));
  return arm();
}

Reply RobotMachine::arm() {
  motion::Effect effect;
  effect.tag = recording_->tag;
  effect.kind = motion::Effect::Kind::Arm;
  effect.watched = recording_;
  const Reply reply = push(effect);
  if (reply != Reply::Done) return reply;
  recording_ = nullptr;
  last_arming_ = effects_;
  watched_since_ = -1;
  return reply;
}

/// Whether every WHEN that is armed has been looked at, and what came of it is known here: one that
/// is armed in a cycle is looked at in the next one, and stands in that or the one after.
bool RobotMachine::watched() {
  if (armed_ == 0) return true;
  if (progress_.effects_done.load(std::memory_order_acquire) < last_arming_) return false;
  const std::int64_t cycle = channels_.cycle.load(std::memory_order_relaxed);
  if (watched_since_ < 0) watched_since_ = cycle;
  return cycle > watched_since_ + 1 && settled();
}

Reply RobotMachine::disarm(int line, int id) {
  if (!decided()) return Reply::Later;
  motion::Effect effect;
  effect.tag = static_cast<motion::Tag>(line);
  effect.kind = motion::Effect::Kind::Disarm;
  effect.watched = &whens_.at(id);
  const Reply reply = push(effect);
  if (reply != Reply::Done) return reply;
  effect.watched->retired.store(true, std::memory_order_relaxed);
  --armed_;
  return reply;
}

Reply RobotMachine::on_the_way(int /*line*/, const lang::PathPlace& place) {
  place_ = place;
  return Reply::Done;
}

bool RobotMachine::lay_events(Commanded& commanded) {
  motion::SegmentDescriptor& segment = commanded.segment;
  const double way = commanded.way;
  segment.on_the_way.clear();
  for (const OnTheWay& one : commanded.events) {
    const double distance = one.place.distance;
    const double place = one.place.before ? way - distance : distance;
    if (!(way > 0) || place < -motion::kLimitTolerance || place > way + motion::kLimitTolerance) {
      refuse(words_at(one.place.written, words_for_place(distance, way)));
      return false;
    }
    if (segment.on_the_way.full()) {
      refuse(words_at(one.place.written, words_for_many_places(segment.on_the_way.kMost)));
      return false;
    }
    motion::PathEvent event{.share = place / way, .lead = one.place.lead, .effect = one.effect};
    if (const motion::ToolPath* const path = commanded.along.get())
      event.share = (path->at_share(event.share) - path->begin()) / (path->end() - path->begin());
    event.effect.after = segment.number;
    segment.on_the_way.push_back(event);
  }
  return true;
}

bool RobotMachine::interrupted() const {
  const motion::Rest* const next = progress_.rests.front();
  return next != nullptr && next->by != nullptr;
}

/// One that a WHEN has caused is left for take_interruption().
bool RobotMachine::take_rest(motion::Rest& rest) {
  return !interrupted() && progress_.rests.take(rest);
}

std::optional<lang::RuntimeError> RobotMachine::take_interruption() {
  const motion::Rest* const rest = progress_.rests.front();
  if (rest == nullptr || !rest->failure()) return std::nullopt;
  lang::RuntimeError error = rest->by == &stopping_ ? stopped() : whens_.error_of(*rest);
  restart_from(rest->q);
  buffer_.braked();
  begun_ = standing_ = guarded_ = braking_ = consulting_ = false;
  brakable_ = 0;
  recording_ = nullptr;
  place_.reset();
  on_the_way_.clear();
  via_.clear();
  live_.reset();
  progress_.rests.pop();
  return error;
}

}  // namespace rob::runtime
