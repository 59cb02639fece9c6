#pragma once

#include <vector>

#include "motion/path/choice.h"
#include "motion/robots/robot_model.h"

namespace rob::motion {

/// Chooses along a path what is free: rungs at even distances of its parameter, on each the values
/// of the choice that can be reached from the rung before, and from rung to rung the way on which
///
///   Σ (Δq/v_max)²·N + 0.01·Σ (1/(1 − u²) − 1)
///
/// over N rungs is least (u: place within the limits, −1 … 1), by dynamic programming, the first
/// of equals. The rest that 72 values leave open is looked for among values that are eight times as
/// near, and among such again. Takes memory.
class Ladder {
 public:
  /// A value, and the axes there; `q` is empty before it is known.
  struct Hold {
    double value = 0;
    JointVector q;
  };

  /// `places`: of the rungs, rising; the first is the path's beginning. `share`: of a rung that a
  /// path is long which has one alone.
  Ladder(const RobotModel& robot, const Choice& choice, std::vector<double> places, double share)
      : robot_(robot), choice_(choice), places_(std::move(places)), share_(share) {}

  /// The choice at each rung from `start` on, which is at the beginning. Where the path cannot be
  /// followed on any way it ends before the last rung.
  std::vector<Hold> climb(const JointVector& start) const;

 private:
  struct State {
    double value = 0;
    JointVector q;  ///< empty: not reached
    double toll = 0;
    double sum = 0;
    int from = 0;
  };
  using Rung = std::vector<State>;

  struct Grid {
    double apart;  ///< of its values
    int side;      ///< values on either side of the middle
    int jump;      ///< the most from one rung to the next
  };

  std::vector<Hold> way(const std::vector<Hold>& middles, const Grid& grid) const;
  Rung rung(std::size_t at, const Hold& middle, const Rung& before, const Grid& grid) const;
  void spread(std::size_t at, int from, int step, Rung& rung) const;
  bool reach(double s_from, const State& from, double s, State& to, int halvings) const;
  bool join(const Rung& before, Rung& rung, const Grid& grid) const;
  double rungs() const noexcept { return static_cast<double>(places_.size() - 1); }

  const RobotModel& robot_;
  const Choice& choice_;
  std::vector<double> places_;
  double share_;
};

}  // namespace rob::motion
