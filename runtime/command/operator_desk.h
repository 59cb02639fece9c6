#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "runtime/command/program_effects.h"
#include "runtime/command/waits.h"
#include "runtime/files/point_keeper.h"

namespace rob::runtime {

/// The program's requests to the person beside the machine: HALT, ASK and TEACH.
class OperatorDesk {
 public:
  OperatorDesk(const RobotLinks& links, Assumptions& assumptions, const CommandedProgress& progress,
               ProgramEffects& effects, Waits& waits)
      : links_(links),
        assumptions_(assumptions),
        progress_(progress),
        effects_(effects),
        waits_(waits) {}

  /// Where TEACH keeps points; without it (null), as while a program is foretold or tested, they
  /// live for the run only. It must outlive the run.
  void keep_points(PointKeeper* keeper) { keeper_ = keeper; }
  lang::Reply halt(int line, std::string_view text);
  lang::Reply ask(int line, std::string_view text, std::optional<std::string>& answer);
  lang::Reply teach(lang::TaughtPoint& point);
  /// The current HALT or ASK is given up.
  void drop() { consulting_ = false; }

 private:
  lang::Reply consult(int line, Note::Kind kind, std::string_view text);
  lang::Reply answered(int line, std::string answer, bool typed = false);
  /// Nobody will ever answer.
  lang::Reply unattended(int line, const char* what);
  bool attended() const;

  const RobotLinks& links_;
  Assumptions& assumptions_;
  const CommandedProgress& progress_;
  ProgramEffects& effects_;
  Waits& waits_;
  PointKeeper* keeper_ = nullptr;
  bool consulting_ = false;  ///< the text of the current HALT or ASK has been shown
};

}  // namespace rob::runtime
