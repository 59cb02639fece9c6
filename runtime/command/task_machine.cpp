#include "runtime/command/task_machine.h"

#include <utility>

#include "motion/space/cycle_instant.h"
#include "runtime/command/signal_access.h"

namespace rob::runtime {

using lang::Reply;
using motion::Effect;

TaskMachine::TaskMachine(const TaskSide& side, lang::TaskMemory* memory)
    : side_(side),
      channels_(side.links.channels),
      memory_(memory),
      refuse_([this](Words why) { return refuse(std::move(why)); }) {}

double TaskMachine::now() const {
  return motion::cycle_instant(channels_.cycle.load(std::memory_order_relaxed),
                               side_.links.robot.reference_period);
}

Reply TaskMachine::wait(int /*line*/, double seconds) {
  if (!waiting_since_) waiting_since_ = now();
  if (now() < *waiting_since_ + seconds - motion::kSameInstant) return Reply::Later;
  waiting_since_.reset();
  return Reply::Done;
}

Reply TaskMachine::stand(int /*line*/, double& time) {
  time = now();
  return Reply::Done;
}

Reply TaskMachine::settle(int /*line*/) {
  waiting_since_.reset();
  return Reply::Done;
}

/// The ring is emptied at the beginning of every cycle.
Reply TaskMachine::give(const Effect& effect) {
  if (!channels_.immediate.push(effect)) return Reply::Later;
  side_.links.log.queued_effect();
  return Reply::Done;
}

Reply TaskMachine::print(int line, std::string_view text) {
  if (channels_.immediate.full()) return Reply::Later;
  return give({.tag = static_cast<motion::Tag>(line),
               .kind = Effect::Kind::Note,
               .id = side_.links.log.keep({Note::Kind::Print, std::string(text)})});
}

Reply TaskMachine::write(int line, std::string_view file, std::string_view text) {
  if (channels_.immediate.full()) return Reply::Later;
  if (auto why = objection_to_line(side_.files.files(), file, text)) return refuse(std::move(*why));
  Note note{Note::Kind::Write, std::string(text)};
  note.file = file;
  return give({.tag = static_cast<motion::Tag>(line),
               .kind = Effect::Kind::Note,
               .id = side_.links.log.keep(std::move(note))});
}

Reply TaskMachine::persist(int line, std::size_t variable, std::string_view value) {
  if (channels_.immediate.full()) return Reply::Later;
  return give({.tag = static_cast<motion::Tag>(line),
               .kind = Effect::Kind::Note,
               .id = side_.links.log.keep(note_of(variable, value))});
}

Reply TaskMachine::send(int line, std::size_t device, std::string_view text) {
  TextDevices* const devices = side_.devices.devices();
  if (devices == nullptr) return refuse(no_devices());
  if (channels_.immediate.full()) return Reply::Later;
  if (auto why = devices->objection(device)) return refuse(std::move(*why));
  devices->sending(device);
  return give({.tag = static_cast<motion::Tag>(line),
               .kind = Effect::Kind::Note,
               .id = side_.links.log.keep(note_for(Note::Kind::Send, device, text))});
}

/// It looks in every cycle, from when all is sent that was to be sent before.
Reply TaskMachine::receive(int /*line*/, std::size_t device, double timeout, std::string& text,
                           bool& came) {
  TextDevices* const devices = side_.devices.devices();
  if (devices == nullptr) return refuse(no_devices());
  if (devices->sends_pending(device)) return Reply::Later;
  if (!waiting_since_) waiting_since_ = now();
  std::optional<std::string> heard = devices->take(device, now());
  came = heard.has_value();
  auto why = came ? std::nullopt : devices->objection(device);
  const bool late = now() >= *waiting_since_ + timeout - motion::kSameInstant;
  if (!came && !why && !late) return Reply::Later;
  waiting_since_.reset();
  if (came) text = std::move(*heard);
  return why ? refuse(std::move(*why)) : Reply::Done;
}

Reply TaskMachine::exists(int /*line*/, std::string_view file, bool& value) {
  value = side_.files.files() != nullptr && side_.files.files()->exists(std::string(file));
  return Reply::Done;
}

Reply TaskMachine::write_signal(int line, int signal, bool value) {
  Effect effect = effect_on(side_.links.signal(signal), line);
  effect.kind = Effect::Kind::Output;
  effect.value = value;
  return give(effect);
}

Reply TaskMachine::write_analog(int line, int signal, double volts) {
  Effect effect = effect_on(side_.links.signal(signal), line);
  effect.kind = Effect::Kind::Analog;
  effect.volts = volts;
  return give(effect);
}

Reply TaskMachine::pulse(int line, int signal, double seconds) {
  Effect effect = effect_on(side_.links.signal(signal), line);
  effect.kind = Effect::Kind::Pulse;
  effect.seconds = seconds;
  return give(effect);
}

Reply TaskMachine::read_signal(int line, int signal, bool& value) {
  value = digital_value(channels_, side_.links.signal(signal));
  side_.assumptions.note_read(line, signal);
  return Reply::Done;
}

Reply TaskMachine::read_group(int line, int signal, int count, std::int64_t& value) {
  value = group_value(channels_, side_.links.signal(signal), count);
  for (int i = 0; i < count; ++i) side_.assumptions.note_read(line, signal + i);
  return Reply::Done;
}

Reply TaskMachine::read_analog(int line, int signal, double& volts) {
  volts = analog_value(channels_, side_.links.signal(signal));
  side_.assumptions.note_read(line, signal);
  return Reply::Done;
}

Reply TaskMachine::read(int /*line*/, lang::Reading what, lang::Slot* value) {
  return side_.readings.current(what, outside_, value, refuse_);
}

Reply TaskMachine::forward(int /*line*/, std::span<const double> joints, lang::PoseValue& pose) {
  pose = side_.readings.forward(outside_, joints);
  return Reply::Done;
}

Reply TaskMachine::inverse(int /*line*/, const lang::PoseValue& pose, std::span<const double> near,
                           std::span<double> joints) {
  return side_.readings.inverse(outside_, pose, near, joints, refuse_);
}

Reply TaskMachine::publish(int /*line*/, std::size_t first, std::span<const lang::Slot> values) {
  memory_->store(first, values);
  return Reply::Done;
}

Reply TaskMachine::publish(int /*line*/, std::size_t first, std::span<const std::string> texts) {
  memory_->store(first, texts);
  return Reply::Done;
}

Reply TaskMachine::publish_list(int /*line*/, std::size_t home, const lang::ListContent& list) {
  memory_->store_list(home, list);
  return Reply::Done;
}

Reply TaskMachine::refresh(int /*line*/, std::size_t first, std::span<lang::Slot> values) {
  memory_->load(first, values);
  return Reply::Done;
}

Reply TaskMachine::refresh(int /*line*/, std::size_t first, std::span<std::string> texts) {
  memory_->load(first, texts);
  return Reply::Done;
}

Reply TaskMachine::leave_handler(int /*line*/) {
  side_.turns.end_call();
  return Reply::Done;
}

}  // namespace rob::runtime
