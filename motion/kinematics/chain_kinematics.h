#pragma once

#include <array>
#include <variant>
#include <vector>

#include "motion/kinematics/chain_descent.h"
#include "motion/kinematics/closed_forms.h"
#include "motion/kinematics/joint_chain.h"
#include "motion/kinematics/kinematics.h"

namespace rob::motion {

/// An arm of rotary and linear axes, one after the other, in whatever places. Axes after the chain,
/// a gripper's, do not move the flange and keep their values.
///
/// Six axes with a spherical wrist, or with axes 2, 3 and 4 parallel, have the closed form of the
/// nominal arm, polished on the exact chain. All others are searched from a fixed table of starts.
class ChainKinematics final : public Kinematics {
 public:
  /// `axes`: as many as joints, or more. `coordinates`: which of x, y, z, a, b, c a target says;
  /// none: the robot is commanded in its axes alone.
  /// `freedom`: what poses do not say.
  ChainKinematics(JointChain chain, int axes, std::vector<int> coordinates,
                  Freedom freedom = Freedom::None);

  int axes() const noexcept override { return axes_; }
  Pose forward(const JointVector& q) const noexcept override { return chain_.forward(q); }
  bool inverts() const noexcept override { return !coordinates_.empty(); }
  bool iterates() const noexcept override { return true; }
  Freedom freedom() const noexcept override { return freedom_; }
  std::shared_ptr<const Kinematics> leaving(Freedom freedom, const Pose& tip) const override;
  /// Up to 24 of those within the limits where there is no closed form. With more than six axes
  /// each is one of infinitely many.
  InverseSolutions solutions(const Pose& pose, const JointVector& near) const noexcept override;
  /// That to which damped least squares lead from `near`; with more than six axes those beyond six
  /// keep their values, if that can be. So does the last of five where the tool points straight up
  /// or down (within 0.01°), and it would change nothing but c.
  std::optional<JointVector> inverse(const Pose& pose,
                                     const JointVector& near) const noexcept override;
  int spare() const noexcept override { return spare_; }
  std::optional<JointVector> beside(const Pose& pose,
                                    const JointVector& near) const noexcept override;
  std::optional<JointVector> closest(const Pose& pose,
                                     const JointVector& near) const noexcept override;
  /// The chain stretched out from there.
  double lever(int axis, const Eigen::Vector3d& tip) const noexcept override;
  bool shifts(int axis) const noexcept override;
  LinkFrames frames(const JointVector& q) const noexcept override;
  int coordinate(int i) const noexcept override;
  SingularPlace nearest_singularity(
      const JointVector& q,
      double within = std::numeric_limits<double>::infinity()) const noexcept override;
  /// The least singular value of the Jacobian, lengths divided by the chain's own.
  double stretch(const JointVector& q) const noexcept override;
  const char* reach() const noexcept override;

  const JointChain& chain() const noexcept { return chain_; }
  /// Whether a closed form was found.
  bool closed() const noexcept { return form_.index() != 0; }
  /// The axes that keep their values along a path, one bit each: those that can best be spared.
  unsigned kept() const noexcept { return kept_; }

 private:
  static constexpr int kStarts = 24;
  static constexpr int kSteps = 40;
  /// Where these lead nowhere, more starts follow, and then such that go on for longer, to the
  /// first that arrives. [choice] of the poses that can be reached one in 100 to 1000 needs it,
  /// near singular places and limits; of a pose out of reach it takes ten milliseconds.
  static constexpr int kMoreStarts = 768;
  static constexpr int kPatientStarts = 96;
  static constexpr int kPatientSteps = 160;

  ChainDescent descent() const noexcept { return ChainDescent(chain_).leave(freedom_); }
  InverseSolutions nominal(const Pose& pose, const JointVector& near) const noexcept;
  void search(const Pose& pose, const JointVector& near, InverseSolutions& found) const noexcept;
  void search_from_starts(const Pose& pose, const JointVector& near, unsigned kept,
                          InverseSolutions& found) const noexcept;
  JointVector start(int number, const JointVector& near) const noexcept;
  void add(JointVector q, const JointVector& near, InverseSolutions& found) const noexcept;
  double least_singular(const JointVector& q, unsigned without) const noexcept;
  void choose_kept();
  unsigned kept_for(const Pose& pose) const noexcept;

  JointChain chain_;
  int axes_;
  std::vector<int> coordinates_;
  Freedom freedom_;
  std::variant<std::monostate, WristForm, ParallelForm> form_;
  double length_ = 1;  ///< m, of the chain
  unsigned kept_ = 0;
  int spare_ = -1;  ///< the first of them
};

}  // namespace rob::motion
