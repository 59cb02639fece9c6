#include <algorithm>
#include <string>

#include <fmt/core.h>

#include "lang/text/codes.h"
#include "lang/vm/vm.h"

/// Member functions of Vm for TRY: where the program goes on after an error.
namespace rob::lang {

bool Vm::open_try(Code pc) {
  if (guards_.size() == kMostTries) return false;
  const Code jump = pc + 1;
  guards_.push_back({.rescue = jump + 1 + jump->distance(),
                     .depth = depth(),
                     .why = pc->a(),
                     .caught = false,
                     .armed = armed_count_,
                     .settings = settings_.size(),
                     .presses = presses_});
  return true;
}

Vm::State Vm::give_up(Code pc) {
  const auto catches = [](const Guard& guard) { return !guard.caught; };
  rescuing_ = std::ranges::any_of(guards_, catches);
  if (handling_) {
    const auto handlers = guards_.begin() + static_cast<std::ptrdiff_t>(interrupted_.guards);
    if (std::none_of(handlers, guards_.end(), catches)) abandon_handler();
  }
  return leave(pc, pc, rescuing_ ? State::Running : State::Failed);
}

/// Where it went wrong, and through which calls, stays what it was.
Vm::State Vm::raise_again(Code pc) {
  const auto innermost = std::find_if(guards_.rbegin(), guards_.rend(),
                                      [](const Guard& guard) { return guard.caught; });
  error_ = innermost->error;
  return give_up(pc);
}

bool Vm::rescue() {
  if (machine_->settle(line_tag(error_.place)) != Reply::Done) return false;
  while (guards_.back().caught) guards_.pop_back();
  Guard& guard = guards_.back();
  const int line = line_tag(error_.place);
  if (disarm(line, guard.armed) != Reply::Done) return false;
  if (end_presses(line, guard.presses) != Reply::Done) return false;
  leave_settings(line, guard.settings);
  rescuing_ = false;
  guard.caught = true;
  while (depth() > guard.depth) leave_routine();
  // What the program raised itself is its own text; the rest can be told apart by the code.
  texts_[guard.why] = error_.code == code::kRaised
                          ? error_.message
                          : fmt::format("{}: {}", error_.code, error_.message);
  guard.error = error_;
  next_ = guard.rescue;
  return true;
}

Vm::State Vm::fail_tries_too_deep(Code pc) {
  return fail(pc,
              {.code = std::string(code::kTriesTooDeep),
               .place = place(pc),
               .message = fmt::format("the TRY blocks are nested too deep: at most {}", kMostTries),
               .help = "a routine that calls itself needs a way that does not"});
}

}  // namespace rob::lang
