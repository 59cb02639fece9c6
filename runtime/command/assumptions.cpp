#include "runtime/command/assumptions.h"

#include <fmt/format.h>

#include "runtime/words/codes.h"

namespace rob::runtime {

void Assumptions::note_read(int line, int signal) {
  if (inputs_.empty()) return;
  const std::string& name = inputs_[static_cast<std::size_t>(signal)];
  if (name.empty()) return;
  links_.log.found(
      {lang::Severity::Note, code::kAssumed, lang::tagged_place(line),
       fmt::format("assumed: {} is {} here", name, links_.signal(signal).analog ? "at 0 V" : "OFF"),
       "a signal script (--signals) says what it does"});
}

void Assumptions::note_read_in_condition(int signal) {
  if (!inputs_.empty() && !inputs_[static_cast<std::size_t>(signal)].empty()) read_ = signal;
}

bool Assumptions::taken_as_met(int line) {
  if (read_ < 0) return false;
  links_.log.found({lang::Severity::Note, code::kAssumed, lang::tagged_place(line),
                    fmt::format("assumed: this WAIT for {} is met after 0 s",
                                inputs_[static_cast<std::size_t>(read_)]),
                    "a signal script (--signals) says when it is"});
  return true;
}

void Assumptions::note_answer(int line, std::string_view what) {
  links_.log.found({lang::Severity::Note, code::kAssumed, lang::tagged_place(line),
                    what == "HALT"
                        ? "assumed: this HALT goes on at once"
                        : "assumed: this ASK is answered at once, and its variable keeps its value",
                    "a signal script (--signals) says what the operator does"});
}

void Assumptions::note_line(int line) {
  links_.log.found({lang::Severity::Note, code::kAssumed, lang::tagged_place(line),
                    "assumed: this RECEIVE gets an empty line at once",
                    "a signal script (--signals) says what the device sends"});
}

}  // namespace rob::runtime
