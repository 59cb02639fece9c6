#include "motion/kinematics/chain_descent.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Cholesky>

#include "motion/space/rotation.h"

namespace rob::motion {

namespace {

constexpr double kPerRad = 0.1;  // m that count as 1 rad

/// The square of the least damping. [choice] it keeps the equations solvable where the axes lose a
/// direction, and costs a Newton step nothing that could be seen.
constexpr double kLeastDamping = 1e-15;

/// rad or m: the longest step of an axis. [choice] a quarter of a turn and more would be chance
constexpr double kLongestStep = 1;

}  // namespace

ChainDescent::Error ChainDescent::error(const Pose& pose, const Pose& here) const noexcept {
  Error error;
  error.head<3>() = (pose.position - here.position) / kPerRad;
  const Eigen::Quaterniond turn = pose.orientation * here.orientation.conjugate();
  error.tail<3>() = rotation_vector(without_free(turn, free_, here.orientation));
  return error;
}

double ChainDescent::miss(const Pose& pose, const JointVector& q) const noexcept {
  return error(pose, chain_.forward(q)).norm();
}

void ChainDescent::project(JointVector& q) const noexcept {
  for (int i = 0; i < chain_.size(); ++i)
    q[i] = std::clamp(q[i], chain_.joint(i).min, chain_.joint(i).max);
}

bool ChainDescent::way_to(const Error& error, const JointChain::Jacobian& jacobian, double damping,
                          Way& way) const noexcept {
  if (chain_.size() >= 6) {
    Eigen::Matrix<double, 6, 6> normal = jacobian.lazyProduct(jacobian.transpose());
    normal.diagonal().array() += damping;
    const Eigen::LLT<Eigen::Matrix<double, 6, 6>> solver(normal);
    if (solver.info() != Eigen::Success) return false;
    way = jacobian.transpose().lazyProduct(solver.solve(error));
    return true;
  }
  Eigen::Matrix<double, kMaxJoints, kMaxJoints> normal = jacobian.transpose().lazyProduct(jacobian);
  normal.diagonal().array() += damping;
  for (int i = chain_.size(); i < kMaxJoints; ++i) normal(i, i) = 1;
  const Eigen::LLT<Eigen::Matrix<double, kMaxJoints, kMaxJoints>> solver(normal);
  if (solver.info() != Eigen::Success) return false;
  way = solver.solve(jacobian.transpose().lazyProduct(error));
  return true;
}

/// Takes the axes out of the Jacobian that stand on a limit which the step would pass; whether
/// there are any.
bool ChainDescent::hold_at_limits(const JointVector& q, const Way& way,
                                  JointChain::Jacobian& jacobian) const noexcept {
  bool held = false;
  for (int i = 0; i < chain_.size(); ++i) {
    const ChainJoint& joint = chain_.joint(i);
    const bool passes = (q[i] >= joint.max && way[i] > 0) || (q[i] <= joint.min && way[i] < 0);
    if (!passes) continue;
    jacobian.col(i).setZero();
    held = true;
  }
  return held;
}

/// One damped step; `jacobian` comes in as it is and is scaled as the error is.
bool ChainDescent::step(const Error& error, JointChain::Jacobian& jacobian, double damping,
                        JointVector& q) const noexcept {
  const int n = chain_.size();
  jacobian.topRows<3>() /= kPerRad;
  for (int i = 0; i < n; ++i)
    if ((kept_ >> i & 1U) != 0) jacobian.col(i).setZero();
  Way way;
  if (!way_to(error, jacobian, damping, way)) return false;
  if (bounded_ && hold_at_limits(q, way, jacobian) && !way_to(error, jacobian, damping, way))
    return false;
  const double longest = way.cwiseAbs().maxCoeff();
  if (!(longest < 1e9)) return false;
  q.head(n) += way.head(n) * std::min(1.0, kLongestStep / std::max(longest, kLongestStep));
  return true;
}

/// The free turn counts for nothing; the error has no part in it.
void ChainDescent::take_out_free(const Pose& here, JointChain::Jacobian& jacobian) const noexcept {
  if (free_ == Freedom::None) return;
  const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d axis = free_ == Freedom::C ? z : here.orientation * z;
  for (int i = 0; i < chain_.size(); ++i) {
    auto turning = jacobian.col(i).tail<3>();
    turning -= axis * axis.dot(turning);
  }
}

bool ChainDescent::run(const Pose& pose, int steps, JointVector& q) const noexcept {
  // Where the error is so small, Newton's next step leaves nothing but rounding.
  constexpr double kNearly = 1e-7;
  // [choice] A start that gets no nearer in so many steps is stuck where its limits hold it.
  constexpr int kPatience = 4;
  constexpr double kProgress = 0.8;
  double least = std::numeric_limits<double>::infinity();
  int waited = 0;
  JointChain::Jacobian jacobian;
  for (int k = 0; k <= steps; ++k) {
    const Pose here = chain_.forward(q, jacobian);
    const Error missed = error(pose, here);
    const double square = missed.squaredNorm();
    if (!(square < 1e12)) return false;
    const bool nearly = square < kNearly * kNearly;
    if (k == steps && !nearly) return false;
    waited = square < kProgress * least ? 0 : waited + 1;
    if (bounded_ && !patient_ && waited > kPatience) return false;
    least = std::min(least, square);
    take_out_free(here, jacobian);
    if (!step(missed, jacobian, kLeastDamping + square / 2, q)) return false;
    if (bounded_) project(q);
    if (nearly && miss(pose, q) < kFound) return true;
  }
  return false;
}

/// Levenberg and Marquardt's damping: what comes nearer is kept and damped less, what does not is
/// tried again with more.
void ChainDescent::approach(const Pose& pose, int steps, JointVector& q) const noexcept {
  constexpr double kLess = 0.3;
  constexpr double kMore = 4;
  double damping = 1;
  JointChain::Jacobian jacobian;
  for (int k = 0; k < steps; ++k) {
    const Pose here = chain_.forward(q, jacobian);
    take_out_free(here, jacobian);
    const Error missed = error(pose, here);
    JointVector tried = q;
    if (!missed.allFinite() || !step(missed, jacobian, kLeastDamping + damping, tried)) return;
    if (bounded_) project(tried);
    const bool nearer = miss(pose, tried) < missed.norm();
    if (nearer) q = tried;
    damping *= nearer ? kLess : kMore;
  }
}

}  // namespace rob::motion
