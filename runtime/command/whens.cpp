#include "runtime/command/whens.h"

#include <string>

namespace rob::runtime {

using lang::Reply;

Reply Whens::begin(int line, const lang::Watch& condition, int& id) {
  motion::WatchedAction* const action = pool_.set_up(line, condition, id);
  if (action == nullptr) return Reply::Later;
  making_ = action;
  ++armed_;
  return Reply::Done;
}

Reply Whens::act(const motion::Effect& effect) {
  making_->effect = effect;
  return arm();
}

Reply Whens::raise(const lang::Place& place, std::string_view text) {
  pool_.set_error(*making_, place, std::string(text));
  return arm();
}

Reply Whens::handle(bool stops) {
  using Kind = motion::WatchedAction::Kind;
  making_->kind = stops ? Kind::Handle : Kind::Call;
  return arm();
}

Reply Whens::arm() {
  motion::Effect effect;
  effect.tag = making_->tag;
  effect.kind = motion::Effect::Kind::Arm;
  effect.watched = making_;
  const Reply reply = effects_.push(effect);
  if (reply != Reply::Done) return reply;
  making_ = nullptr;
  last_arming_ = effects_.pushed();
  watched_since_ = -1;
  return reply;
}

Reply Whens::disarm(int line, int id) {
  return progress_.decided() ? disarm(line, pool_.at(id)) : Reply::Later;
}

Reply Whens::disarm(int line, motion::WatchedAction& action) {
  motion::Effect effect;
  effect.tag = static_cast<motion::Tag>(line);
  effect.kind = motion::Effect::Kind::Disarm;
  effect.watched = &action;
  const Reply reply = effects_.push(effect);
  if (reply != Reply::Done) return reply;
  action.retired.store(true, std::memory_order_relaxed);
  --armed_;
  return reply;
}

bool Whens::disarm_all(int line) {
  while (motion::WatchedAction* const armed = pool_.first_in_use()) {
    if (disarm(line, *armed) != Reply::Done) return false;
  }
  return true;
}

/// One that is armed in a cycle is looked at in the next one, and stands in that or the one after.
bool Whens::watched() {
  if (armed_ == 0) return true;
  if (links_.progress.effects_done.load(std::memory_order_acquire) < last_arming_) return false;
  const std::int64_t cycle = links_.channels.cycle.load(std::memory_order_relaxed);
  if (watched_since_ < 0) watched_since_ = cycle;
  return cycle > watched_since_ + 1 && progress_.settled();
}

}  // namespace rob::runtime
