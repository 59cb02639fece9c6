#include "motion/generate/corner_miss.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "motion/path/paul_transition.h"

namespace rob::motion {

namespace {

/// The corner is cut into this many parts; the least of them is then searched. [choice: the
/// distance is smooth, of low degree, and has a few minima at most]
constexpr int kParts = 64;

/// Least value of f in [low, high], where it has one minimum: golden section.
template <typename F>
double least(const F& f, double low, double high) {
  constexpr double kGolden = std::numbers::phi - 1;
  double left = high - kGolden * (high - low);
  double right = low + kGolden * (high - low);
  double f_left = f(left);
  double f_right = f(right);
  // 60 steps shrink the interval by 3e-13.
  for (int i = 0; i < 60; ++i) {
    if (f_left <= f_right) {
      high = right;
      right = left;
      f_right = f_left;
      left = high - kGolden * (high - low);
      f_left = f(left);
    } else {
      low = left;
      left = right;
      f_left = f_right;
      right = low + kGolden * (high - low);
      f_right = f(right);
    }
  }
  return std::min(f_left, f_right);
}

/// The least distance of `curve`, −half <= t <= half, from the place of `via`.
template <typename Curve>
double least_distance(const Kinematics& kinematics, const JointVector& via, const Curve& curve,
                      double t_acc, const Eigen::Vector3d& tip) {
  const Eigen::Vector3d point = place_of(tip, kinematics.forward(via));
  const auto distance = [&](double t) {
    return (place_of(tip, kinematics.forward(curve(t))) - point).norm();
  };
  const double step = 2 * t_acc / kParts;
  double best = distance(t_acc);
  double at = t_acc;
  for (int i = 0; i < kParts; ++i) {
    const double t = -t_acc + i * step;
    if (const double d = distance(t); d < best) {
      best = d;
      at = t;
    }
  }
  return std::min(best, least(distance, std::max(at - step, -t_acc), std::min(at + step, t_acc)));
}

}  // namespace

double corner_miss(const Kinematics& kinematics, const JointVector& via,
                   const JointVector& incoming, const JointVector& outgoing, double t_acc,
                   const Eigen::Vector3d& tip) {
  const PaulTransition corner(via - incoming * t_acc, via, via + outgoing * t_acc, t_acc, t_acc);
  return least_distance(
      kinematics, via, [&](double t) { return corner.sample(t).q; }, t_acc, tip);
}

double corner_miss(const Kinematics& kinematics, const JointVector& from, const SegmentMotion& in,
                   const SegmentMotion& out, const Eigen::Vector3d& tip) {
  if (out.from_rest || out.no_length || in.ends_at_rest()) return 0;
  if (out.corner != nullptr) {
    return least_distance(
        kinematics, in.target, [&](double t) { return out.corner->axes.at(t).q; }, out.corner->half,
        tip);
  }
  return corner_miss(kinematics, in.target, (in.target - from) / in.duration,
                     (out.target - in.target) / out.duration, in.t_acc, tip);
}

}  // namespace rob::motion
