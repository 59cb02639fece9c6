#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "runtime/tick/operator_panel.h"

namespace rob::runtime {

/// Orders of somebody who watches a run, for the report. motion → main.
struct Intervention {
  enum class Kind : std::uint8_t {
    Hold,      ///< the robot slows down on its path and stands there
    GoOn,      ///< and goes on
    Stop,      ///< it stops on its path for good, as with Ctrl-C
    Override,  ///< another share of the programmed speed
    Forgotten  ///< a Hold that nothing will ever end: the run ends there
  };

  double time = 0;  ///< s
  Kind kind = Kind::Hold;
  double share = 1;  ///< of Override
};

/// A signal script, or SIMULATE, in the operator's place: it answers HALT and ASK through
/// the OperatorPanel, and holds, stops and overrides the run. A GO ends a hold where there is one,
/// else it is for a HALT.
///
/// All calls belong to the tick.
class ScriptedOperator {
 public:
  /// The questions since the last take().
  struct Request {
    std::optional<bool> hold{};  ///< hold, or go on
    bool stop = false;
    double share = 0;  ///< an override; 0: none
  };

  /// `releases`: how often the script lets go of a hold, by GO or by STOP.
  ScriptedOperator(OperatorPanel& panel, OperatorPanel::Promise releases)
      : panel_(panel), releases_(releases) {}

  void answer(std::uint32_t text) noexcept { panel_.answer(text); }
  void hold() noexcept { request_.hold = held_ = true; }
  void go() noexcept {
    --releases_.times;
    if (!held_) return panel_.go();
    panel_.spend_go();
    request_.hold = held_ = false;
  }
  void stop() noexcept { request_.stop = true; }
  void set_override(double share) noexcept { request_.share = share; }

  Request take() noexcept { return std::exchange(request_, Request{}); }
  /// It holds the run, and will never let it go on or stop it.
  bool holds_for_ever() const noexcept {
    return held_ && !releases_.whenever && releases_.times <= 0;
  }

 private:
  OperatorPanel& panel_;
  OperatorPanel::Promise releases_;  ///< that are still to come
  Request request_;
  bool held_ = false;
};

}  // namespace rob::runtime
