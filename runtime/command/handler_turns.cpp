#include "runtime/command/handler_turns.h"

#include <utility>

namespace rob::runtime {

using lang::Reply;
using motion::Rest;

std::optional<HandlerTurns::Begun> HandlerTurns::begin() {
  const Rest* const rest = links_.progress.rests.front();
  if (rest == nullptr || rest->outcome != Rest::Outcome::Handled) return std::nullopt;
  if (rest->by->retired.load(std::memory_order_relaxed)) {
    decline();
    return std::nullopt;
  }
  const bool stops = rest->by->kind == motion::WatchedAction::Kind::Handle;
  const Begun begun{whens_.id_of(*rest->by), stops, rest->q};
  turn_ = stops ? Turn::HasAxes : Turn::LetsThemGoOn;
  rest->by->fired.store(false, std::memory_order_relaxed);
  links_.progress.rests.pop();
  return begun;
}

void HandlerTurns::end_call() {
  if (turn_ != Turn::LetsThemGoOn) return;
  turn_ = Turn::None;
  links_.channels.after_handler.store(AfterHandler::GoOn);
}

/// A Rest that has been reported and not taken comes back when handlers may begin again.
void HandlerTurns::bar(bool barred) {
  links_.channels.handlers_barred.store(barred);
  if (barred) end_call();
  const Rest* const rest = links_.progress.rests.front();
  if (!barred || rest == nullptr || rest->outcome != Rest::Outcome::Handled) return;
  decline();
}

void HandlerTurns::decline() {
  links_.progress.rests.pop();
  links_.channels.after_handler.store(AfterHandler::Decline);
}

/// Effects between the motions go with the motions' numbers. All of it is planned before any is
/// queued.
Reply HandlerTurns::leave_path(const Refuse& refuse) {
  Rest rest;
  if (!progress_.take_rest(rest)) return Reply::Later;
  std::deque<Commanded> after = queue_.take_after(rest.number);
  links_.planner.stand_at(rest.q, rest.number);
  progress_.stand();
  const lang::Setting setting = surroundings_.setting();
  auto words = commands_.plan_anew(after);
  commands_.work_in(setting);
  loads_.plan_with_last();
  if (words) {
    queue_.forget_path();
    links_.planner.stand_at(rest.q, rest.number);
    queue_.restart_from(rest.q);
    return refuse(std::move(*words));
  }
  turn_ = Turn::None;
  if (after.empty() && guard_.on()) guard_.leave(rest);
  queue_.add_again(std::move(after));
  return Reply::Done;
}

bool HandlerTurns::leave_all() {
  Rest rest;
  if (!progress_.take_rest(rest)) return false;
  turn_ = Turn::None;
  queue_.restart_from(rest.q);
  guard_.forget_left();
  return true;
}

}  // namespace rob::runtime
