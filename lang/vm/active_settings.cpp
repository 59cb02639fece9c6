#include "lang/vm/active_settings.h"

namespace rob::lang {

void ActiveSettings::enter(Machine& machine, int line, const Setting& setting) {
  settings_.push_back(setting);
  machine.work_in(line, setting);
}

void ActiveSettings::leave(Machine& machine, int line, std::size_t kept) {
  if (settings_.size() == kept) return;
  drop(kept);
  machine.work_in(line, setting());
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
