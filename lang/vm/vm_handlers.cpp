#include <algorithm>
#include <string>
#include <utility>

#include "lang/vm/vm.h"

/// Member functions of Vm for the handlers of WHEN. A handler is a routine that no statement calls.
/// Its frame lies above everything that the interrupted program uses.
namespace rob::lang {

Reply Vm::when_handle(Code pc) {
  const Reply reply = machine_->when_handle(line(pc), pc->c() != 0);
  if (reply != Reply::Done) return reply;
  Armed& armed = armed_[armed_count_ - 1];
  armed.chunk = chunk_;
  armed.handler = pc;
  armed.captured = numbers_ + pc->a();
  armed.settings = settings_.size();
  return reply;
}

bool Vm::takes_handlers() const {
  const bool over = state_ == State::Done && !entries_;
  return !handling_ && !rescuing_ && circling_ == 0 && !over && state_ != State::Failed;
}

void Vm::handle(int when, Machine& machine) {
  const auto end = armed_.begin() + static_cast<std::ptrdiff_t>(armed_count_);
  const auto armed =
      std::find_if(armed_.begin(), end, [&](const Armed& one) { return one.id == when; });
  const bool top = depth() == 0;
  const RoutineCode* const routine = top ? nullptr : &chunk_->routines[(frame_ - 1)->routine];
  const std::uint32_t number = (armed->handler + 1)->word;
  interrupted_ = {machine_,         next_, latch_,   latched_random_, turned_, guards_.size(),
                  settings_.size(), hit_,  guarded_, frame_,          chunk_};
  machine_ = &machine;
  handling_ = true;
  if (state_ == State::Done) state_ = State::Running;
  Slot* const numbers = numbers_ + (top ? chunk_->registers : routine->registers);
  std::string* const texts = texts_ + (top ? chunk_->text_registers : routine->text_registers);
  if (armed->chunk != chunk_) {
    chunk_ = armed->chunk;
    interrupted_.callees = std::exchange(callees_, callees_of(*chunk_));
  }
  if (!enter(numbers, texts, number, next_)) {
    state_ = fail_calls_too_deep(armed->handler);
    return;
  }
  std::copy_n(armed->captured, armed->handler->b(), numbers_);
  settings_.push_back(armed->settings == 0 ? Setting{} : settings_[armed->settings - 1]);
  machine_->work_in(line(armed->handler), settings_.back());
  next_ = latch_ = callees_[number].entry;
}

/// The program goes on as though nothing had been, but for what the handler has changed.
void Vm::end_handler() {
  abandon_handler();
  settings_.resize(interrupted_.settings);
  next_ = interrupted_.next;
  latch_ = interrupted_.latch;
  latched_random_ = interrupted_.latched_random;
  turned_ = interrupted_.turned;
  hit_ = interrupted_.hit;
  guarded_ = interrupted_.guarded;
}

/// What goes wrong in a handler goes wrong in the program.
void Vm::abandon_handler() {
  while (frame_ != interrupted_.frame) leave_routine();
  if (chunk_ != interrupted_.chunk) {
    chunk_ = interrupted_.chunk;
    callees_.swap(interrupted_.callees);
  }
  machine_ = interrupted_.machine;
  handling_ = false;
}

}  // namespace rob::lang
