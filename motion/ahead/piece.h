#pragma once

#include <algorithm>
#include <array>
#include <limits>

#include "motion/plan/torque_row.h"
#include "motion/space/joint_vector.h"
#include "motion/space/path_point.h"

namespace rob::motion {

/// A part of the path of look-ahead motion: the axes as polynomials of σ, the way along the path.
///
///     q(σ) = Σ terms[k]·(σ − begin)^k,   begin <= σ <= begin + length
///
/// Straight in the axes: two terms; a parabola: three; a quintic: six. σ in m, q in m or rad.
struct Piece {
  static constexpr int kMostTerms = 6;
  static constexpr double kAny = std::numeric_limits<double>::infinity();

  double begin = 0;   ///< σ of its beginning
  double length = 0;  ///< above 0
  int count = 2;      ///< of terms
  std::array<JointVector, kMostTerms> terms;
  JointVector acceleration;  ///< what each axis has here: m/s², rad/s²
  double wait = 0;           ///< s: a guide with pauses stands so long before it (Overlap)
  double calm = 1;           ///< that share of what the leg asks for, at most
  double pace = kAny;        ///< σ' that is asked for, at override 1
  double fastest = kAny;  ///< σ' that the speeds of the axes allow all along, and what else does
  int fastest_axis = -1;  ///< that sets it; −1: another reason

  /// The torque of all of the piece; where the mean of σ makes the references, of all around here.
  /// Without a slope and a bend: nothing is known of an arm.
  TorqueRow torque;

  // Where the mean of σ makes the references, places within half its time act together: the
  // greatest |dq/dσ| and |d²q/dσ²| of the axes around here, and the slope that in their place
  // bounds σ'' for the sake of the jerk. Empty: each place acts alone.
  JointVector slopes;
  JointVector bends;
  JointVector swings;

  /// No more than that share, however many corners ask for one.
  void calm_down(double share) noexcept {
    if (share >= calm) return;
    acceleration *= share / calm;
    calm = share;
  }

  bool straight() const noexcept { return count <= 2; }
  bool torqued() const noexcept { return torque.slope > 0 || torque.bend > 0; }
  bool averaged() const noexcept { return slopes.size() != 0; }

  /// σ' under an override: it slows what would be reached without one, and raises the pace as far
  /// as the axes go.
  double greatest_rate(double share) const noexcept {
    return std::min(std::min(pace, fastest) * share, fastest);
  }

  /// `at`: σ − begin. Derivatives with respect to σ.
  PathPoint point(double at) const noexcept {
    const Eigen::Index axes = terms[0].size();
    PathPoint p{JointVector(axes), JointVector(axes), JointVector(axes)};
    for (Eigen::Index i = 0; i < axes; ++i) {
      double q = terms[static_cast<std::size_t>(count - 1)][i];
      double qd = 0;
      double qdd = 0;
      for (int k = count - 2; k >= 0; --k) {
        qdd = qdd * at + 2 * qd;
        qd = qd * at + q;
        q = q * at + terms[static_cast<std::size_t>(k)][i];
      }
      p.q[i] = q;
      p.qd[i] = qd;
      p.qdd[i] = qdd;
    }
    return p;
  }
};

}  // namespace rob::motion
