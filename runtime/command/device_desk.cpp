#include "runtime/command/device_desk.h"

#include <utility>

#include "lang/text/codes.h"
#include "motion/space/cycle_instant.h"

namespace rob::runtime {

using lang::Reply;

namespace {

constexpr double kSameTime = 1e-9;  // s

}  // namespace

Words no_devices() {
  return {std::string(lang::code::kMachineWithout), "there are no devices here",
          "run the program with rob run"};
}

Note note_for(Note::Kind kind, std::size_t device, std::string_view text) {
  Note note{kind, std::string(text)};
  note.variable = device;
  return note;
}

double DeviceDesk::now() const {
  return motion::cycle_instant(links_.channels.cycle.load(std::memory_order_relaxed),
                               links_.robot.reference_period);
}

Reply DeviceDesk::send(int line, std::size_t device, std::string_view text) {
  if (devices_ == nullptr) return links_.refuse(no_devices());
  if (effects_.full()) return Reply::Later;
  if (auto why = devices_->objection(device)) return links_.refuse(std::move(*why));
  const Reply reply = effects_.note(line, note_for(Note::Kind::Send, device, text));
  if (reply == Reply::Done) devices_->sending(device);
  return reply;
}

Reply DeviceDesk::simulate(int line, std::size_t device, std::string_view text, double after) {
  if (devices_ == nullptr) return links_.refuse(no_devices());
  if (effects_.full()) return Reply::Later;
  Note note = note_for(Note::Kind::Line, device, text);
  note.after = after;
  return effects_.note(line, std::move(note));
}

/// A line that comes before what is sent to the device is none for it: there is no look until that
/// is sent. A program that is only foretold hears an empty line, where no other will come.
std::optional<std::string> DeviceDesk::look(int line, std::size_t device) {
  if (devices_->sends_pending(device)) return std::nullopt;
  if (!first_look_) first_look_ = now();
  auto text = devices_->take(device, now());
  if (text || !assumptions_.foretelling() || devices_->any_left(device)) return text;
  assumptions_.note_line(line);
  return "";
}

/// At the decision point a line that is there keeps the blend. Any other is waited for at rest,
/// which must be commanded in that very cycle.
Reply DeviceDesk::receive(int line, std::size_t device, double timeout, std::string& text,
                          bool& came) {
  if (devices_ == nullptr) return links_.refuse(no_devices());
  if (!standing_) {
    if (!progress_.observable()) return Reply::Later;
    if (auto heard_text = look(line, device)) {
      text = std::move(*heard_text);
      came = true;
      drop();
      return Reply::Done;
    }
    standing_ = true;
  }
  double ignored = 0;
  if (waits_.stand(line, ignored) != Reply::Done || !progress_.settled()) return Reply::Later;
  if (links_.buffer.full() || effects_.full()) return Reply::Later;
  auto heard_text = look(line, device);
  came = heard_text.has_value();
  auto why = came ? std::nullopt : devices_->objection(device);
  const bool late = first_look_ && now() - *first_look_ >= timeout - kSameTime;
  if (!came && !why && !late) return Reply::Later;
  if (came) text = std::move(*heard_text);
  drop();
  waits_.waited(line);
  return why ? links_.refuse(std::move(*why)) : Reply::Done;
}

}  // namespace rob::runtime
