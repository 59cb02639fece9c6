#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "runtime/command/robot_machine.h"
#include "runtime/words/codes.h"

/// Member functions of RobotMachine that report what is assumed while a program is foretold.
namespace rob::runtime {

void RobotMachine::assume(std::vector<std::string> inputs) {
  if (handlers_ != nullptr) handlers_->assume(inputs);
  assumed_ = std::move(inputs);
  foretelling_ = true;
  settling_.leave_out();
}

void RobotMachine::note_assumed(int line, int signal) {
  if (!standing_) return note_assumed_value(line, signal);
  // taken_as_met() or waited() says it.
  if (!assumed_[static_cast<std::size_t>(signal)].empty()) assumed_read_ = signal;
}

void RobotMachine::note_assumed_value(int line, int signal) {
  if (assumed_.empty()) return;
  const std::string& name = assumed_[static_cast<std::size_t>(signal)];
  if (name.empty()) return;
  const bool analog = signals_[static_cast<std::size_t>(signal)].analog;
  log_.found({lang::Severity::Note, code::kAssumed, lang::tagged_place(line),
              fmt::format("assumed: {} is {} here", name, analog ? "at 0 V" : "OFF"),
              "a signal script (--signals) says what it does"});
}

bool RobotMachine::taken_as_met(int line) {
  if (assumed_read_ < 0) return false;
  log_.found({lang::Severity::Note, code::kAssumed, lang::tagged_place(line),
              fmt::format("assumed: this WAIT for {} is met after 0 s",
                          assumed_[static_cast<std::size_t>(assumed_read_)]),
              "a signal script (--signals) says when it is"});
  return true;
}

void RobotMachine::note_answer_assumed(int line, const char* what) {
  const bool halt = std::string_view(what) == "HALT";
  log_.found({lang::Severity::Note, code::kAssumed, lang::tagged_place(line),
              halt ? "assumed: this HALT goes on at once"
                   : "assumed: this ASK is answered at once, and its variable keeps its value",
              "a signal script (--signals) says what the operator does"});
}

}  // namespace rob::runtime
