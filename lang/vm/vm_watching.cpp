#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <fmt/core.h>

#include "lang/code/watch.h"
#include "lang/text/codes.h"
#include "lang/values/number_text.h"
#include "lang/vm/vm.h"

/// Member functions of Vm that set up what is checked in every control cycle.
namespace rob::lang {

Watch Vm::watch_of(Code pc) const {
  Watch watch;
  watch.chunk = chunk_;
  watch.form = chunk_->watches[pc->x()];
  std::copy_n(numbers_ + pc->a(), watch.form.values, watch.values.begin());
  watch.setting = setting();
  return watch;
}

Reply Vm::guard(Code pc) { return machine_->guard(line(pc), watch_of(pc)); }

Reply Vm::live_pace(Code pc) {
  return machine_->live_pace(line(pc), watch_of(pc),
                             static_cast<MoveCommand::Pace>((pc + 1)->word));
}

Reply Vm::ended(Code pc) {
  bool hit = false;
  const Reply reply = machine_->ended(line(pc), hit);
  if (reply != Reply::Later) {
    hit_ = hit;
    guarded_ = true;
  }
  if (reply == Reply::Done) {
    numbers_[pc->a()].integer = hit ? 1 : 0;
    observed_ = true;
    turned_ = false;
  }
  return reply;
}

Reply Vm::when(Code pc) {
  Armed armed;
  armed.depth = depth();
  armed.level = (pc + 1)->word;
  const Reply reply = machine_->when(line(pc), watch_of(pc), armed.id);
  if (reply == Reply::Done) armed_[armed_count_++] = armed;
  return reply;
}

/// How many were armed before the first of this frame with that level.
std::size_t Vm::whens_below(std::size_t level) const {
  const auto end = armed_.begin() + static_cast<std::ptrdiff_t>(armed_count_);
  const auto first = std::find_if(armed_.begin(), end, [&](const Armed& one) {
    return one.depth > depth() || (one.depth == depth() && one.level >= level);
  });
  return static_cast<std::size_t>(first - armed_.begin());
}

Reply Vm::disarm(int line, std::size_t kept) {
  while (armed_count_ > kept) {
    const Reply reply = machine_->disarm(line, armed_[armed_count_ - 1].id);
    if (reply != Reply::Done) return reply;
    --armed_count_;
  }
  return Reply::Done;
}

PathPlace Vm::place_of(Code pc) const {
  const Slot* const slots = numbers_ + pc->a();
  return {.before = pc->b() != 0,
          .distance = slots[0].real,
          .lead = slots[1].real,
          .written = place(pc)};
}

bool Vm::check_place(Code pc) {
  const PathPlace at = place_of(pc);
  if (at.distance >= 0 && std::abs(at.lead) <= kLongestLead) return true;
  error_ = {.code = std::string(code::kPlaceUnsound),
            .place = place(pc),
            .message = fmt::format("a path event lies 0mm or more from the end of its motion, with "
                                   "at most {}s of LEAD or LAG; this is {} and {}",
                                   kLongestLead, number_text(at.distance, kLength),
                                   number_text(std::abs(at.lead), kTime)),
            .help = ""};
  return false;
}

void Vm::interrupt(RuntimeError error) {
  misread_.clear();
  if (handling_) {  // it is the program's error, not one of the handler's own
    guards_.erase(guards_.begin() + static_cast<std::ptrdiff_t>(interrupted_.guards),
                  guards_.end());
  }
  state_ = fail(next_, std::move(error));
}

Vm::State Vm::fail_too_many_whens(Code pc) {
  return fail(pc,
              {.code = std::string(code::kTooManyWhens),
               .place = place(pc),
               .message = fmt::format("more than {} WHENs are armed at once", kMostWhens),
               .help = "a WHEN is armed until its block ends; is this routine calling itself?"});
}

}  // namespace rob::lang
