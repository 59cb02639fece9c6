#include "motion/kinematics/chain_kinematics.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/Eigenvalues>

#include "base/halton.h"

namespace rob::motion {

namespace {

constexpr double kTurnAround = 2 * std::numbers::pi;
/// m: how far the ways of linear axes make a chain longer that have no limits.
constexpr double kUnbounded = 0;

/// Farthest that a joint slides.
double slide(const ChainJoint& joint) {
  if (!joint.linear || !std::isfinite(joint.min) || !std::isfinite(joint.max)) return kUnbounded;
  return std::max(std::abs(joint.min), std::abs(joint.max));
}

}  // namespace

ChainKinematics::ChainKinematics(JointChain chain, int axes, std::vector<int> coordinates,
                                 Freedom freedom)
    : chain_(std::move(chain)),
      axes_(axes),
      coordinates_(std::move(coordinates)),
      freedom_(freedom) {
  length_ = std::max(lever(0, Eigen::Vector3d::Zero()), StructureTolerance::kDistance);
  if (!inverts()) return;
  if (auto wrist = WristForm::of(chain_)) {
    form_ = *std::move(wrist);
  } else if (auto parallel = ParallelForm::of(chain_)) {
    form_ = *std::move(parallel);
  }
  choose_kept();
}

std::shared_ptr<const Kinematics> ChainKinematics::leaving(Freedom freedom, const Pose& tip) const {
  if (freedom_ == Freedom::None) return nullptr;
  std::vector<ChainJoint> joints;
  for (int i = 0; i < chain_.size(); ++i) joints.push_back(chain_.joint(i));
  return std::make_shared<ChainKinematics>(
      JointChain(std::move(joints), composed(chain_.flange(), tip)), axes_, coordinates_, freedom);
}

/// One axis after the other, those without which the arm keeps most in the middle of its ranges.
void ChainKinematics::choose_kept() {
  JointVector middle = JointVector::Zero(axes_);
  for (int i = 0; i < chain_.size(); ++i) {
    const ChainJoint& joint = chain_.joint(i);
    if (std::isfinite(joint.min) && std::isfinite(joint.max))
      middle[i] = (joint.min + joint.max) / 2;
  }
  for (int more = chain_.size() - 6; more > 0; --more) {
    double most = -1;
    unsigned best = kept_;
    for (int i = 0; i < chain_.size(); ++i) {
      const unsigned without = kept_ | 1U << i;
      if (without == kept_) continue;
      const double left = least_singular(middle, without);
      if (!(left > most)) continue;
      most = left;
      best = without;
    }
    kept_ = best;
    if (spare_ < 0) spare_ = std::countr_zero(kept_);
  }
}

/// The least singular value of the Jacobian without some axes, lengths divided by the chain's; of
/// fewer than six axes the least that they have.
double ChainKinematics::least_singular(const JointVector& q, unsigned without) const noexcept {
  JointChain::Jacobian jacobian;
  chain_.forward(q, jacobian);
  jacobian.topRows<3>() /= length_;
  for (int i = 0; i < chain_.size(); ++i)
    if ((without >> i & 1U) != 0) jacobian.col(i).setZero();
  const Eigen::Matrix<double, 6, 6> square = jacobian.lazyProduct(jacobian.transpose());
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> solver(square,
                                                                          Eigen::EigenvaluesOnly);
  const int lost = std::max(0, 6 - chain_.size());
  return std::sqrt(std::max(0.0, solver.eigenvalues()[lost]));
}

bool ChainKinematics::shifts(int axis) const noexcept {
  return axis < chain_.size() && chain_.joint(axis).linear;
}

/// Axes after the chain carry nothing that is known: they stand in the flange.
LinkFrames ChainKinematics::frames(const JointVector& q) const noexcept {
  LinkFrames frames;
  Pose pose;
  for (int i = 0; i < chain_.size(); ++i) {
    const ChainJoint& joint = chain_.joint(i);
    const double half = q[i] / 2;
    pose = composed(pose, joint.place);
    if (joint.linear)
      pose.position = place_of({0, 0, q[i]}, pose);
    else
      pose.orientation =
          pose.orientation * Eigen::Quaterniond(std::cos(half), 0, 0, std::sin(half));
    frames[static_cast<std::size_t>(i)] = pose;
  }
  std::fill(frames.begin() + chain_.size(), frames.end(), composed(pose, chain_.flange()));
  return frames;
}

InverseSolutions ChainKinematics::nominal(const Pose& pose,
                                          const JointVector& near) const noexcept {
  if (const auto* const wrist = std::get_if<WristForm>(&form_)) return wrist->solutions(pose, near);
  return std::get<ParallelForm>(form_).solutions(pose, near);
}

InverseSolutions ChainKinematics::solutions(const Pose& pose,
                                            const JointVector& near) const noexcept {
  InverseSolutions found;
  if (!inverts() || !pose.position.allFinite() || !pose.orientation.coeffs().allFinite())
    return found;
  if (!closed()) {
    search(pose, near, found);
    return found;
  }
  constexpr int kPolish = 3;
  const InverseSolutions forms = nominal(pose, near);
  // Near a singular place the nominal arm may be far from the exact one.
  for (const int steps : {kPolish, kPatientSteps}) {
    if (found.count > 0) break;
    for (JointVector q : forms) {
      const JointVector six = q.head(chain_.size());
      q = near;
      q.head(chain_.size()) = six;
      if (descent().run(pose, steps, q)) add(q, near, found);
    }
  }
  if (found.count == 0) search(pose, near, found);
  return found;
}

void ChainKinematics::search(const Pose& pose, const JointVector& near,
                             InverseSolutions& found) const noexcept {
  const unsigned kept = kept_for(pose);
  if (kept != 0) {
    JointVector q = near;
    if (descent().within_limits().keep(kept).run(pose, kSteps, q)) add(q, near, found);
  }
  // Where the last of five axes would change nothing but c, it keeps its value if that can be.
  if (freedom_ == Freedom::C && kept != 0) search_from_starts(pose, near, kept, found);
  if (freedom_ != Freedom::C || found.count == 0) search_from_starts(pose, near, 0, found);
  for (int k = kStarts + 1; k <= kMoreStarts && found.count == 0; ++k) {
    JointVector q = start(k, near);
    if (descent().within_limits().run(pose, kSteps, q)) add(q, near, found);
  }
  for (int k = 0; k <= kPatientStarts && found.count == 0; ++k) {
    JointVector q = start(k, near);
    if (descent().within_limits().patiently().run(pose, kPatientSteps, q)) add(q, near, found);
  }
}

void ChainKinematics::search_from_starts(const Pose& pose, const JointVector& near, unsigned kept,
                                         InverseSolutions& found) const noexcept {
  for (int k = 0; k <= kStarts; ++k) {
    JointVector q = start(k, near);
    for (int i = 0; i < chain_.size(); ++i)
      if ((kept >> i & 1U) != 0) q[i] = near[i];
    if (descent().within_limits().keep(kept).run(pose, kSteps, q)) add(q, near, found);
  }
}

/// The first is where the arm is; the others are spread over the ranges, of an axis that turns
/// round over one turn.
JointVector ChainKinematics::start(int number, const JointVector& near) const noexcept {
  constexpr std::array<int, kMaxJoints> kPrimes{2, 3, 5, 7, 11, 13, 17, 19};
  JointVector q = near;
  if (number == 0) return q;
  for (int i = 0; i < chain_.size(); ++i) {
    const ChainJoint& joint = chain_.joint(i);
    const bool bounded = std::isfinite(joint.min) && std::isfinite(joint.max);
    const double middle = bounded ? (joint.min + joint.max) / 2 : 0;
    const double most = joint.linear ? 1 : kTurnAround;
    const double range =
        bounded && (joint.linear || joint.max - joint.min < most) ? joint.max - joint.min : most;
    q[i] = middle + range * (halton(number, kPrimes[static_cast<std::size_t>(i)]) - 0.5);
  }
  return q;
}

/// Those that differ by whole turns are one.
void ChainKinematics::add(JointVector q, const JointVector& near,
                          InverseSolutions& found) const noexcept {
  constexpr double kSame = 1e-6;
  if (found.count == InverseSolutions::kMost) return;
  for (int i = 0; i < chain_.size(); ++i)
    if (!chain_.joint(i).linear && std::abs(q[i] - near[i]) > std::numbers::pi)
      q[i] = near[i] + std::remainder(q[i] - near[i], kTurnAround);
  const bool known = std::any_of(found.begin(), found.end(), [&](const JointVector& other) {
    return (q - other).cwiseAbs().maxCoeff() < kSame;
  });
  if (!known) found.q[static_cast<std::size_t>(found.count++)] = q;
}

unsigned ChainKinematics::kept_for(const Pose& pose) const noexcept {
  constexpr double kUpright = 1.5e-8;  // 1 − cos 0.01°
  if (freedom_ != Freedom::C) return kept_;
  const double up = (pose.orientation * Eigen::Vector3d::UnitZ()).z();
  return std::abs(up) >= 1 - kUpright ? kept_ | 1U << (chain_.size() - 1) : kept_;
}

std::optional<JointVector> ChainKinematics::inverse(const Pose& pose,
                                                    const JointVector& near) const noexcept {
  if (!inverts()) return std::nullopt;
  JointVector q = near;
  const unsigned kept = kept_for(pose);
  if (descent().keep(kept).run(pose, kSteps, q)) return q;
  if (kept == 0) return std::nullopt;
  q = near;
  if (descent().run(pose, kSteps, q)) return q;
  return std::nullopt;
}

std::optional<JointVector> ChainKinematics::beside(const Pose& pose,
                                                   const JointVector& near) const noexcept {
  constexpr int kFewSteps = 8;
  if (!inverts()) return std::nullopt;
  JointVector q = near;
  if (!descent().keep(kept_for(pose)).run(pose, kFewSteps, q)) return std::nullopt;
  return q;
}

std::optional<JointVector> ChainKinematics::closest(const Pose& pose,
                                                    const JointVector& near) const noexcept {
  if (!inverts()) return std::nullopt;
  JointVector q = near;
  descent().within_limits().approach(pose, kSteps, q);
  return q;
}

double ChainKinematics::lever(int axis, const Eigen::Vector3d& tip) const noexcept {
  if (axis >= chain_.size() || chain_.joint(axis).linear) return 0;
  double length = chain_.flange().position.norm() + tip.norm();
  for (int i = axis + 1; i < chain_.size(); ++i)
    length += chain_.joint(i).place.position.norm() + slide(chain_.joint(i));
  return length;
}

int ChainKinematics::coordinate(int i) const noexcept {
  const auto index = static_cast<std::size_t>(i);
  return index < coordinates_.size() ? coordinates_[index] : i;
}

double ChainKinematics::stretch(const JointVector& q) const noexcept {
  return least_singular(q, kept_);
}

SingularPlace ChainKinematics::nearest_singularity(const JointVector& q,
                                                   double within) const noexcept {
  return stretch(q) > within ? SingularPlace::None : SingularPlace::Chain;
}

const char* ChainKinematics::reach() const noexcept {
  if (inverts()) return "reaches what its axes can do within their limits";
  return "is commanded in its axes alone, with MOVE and JOG JOINT: this version knows where they"
         " bring its tool, not what brings it to a pose";
}

}  // namespace rob::motion
