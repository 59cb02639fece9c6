#include <algorithm>
#include <array>
#include <string>

#include <fmt/core.h>

#include "lang/machine/move_pose.h"
#include "lang/machine/seen_from.h"
#include "lang/text/codes.h"
#include "lang/values/number_text.h"
#include "lang/values/pose_slots.h"
#include "lang/vm/answer.h"
#include "lang/vm/vm.h"

/// Member functions of Vm that call the Machine: to command, to observe and to wait.
namespace rob::lang {

Vm::State Vm::pause(Code pc, Code resume, Reply reply) {
  if (reply == Reply::Later) return leave(pc, resume, State::Waiting);
  const Refusal& refusal = machine_->refusal();
  return fail(pc, {.code = refusal.code,
                   .place = refusal.place.line > 0 ? refusal.place : place(pc),
                   .message = refusal.message,
                   .help = refusal.help});
}

Reply Vm::observe(Code pc) {
  bool value = false;
  const Reply reply = machine_->read_signal(line(pc), pc->x(), value);
  if (reply == Reply::Done) {
    numbers_[pc->a()].integer = value ? 1 : 0;
    observed_ = true;
    turned_ = false;
  }
  return reply;
}

Reply Vm::observe_analog(Code pc) {
  const Reply reply = machine_->read_analog(line(pc), pc->x(), numbers_[pc->a()].real);
  if (reply == Reply::Done) {
    observed_ = true;
    turned_ = false;
  }
  return reply;
}

bool Vm::waits_for_cycle(Code pc) const {
  return is_observation(static_cast<Reading>(pc->b())) && next_cycle_is_due();
}

Reply Vm::read(Code pc) {
  const auto what = static_cast<Reading>(pc->b());
  const Reply reply =
      needs_sensor(what) ? feel(pc) : machine_->read(line(pc), what, &numbers_[pc->a()]);
  if (reply == Reply::Done && is_observation(what)) {
    observed_ = true;
    turned_ = false;
  }
  return reply;
}

/// Force and torque, along the axes of the active frame.
Reply Vm::feel(Code pc) {
  const auto what = static_cast<Reading>(pc->b());
  const Setting active = setting();
  std::array<Slot, kPoseSlots> tool{};
  Slot* const felt = &numbers_[pc->a()];
  Reply reply = Reply::Done;
  if (active.in_tool) reply = machine_->read(line(pc), Reading::Here, tool.data());
  if (reply == Reply::Done) reply = machine_->read(line(pc), what, felt);
  if (reply == Reply::Done) turn_into_frame(what, active, load_pose(tool.data()), felt);
  return reply;
}

Reply Vm::stand(Code pc) {
  turns_.erase(index(pc));  // a WAIT that looks again is no loop
  const Reply reply = machine_->stand(line(pc), numbers_[pc->a()].real);
  if (reply == Reply::Done) {
    observed_ = true;
    turned_ = false;
  }
  return reply;
}

Vm::State Vm::fail_timeout(Code pc) {
  return fail(pc, {.code = std::string(code::kTimeout),
                   .place = place(pc),
                   .message = "timeout: what this WAIT waits for did not come in time",
                   .help = "an ELSE behind TIMEOUT says what to do then"});
}

bool Vm::check_wait(Code pc, double seconds) {
  if (seconds >= 0) return true;
  error_ = {.code = std::string(code::kWaitNegative),
            .place = place(pc),
            .message = fmt::format("WAIT turned out to be for {}", number_text(seconds, kTime)),
            .help = "a time to wait is 0s or more"};
  return false;
}

bool Vm::check_pulse(Code pc, double seconds) {
  if (seconds > 0 && seconds <= kLongestPulse) return true;
  error_ = {.code = std::string(code::kPulseTime),
            .place = place(pc),
            .message = fmt::format("PULSE turned out to be for {}", number_text(seconds, kTime)),
            .help = fmt::format("a pulse takes more than 0s and at most {}",
                                number_text(kLongestPulse, kTime))};
  return false;
}

Reply Vm::teach(Code pc) {
  const PoseValue tip = setting().tool.tip;
  const auto tool =
      std::ranges::find_if(chunk_->tools, [&](const NamedTool& one) { return one.tip == tip; });
  const bool named = has_tool(setting()) && tool != chunk_->tools.end();
  return machine_->teach(line(pc), {.name = chunk_->texts[(pc + 1)->word],
                                    .frame = chunk_->texts[(pc + 2)->word],
                                    .tool = named ? std::string_view(tool->name) : "",
                                    .pose = load_pose(&numbers_[pc->a()])});
}

/// What cannot be read is asked again, and said why.
Reply Vm::ask(Code pc) {
  const Type& type = chunk_->types[(pc + 1)->word];
  std::string text = texts_[pc->a()];
  if (!misread_.empty()) text = fmt::format("{}; {}", misread_, text);
  std::optional<std::string> answer;
  const Reply reply = machine_->ask(line(pc), text, answer);
  if (reply == Reply::Later) return reply;
  misread_.clear();
  if (reply == Reply::Refused || !answer) return reply;
  const bool read = type.is(Type::Kind::String) ? read_answer(*answer, texts_[pc->b()])
                                                : read_answer(*answer, type, numbers_[pc->b()]);
  if (read) return Reply::Done;
  misread_ = misread_answer(*answer, type);
  return Reply::Later;
}

Reply Vm::simulate(Code pc, double value) {
  return machine_->simulate(line(pc), pc->x(), value, numbers_[pc->a() + 1].real);
}

bool Vm::check_after(Code pc, double seconds) {
  if (seconds >= 0) return true;
  error_ = {.code = std::string(code::kAfterNegative),
            .place = place(pc),
            .message = fmt::format("AFTER turned out to be {}", number_text(seconds, kTime)),
            .help = "SIMULATE acts now or later"};
  return false;
}

}  // namespace rob::lang
