#include "runtime/command/when_pool.h"

#include <algorithm>
#include <utility>

#include "lang/text/codes.h"
#include "motion/generate/watch_list.h"
#include "runtime/words/messages.h"

namespace rob::runtime {

namespace {

/// Those armed, and those whose block the program has left while the motion has not.
constexpr std::size_t kMostPlaces = 4 * motion::WatchList::kMost;

bool free(const motion::WatchedAction& action) {
  return !action.armed.load(std::memory_order_acquire) &&
         !action.fired.load(std::memory_order_relaxed);
}

}  // namespace

motion::WatchedAction* WhenPool::set_up(int line, const lang::Watch& condition, int& id) {
  auto place = std::ranges::find_if(places_, [](const Place& one) { return free(one.action); });
  if (place == places_.end()) {
    if (places_.size() == kMostPlaces) return nullptr;
    places_.emplace_back(signals_, robot_);
    place = std::prev(places_.end());
  }
  id = static_cast<int>(place - places_.begin());
  place->watch.set(condition);
  place->action.condition = place->watch.handle();
  place->action.kind = motion::WatchedAction::Kind::Act;
  place->action.tag = static_cast<motion::Tag>(line);
  place->action.retired.store(false, std::memory_order_relaxed);
  place->action.armed.store(true, std::memory_order_relaxed);
  return &place->action;
}

motion::WatchedAction* WhenPool::first_in_use() {
  const auto place = std::ranges::find_if(places_, [](const Place& one) {
    return one.action.armed.load(std::memory_order_acquire) &&
           !one.action.retired.load(std::memory_order_relaxed);
  });
  return place == places_.end() ? nullptr : &place->action;
}

int WhenPool::id_of(const motion::WatchedAction& action) const {
  const auto place =
      std::ranges::find_if(places_, [&](const Place& one) { return &one.action == &action; });
  return static_cast<int>(place - places_.begin());
}

void WhenPool::set_error(motion::WatchedAction& action, const lang::Place& written,
                         std::string text) {
  action.kind = motion::WatchedAction::Kind::Raise;
  place_of(action).text = std::move(text);
  place_of(action).written = written;
}

lang::RuntimeError WhenPool::error_of(const motion::Rest& rest) {
  const Place& place = place_of(*rest.by);
  lang::RuntimeError error;
  if (rest.outcome == motion::Rest::Outcome::Failed) {
    const Words words = words_for_condition(place.watch.error());
    error.place = place.watch.written();
    error.code = words.code;
    error.message = words.message;
    error.help = words.help;
  } else {
    error.place = place.written;
    error.code = lang::code::kRaised;
    error.message = place.text;
  }
  rest.by->fired.store(false, std::memory_order_relaxed);
  return error;
}

WhenPool::Place& WhenPool::place_of(const motion::WatchedAction& action) {
  return *std::ranges::find_if(places_, [&](const Place& one) { return &one.action == &action; });
}

}  // namespace rob::runtime
