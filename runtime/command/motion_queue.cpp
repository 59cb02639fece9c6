#include "runtime/command/motion_queue.h"

#include <utility>

namespace rob::runtime {

using lang::Reply;

/// An exact target takes two segments, which are queued together.
void MotionQueue::add_motion(int line, Commanded commanded) {
  if (!commanded.move->exact()) return add_brakable(std::move(commanded));
  const motion::SettleWindow window =
      settling_.window(commanded.move->fine_within, links_.planner.tool_tip());
  if (commanded.segment.ends_at_rest()) settling_.ask(commanded.segment, window);
  add_brakable(std::move(commanded));
  if (auto exact = links_.planner.stop(static_cast<motion::Tag>(line))) {
    settling_.ask(*exact, window);
    add(*exact, true, true);
  }
}

void MotionQueue::add_brakable(Commanded commanded) {
  brakable_ = commanded.segment.number;
  add(std::move(commanded));
}

void MotionQueue::add(Commanded commanded) {
  guard_.put_on(commanded.segment);
  follow(commanded.segment);
  if (!collecting()) return send(std::move(commanded));
  path_->motions.push_back(std::move(commanded));
}

void MotionQueue::follow(const motion::SegmentDescriptor& segment) {
  progress_.follow(segment);
  settling_.follow(segment);
}

void MotionQueue::send(Commanded commanded) {
  const motion::SegmentDescriptor& segment = commanded.segment;
  LoggedSegment logged{
      segment,       commanded.stop,     commanded.further,  links_.planner.tool_tip(),
      commanded.leg, commanded.known_by, commanded.clearance};
  if (links_.of_handlers()) logged.number += kHandlerNumbers;
  links_.log.planned(logged);  // before the generator can report it
  sent_ = segment.number;
  links_.planner.sends(segment);
  links_.buffer.push(segment);  // there is room: only this thread fills the buffer
  remember(std::move(commanded));
}

void MotionQueue::remember(Commanded commanded) {
  if (!keeps_commanded_) return;
  commanded_.push_back(std::move(commanded));
  // The one that runs, and those of the buffer.
  if (commanded_.size() > static_cast<std::size_t>(motion::most_ahead(links_.robot)) + 2)
    commanded_.pop_front();
}

Reply MotionQueue::stop(int line) {
  if (full() || !rested()) return Reply::Later;
  if (const auto segment = settled_stop(line)) add(*segment, true);
  brakable_ = 0;
  return Reply::Done;
}

Reply MotionQueue::make_exact(int line) {
  if (full() || !rested()) return Reply::Later;
  if (const auto segment = links_.planner.stop(static_cast<motion::Tag>(line))) add(*segment, true);
  brakable_ = 0;
  return Reply::Done;
}

std::optional<motion::SegmentDescriptor> MotionQueue::settled_stop(int line) {
  const auto tag = static_cast<motion::Tag>(line);
  auto segment = links_.planner.stop(tag);
  if (!segment && !settling_.settled()) segment = links_.planner.dwell(tag, 0);
  if (segment) settling_.ask(*segment, settling_.window(0, links_.planner.tool_tip()));
  return segment;
}

Reply MotionQueue::dwell(int line, double seconds) {
  if (full() || !rested()) return Reply::Later;
  brakable_ = 0;
  if (const auto segment = settled_stop(line)) {
    add(*segment, true);
    begun_ = true;
    if (full()) return Reply::Later;
  }
  add(links_.planner.dwell(static_cast<motion::Tag>(line), seconds), true, begun_);
  begun_ = true;
  return Reply::Done;
}

Reply MotionQueue::dwell_alone(int line, double seconds) {
  const Reply reply = dwell(line, seconds);
  if (reply == Reply::Done) begun_ = false;
  return reply;
}

Reply MotionQueue::brake() {
  if (brakable_ == 0) return Reply::Done;
  if (!braking_) {
    if (progress_.stands()) return progress_.settled() ? Reply::Done : Reply::Later;
    links_.buffer.brake(brakable_);
    braking_ = true;
  }
  motion::Rest rest;
  do {
    if (!progress_.take_rest(rest)) return Reply::Later;
  } while (!rest.early());  // a jog has reported that it has come to rest before
  restart_from(rest.q);
  braking_ = false;
  brakable_ = 0;
  return Reply::Done;
}

/// Jogs that came to rest before the one after them was known have reported so, too.
bool MotionQueue::take_jog_rest(motion::Rest& rest) {
  while (progress_.take_rest(rest)) {
    if (rest.early() || rest.number == links_.planner.last_number()) return true;
  }
  return false;
}

bool MotionQueue::take_end(motion::Rest& rest) {
  return progress_.jogging() ? take_jog_rest(rest) : progress_.take_rest(rest);
}

bool MotionQueue::rested() {
  if (!progress_.jogging()) return true;
  motion::Rest rest;
  if (!take_jog_rest(rest)) return false;
  rest.early() ? restart_from(rest.q) : come_to_rest(rest.q);
  return true;
}

void MotionQueue::come_to_rest(const motion::JointVector& q) {
  links_.planner.stand_at(q, links_.planner.last_number());
  progress_.stand();
}

void MotionQueue::restart_from(const motion::JointVector& q) {
  drop_path();
  links_.planner.retarget(q);
  loads_.doubt_where_told();
  progress_.stand();
  settling_.lose();
}

/// An error that came from a TASK may have found a motion that was guarded or braked.
void MotionQueue::forget_rests() {
  motion::Rest rest;
  while (progress_.take_rest(rest)) {
    if (rest.early()) restart_from(rest.q);
  }
  braking_ = false;
}

void MotionQueue::drop() {
  links_.buffer.braked();
  begun_ = braking_ = false;
  brakable_ = 0;
}

void MotionQueue::open_path() {
  path_.emplace(Path{links_.planner.mark(), progress_.exact(), brakable_, moved_tip_});
}

bool MotionQueue::send_path() {
  while (!path_->motions.empty()) {
    if (full()) return false;
    send(std::move(path_->motions.front()));
    path_->motions.pop_front();
  }
  path_.reset();
  return true;
}

void MotionQueue::drop_path() {
  if (!path_) return;
  if (collecting()) {
    links_.planner.go_back(path_->before);
    progress_.set_exact(path_->exact);
    brakable_ = path_->brakable;
    moved_tip_ = path_->moved_tip;
  } else {
    links_.planner.stand_at(links_.planner.commanded(), sent_);
  }
  next_.drop_events();
  path_.reset();
}

std::deque<Commanded> MotionQueue::take_after(std::uint32_t number) {
  std::deque<Commanded> after = std::exchange(commanded_, {});
  std::erase_if(after, [&](const Commanded& one) { return one.segment.number <= number; });
  return after;
}

void MotionQueue::add_again(std::deque<Commanded> commanded) {
  for (Commanded& one : commanded) {
    follow(one.segment);
    send(std::move(one));
  }
  if (!path_) return;
  path_->exact = progress_.exact();
  for (const Commanded& one : path_->motions) follow(one.segment);
}

}  // namespace rob::runtime
