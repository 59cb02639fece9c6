#include "runtime/command/robot_machine.h"

#include <algorithm>
#include <string>

#include "motion/space/cycle_instant.h"
#include "runtime/command/background_tasks.h"
#include "runtime/command/signal_access.h"
#include "runtime/words/codes.h"
#include "runtime/words/messages.h"
#include "runtime/words/signature.h"

namespace rob::runtime {

using lang::Reply;

RobotMachine::RobotMachine(const motion::RobotModel& robot, motion::MotionPlanner& planner,
                           motion::LookAheadBuffer& buffer, Channels& channels,
                           MotionProgress& progress, ProgramLog& log)
    : robot_(robot),
      signature_(signature_of(robot)),
      signals_(signature_.signals),
      planner_(planner),
      buffer_(buffer),
      channels_(channels),
      progress_(progress),
      log_(log),
      settling_(robot, log),
      until_(signals_, robot),
      whens_(signals_, robot) {}

Reply RobotMachine::stop(int line) {
  if (buffer_.full() || !rested()) return Reply::Later;
  if (const auto segment = settled_stop(line)) queue(*segment, true);
  brakable_ = 0;
  return Reply::Done;
}

Reply RobotMachine::make_exact(int line) {
  if (buffer_.full() || !rested()) return Reply::Later;
  const auto segment = planner_.stop(static_cast<motion::Tag>(line));
  if (segment) queue(*segment, true);
  brakable_ = 0;
  return Reply::Done;
}

std::optional<motion::SegmentDescriptor> RobotMachine::settled_stop(int line) {
  const auto tag = static_cast<motion::Tag>(line);
  auto segment = planner_.stop(tag);
  if (!segment && !settling_.settled()) segment = planner_.dwell(tag, 0);
  if (segment) settling_.ask(*segment, settling_.window(0, planner_.tool_tip()));
  return segment;
}

/// What STOP, WAIT or UNTIL has brought to rest is not braked: that it be reached was promised.
/// Of a handler it is the interrupted motion that ends.
Reply RobotMachine::brake(int /*line*/) {
  if (errand_) {
    errand_->returns = false;
    return Reply::Done;
  }
  if (brakable_ == 0) return Reply::Done;
  if (!braking_) {
    if (stands()) return settled() ? Reply::Done : Reply::Later;
    buffer_.brake(brakable_);
    braking_ = true;
  }
  motion::Rest rest;
  do {
    if (!take_rest(rest)) return Reply::Later;
  } while (!rest.early());  // a jog has told that it has come to rest before
  restart_from(rest.q);
  braking_ = false;
  brakable_ = 0;
  return Reply::Done;
}

Reply RobotMachine::wait(int line, double seconds) {
  if (!(seconds <= motion::MotionPlanner::kLongest)) {
    refuse(words_for_long_wait(seconds));
    return Reply::Refused;
  }
  if (seconds == 0) return stop(line);
  const Reply reply = dwell(line, seconds);
  if (reply == Reply::Done) begun_ = false;
  return reply;
}

Reply RobotMachine::dwell(int line, double seconds) {
  const auto tag = static_cast<motion::Tag>(line);
  if (buffer_.full() || !rested()) return Reply::Later;
  brakable_ = 0;
  if (const auto segment = settled_stop(line)) {
    queue(*segment, true);
    begun_ = true;
    if (buffer_.full()) return Reply::Later;
  }
  queue(planner_.dwell(tag, seconds), true, begun_);
  begun_ = true;
  return Reply::Done;
}

/// A dwell of no length marks in the buffer where the waiting begins, and another where it ends:
/// so the time between belongs to the line that waits. No mark is waited for.
Reply RobotMachine::stand(int line, double& now) {
  if (!standing_) {
    const Reply reply = dwell(line, 0);
    if (reply != Reply::Done) return reply;
    standing_ = true;
  }
  if (!has_acted()) return Reply::Later;
  const std::int64_t cycle = channels_.cycle.load(std::memory_order_relaxed);
  assumed_read_ = -1;
  now = motion::cycle_instant(cycle, robot_.reference_period);
  return Reply::Done;
}

Reply RobotMachine::waited(int line) {
  taken_as_met(line);  // also where what is assumed has met it
  const Reply reply = dwell(line, 0);
  if (reply == Reply::Done) begun_ = standing_ = false;
  return reply;
}

Reply RobotMachine::leave_block(int /*line*/) { return decided() ? Reply::Done : Reply::Later; }

Reply RobotMachine::settle(int line) {
  bar_handlers(true);
  if (handler_ == Handler::HasAxes) {
    if (const Reply reply = drop_interrupted(line); reply != Reply::Done) return reply;
  }
  if (path_ && path_->closed && end_path(line) != Reply::Done) return Reply::Later;
  drop_path();
  begun_ = standing_ = guarded_ = consulting_ = false;
  recording_ = nullptr;
  place_.reset();
  on_the_way_.clear();
  via_.clear();
  live_.reset();
  const Reply reply = make_exact(line);
  if (reply != Reply::Done) return reply;
  if (!settled() || give_up_press() == Reply::Later) return Reply::Later;
  forget_rests();
  bar_handlers(false);
  return Reply::Done;
}

/// An error that came from a TASK may have found a motion that was guarded or braked.
void RobotMachine::forget_rests() {
  motion::Rest rest;
  while (take_rest(rest)) {
    if (!rest.early()) continue;
    restart_from(rest.q);
  }
  braking_ = false;
}

std::uint32_t RobotMachine::awaited() const { return std::min(awaited_, planner_.last_number()); }

bool RobotMachine::stands() const {
  return progress_.settled.load(std::memory_order_acquire) >= awaited();
}

bool RobotMachine::has_acted() const {
  return stands() && progress_.effects_done.load(std::memory_order_acquire) >= effects_;
}

bool RobotMachine::settled() const { return has_acted() && !interrupted(); }

/// A PATH is open only where a loop in it has been given up.
Reply RobotMachine::end(int line) {
  if (path_ && end_path(line) == Reply::Later) return Reply::Later;
  if (stays_) {
    channels_.hold_points.end_with(planner_.last_number());  // what stops it there is no line's
    return disarm_all(line) ? settle(line) : Reply::Later;
  }
  const Reply reply = stop(line);
  if (reply != Reply::Done) return reply;
  if (!watched()) return Reply::Later;  // a WHEN may still have something to say
  buffer_.close();
  bar_handlers(true);
  return Reply::Done;
}

Reply RobotMachine::print(int line, std::string_view text) {
  return note(line, {Note::Kind::Print, std::string(text)});
}

Reply RobotMachine::note(int line, Note note) {
  if (buffer_.effects_full()) return Reply::Later;
  motion::Effect effect;
  effect.tag = static_cast<motion::Tag>(line);
  effect.kind = motion::Effect::Kind::Note;
  effect.id = log_.keep(std::move(note));
  return queue(effect);
}

motion::Effect RobotMachine::effect_on(int line, int signal) const {
  return runtime::effect_on(this->signal(signal), line);
}

Reply RobotMachine::write_signal(int line, int signal, bool value) {
  motion::Effect effect = effect_on(line, signal);
  effect.kind = motion::Effect::Kind::Output;
  effect.value = value;
  return queue(effect);
}

Reply RobotMachine::write_analog(int line, int signal, double volts) {
  motion::Effect effect = effect_on(line, signal);
  effect.kind = motion::Effect::Kind::Analog;
  effect.volts = volts;
  return queue(effect);
}

Reply RobotMachine::pulse(int line, int signal, double seconds) {
  motion::Effect effect = effect_on(line, signal);
  effect.kind = motion::Effect::Kind::Pulse;
  effect.seconds = seconds;
  return queue(effect);
}

bool RobotMachine::observable() const {
  if (!decided()) return false;
  // At standstill what was written before acts first; in a corner it acts after the decision
  // point.
  const bool stands = exact_ || progress_.standing.load(std::memory_order_relaxed);
  return !stands || progress_.effects_done.load(std::memory_order_acquire) >= effects_;
}

Reply RobotMachine::read_signal(int line, int signal, bool& value) {
  if (!observable()) return Reply::Later;
  value = digital_value(channels_, this->signal(signal));
  if (!assumed_.empty()) note_assumed(line, signal);
  return Reply::Done;
}

/// Program and motion share the numbers of segments: a decision point has come once the generator
/// names it.
bool RobotMachine::decided() const {
  return progress_.decidable.load(std::memory_order_acquire) >= awaited() && !interrupted();
}

Reply RobotMachine::read_analog(int line, int signal, double& volts) {
  if (!observable()) return Reply::Later;
  volts = analog_value(channels_, this->signal(signal));
  if (!assumed_.empty()) note_assumed(line, signal);
  return Reply::Done;
}

void RobotMachine::queue(motion::SegmentDescriptor segment, bool stop, bool further) {
  queue(Commanded{segment, stop, further});
}

void RobotMachine::queue(Commanded commanded) {
  motion::SegmentDescriptor& segment = commanded.segment;
  if (guarded_) segment.guard = held_.present() ? held_ : until_.handle();
  follow(segment);
  if (!collecting()) return send(std::move(commanded));
  path_->motions.push_back(std::move(commanded));
}

void RobotMachine::follow(const motion::SegmentDescriptor& segment) {
  exact_ = segment.ends_at_rest();
  jogging_ = segment.jog->present();
  settling_.follow(segment);
  const bool mark = segment.dwell && segment.duration == 0 && !segment.settle.present();
  if (!mark) awaited_ = segment.number;
}

void RobotMachine::send(Commanded commanded) {
  const motion::SegmentDescriptor& segment = commanded.segment;
  LoggedSegment logged{segment, commanded.stop, commanded.further, planner_.tool_tip(),
                       commanded.leg};
  if (errand_) logged.number += kHandlerNumbers;
  log_.planned(logged);  // before the generator can report it
  sent_ = segment.number;
  planner_.sends(segment);
  buffer_.push(segment);  // there is room: only this thread fills the buffer
  remember(std::move(commanded));
}

Reply RobotMachine::queue(motion::Effect effect) {
  if (place_) {
    on_the_way_.push_back({*place_, effect});
    place_.reset();
    return Reply::Done;
  }
  if (recording_ != nullptr) {
    recording_->effect = effect;
    return arm();
  }
  const Reply reply = push(effect);
  if (reply == Reply::Done) log_.queued_effect();
  return reply;
}

Reply RobotMachine::push(motion::Effect effect) {
  effect.after = planner_.last_number();
  effect.generation = planner_.generation();
  if (!buffer_.push(effect)) return Reply::Later;
  ++effects_;
  return Reply::Done;
}

}  // namespace rob::runtime
