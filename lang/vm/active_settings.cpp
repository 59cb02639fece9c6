#include "lang/vm/active_settings.h"

#include <algorithm>

namespace rob::lang {

void ActiveSettings::enter(Machine& machine, int line, const Setting& setting) {
  settings_.push_back({setting, defaults(), true});
  machine.work_in(line, setting);
}

void ActiveSettings::enter(MoveCommand clauses) {
  take_defaults(defaults(), clauses);
  settings_.push_back({setting(), clauses, false});
}

void ActiveSettings::enter_as_of(Machine& machine, int line, std::size_t open) {
  settings_.push_back(around(open));
  settings_.back().told = true;
  machine.work_in(line, setting());
}

void ActiveSettings::leave(Machine& machine, int line, std::size_t kept) {
  const bool told = std::any_of(settings_.begin() + static_cast<std::ptrdiff_t>(kept),
                                settings_.end(), [](const Around& one) { return one.told; });
  drop(kept);
  if (told) machine.work_in(line, setting());
}

Reply ActiveSettings::press(Machine& machine, int line, const PressCommand& command) {
  const Reply reply = machine.press(line, command);
  if (reply == Reply::Done) ++presses_;
  return reply;
}

Reply ActiveSettings::end_presses(Machine& machine, int line, std::size_t kept) {
  while (presses_ > kept) {
    const Reply reply = machine.end_press(line);
    if (reply == Reply::Later) return reply;
    --presses_;
    if (reply == Reply::Refused) return reply;
  }
  return Reply::Done;
}

}  // namespace rob::lang
