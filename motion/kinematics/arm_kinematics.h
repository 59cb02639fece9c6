#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include <Eigen/Core>

#include "motion/kinematics/joint_chain.h"
#include "motion/kinematics/kinematics.h"

namespace rob::motion {

/// The measures of an arm with an ortho-parallel base and a spherical wrist (Brandstötter, Angerer,
/// Hofbaur: An analytical solution of the inverse kinematics problem …, 2014), m. At zero of the
/// angles θ below the arm stands straight up:
///
///      c4  ─ tool         axis 6, up
///      c3  ─ wrist        axes 4, 5, 6 meet; a2 beside axis 3 along x (negative: behind it)
///      c2  ─ axis 3       parallel to axis 2
///      c1  ─ axis 2       along y, a1 beside axis 1 along x
///       0  ─ base         axis 1, up
///
/// and the wrist is b beside axis 1 along y. The robot's own angles q count as
/// θ_i = sign_i·q_i + offset_i.
struct ArmParameters {
  static constexpr int kAxes = 6;

  double a1 = 0;
  double a2 = 0;
  double b = 0;
  double c1 = 0;
  double c2 = 0;                                     ///< upper arm, above 0
  double c3 = 0;                                     ///< forearm; above 0, or a2 is not 0
  double c4 = 0;                                     ///< from the wrist to the flange
  std::array<double, kAxes> sign{1, 1, 1, 1, 1, 1};  ///< each 1 or −1
  std::array<double, kAxes> offset{};                ///< rad
};

/// rad: of the axes, as the robot counts them.
struct ArmLimits {
  std::array<double, ArmParameters::kAxes> min = all(-std::numeric_limits<double>::infinity());
  std::array<double, ArmParameters::kAxes> max = all(std::numeric_limits<double>::infinity());

 private:
  static constexpr std::array<double, ArmParameters::kAxes> all(double value) {
    return {value, value, value, value, value, value};
  }
};

/// Which of the eight solutions a posture is. Where it is singular either is right.
struct ArmBranch {
  bool behind = false;          ///< the wrist is behind axis 1: the arm leans back over itself
  bool elbow_negative = false;  ///< the forearm is turned to negative θ3, counted from straight
  bool wrist_negative = false;  ///< sin θ5 is negative

  friend bool operator==(const ArmBranch&, const ArmBranch&) = default;
};

/// How far a posture is from each place where directions of motion are lost. All are 0 or more.
struct SingularityDistances {
  double shoulder = 0;  ///< m: of the wrist from the plane through axis 1 along axis 2
  double elbow = 0;     ///< rad: of the elbow from straight or wholly folded
  double wrist = 0;     ///< rad: of axis 5 from where axes 4 and 6 are in line
};

/// Every six-axis arm of that build, in closed form. The tool's frame is the flange: z out of it
/// along axis 6; the world is the base.
///
/// Singular places (S3; the joints go on without a jump): where |sin θ5| < 1e-10 θ4 keeps the value
/// of `near` and θ6 follows; where the wrist is within 4e-10 m of axis 1 (b = 0) θ1 keeps its
/// value, and where it is on axis 2 θ2 does. A place up to 1e-9 m out of reach is reached by the
/// arm stretched or folded.
class ArmKinematics final : public Kinematics {
 public:
  /// Throws std::invalid_argument for measures that are no arm's. Only closest() asks for limits.
  explicit ArmKinematics(const ArmParameters& parameters, const ArmLimits& limits = {});

  int axes() const noexcept override { return ArmParameters::kAxes; }
  Pose forward(const JointVector& q) const noexcept override;
  /// All eight; four where one of "ahead" and "behind" is out of reach, which a1 can bring about.
  /// In singular places some are the same posture.
  InverseSolutions solutions(const Pose& pose, const JointVector& near) const noexcept override;
  std::optional<JointVector> inverse(const Pose& pose,
                                     const JointVector& near) const noexcept override;
  std::optional<JointVector> closest(const Pose& pose,
                                     const JointVector& near) const noexcept override;
  Shortfall shortfall(const Pose& pose) const noexcept override;
  double lever(int axis, const Eigen::Vector3d& tip) const noexcept override;
  /// Those of the picture above, with axes 4, 5 and 6 in the wrist.
  LinkFrames frames(const JointVector& q) const noexcept override;
  SingularPlace nearest_singularity(
      const JointVector& q,
      double within = std::numeric_limits<double>::infinity()) const noexcept override;
  double stretch(const JointVector& q) const noexcept override { return singularities(q).elbow; }
  const char* reach() const noexcept override {
    return "reaches what its upper arm and its forearm span";
  }

  /// [velocity of the flange, m/s; its angular velocity, rad/s] = jacobian·q', both in the base.
  Eigen::Matrix<double, 6, 6> jacobian(const JointVector& q) const noexcept;
  ArmBranch branch(const JointVector& q) const noexcept;
  SingularityDistances singularities(const JointVector& q) const noexcept;

  const ArmParameters& parameters() const noexcept { return p_; }

 private:
  using Angles = Eigen::Matrix<double, 6, 1>;  // θ, rad
  struct Wrist;

  Angles angles_of(const JointVector& q) const noexcept;
  double ahead(const Angles& theta) const noexcept;
  Wrist wrist_of(const Pose& pose) const noexcept;
  Eigen::Vector2d span(const Wrist& wrist, bool behind) const noexcept;
  double turn_base(const Wrist& wrist, bool behind, double kept) const noexcept;
  template <typename Take>
  void search(const Pose& pose, const JointVector& near, ArmBranch first, const double& within,
              Take take) const noexcept;
  template <typename Take>
  static void turn_wrist(const Wrist& wrist, Angles theta, Take take) noexcept;
  double axis_value(int axis, double theta, double near) const noexcept;
  double square_of_way(const Angles& theta, const JointVector& near, int axes) const noexcept;

  ArmParameters p_;
  JointChain chain_;  // the same arm
  double k_ = 0;      // from axis 3 to the wrist
  double psi_ = 0;    // from the forearm's c3 to that line
};

}  // namespace rob::motion
