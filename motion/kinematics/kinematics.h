#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>

#include "motion/space/joint_vector.h"
#include "motion/space/pose.h"

namespace rob::motion {

/// The frame that each axis moves, from the first on, then the flange, all as seen from the base.
using LinkFrames = std::array<Pose, kMaxJoints + 1>;

/// All axis values that bring a tool to one pose; of those that differ by whole turns one. A closed
/// form has eight at most; a search finds no more than these.
struct InverseSolutions {
  static constexpr int kMost = 24;

  int count = 0;
  std::array<JointVector, kMost> q;

  const JointVector* begin() const noexcept { return q.data(); }
  const JointVector* end() const noexcept { return q.data() + count; }
};

/// Why no axis values bring the tool to a pose.
struct Shortfall {
  enum class Kind : std::uint8_t {
    Elsewhere,  ///< the robot cannot place or turn its tool so, wherever it is (Kinematics::reach)
    TooFar,     ///< the arm is too short by `distance`
    TooNear,    ///< the place is nearer than the arm can fold, by `distance`
    BesideAxis  ///< the place is too near to axis 1, by `distance`
  };

  Kind kind = Kind::Elsewhere;
  double distance = 0;  ///< m
};

/// Where an arm loses directions of motion.
enum class SingularPlace : std::uint8_t {
  None,
  Wrist,     ///< axes 4 and 6 are in line
  Shoulder,  ///< the wrist is on axis 1
  Elbow,     ///< stretched or folded
  Chain      ///< of a chain: its axes lose a direction there
};

/// The part of a pose that the axes leave to the place.
enum class Freedom : std::uint8_t {
  None,
  C,    ///< any turn about z of the base, through the tool
  Spin  ///< any turn about the tool's own z
};

/// A turn through the tip that a motion leaves to the robot.
struct FreeTurn {
  Freedom kind = Freedom::None;
  /// For C: the direction that it turns about, in the base; a unit vector.
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
};

/// `turn` less what is free: the shortest of the turns that are the same but for that. `frame`: the
/// tool's orientation in the base; both seen from the base.
Eigen::Quaterniond without_free(const Eigen::Quaterniond& turn, Freedom freedom,
                                const Eigen::Quaterniond& frame) noexcept;

/// A pose with the free turn made by an angle, rad.
Pose turned(const Pose& pose, const FreeTurn& free, double angle) noexcept;
/// `pose` with that of its free turns which is nearest to `from`; its own counts for nothing.
Pose nearest_turn(const Pose& pose, const FreeTurn& free, const Eigen::Quaterniond& from) noexcept;

/// From axes to tool. All calls are pure, take no memory and may be used in the tick.
class Kinematics {
 public:
  virtual ~Kinematics() = default;

  virtual int axes() const noexcept = 0;
  /// The tool's pose in the world; q: axes() values in m or rad.
  virtual Pose forward(const JointVector& q) const noexcept = 0;
  /// Whether it knows the way back, from tool to axes, at all. Without it there are no solutions.
  virtual bool inverts() const noexcept { return true; }
  /// Whether inverse() goes from `near` by iteration: who follows a path must look whether it stays
  /// on one branch.
  virtual bool iterates() const noexcept { return false; }
  /// The part of a pose that inverse() and solutions() do not look at.
  virtual Freedom freedom() const noexcept { return Freedom::None; }
  /// Every solution, each with its axes turned as near to `near` as whole turns bring them. None if
  /// there is no solution. Limits of the axes are not looked at.
  virtual InverseSolutions solutions(const Pose& pose, const JointVector& near) const noexcept = 0;
  /// The same axes with another part of a pose left open, and the tip of a tool, seen from the
  /// flange, as their flange; null where they leave none open. Takes memory.
  virtual std::shared_ptr<const Kinematics> leaving(Freedom /*freedom*/,
                                                    const Pose& /*tip*/) const {
    return nullptr;
  }
  /// The solution nearest to `near`, as sum of squares over the axes, or that on which the arm
  /// comes there from `near`.
  virtual std::optional<JointVector> inverse(const Pose& pose,
                                             const JointVector& near) const noexcept;
  /// If there are more axes than a pose needs: the one whose value chooses among infinitely many
  /// solutions; −1: there is none.
  virtual int spare() const noexcept { return -1; }
  /// The solution that is right beside `near`, for who goes on in small steps; the spare axis keeps
  /// its value. Where it takes more than a few iterations there is none.
  virtual std::optional<JointVector> beside(const Pose& pose,
                                            const JointVector& near) const noexcept {
    return inverse(pose, near);
  }
  /// Where there is none: the axis values within the limits from which the tool is nearest to the
  /// pose, 1 rad counted as 100 mm, as damped least squares find them from `near`. None: not known.
  virtual std::optional<JointVector> closest(const Pose& /*pose*/,
                                             const JointVector& /*near*/) const noexcept {
    return std::nullopt;
  }
  /// Why there is none, where there is none.
  virtual Shortfall shortfall(const Pose& /*pose*/) const noexcept { return {}; }
  /// How far the tip of a tool, seen from the flange (m), can be from the rotary axis `axis` at
  /// most, m; 0 of a linear axis.
  virtual double lever(int axis, const Eigen::Vector3d& tip) const noexcept = 0;
  /// Whether an axis is a linear one.
  virtual bool shifts(int /*axis*/) const noexcept { return false; }
  /// Neighbouring frames keep their distance, but for the travel of a linear axis.
  virtual LinkFrames frames(const JointVector& q) const noexcept = 0;
  /// Which of x, y, z, a, b, c, from 0 on, the robot's coordinate number i is.
  virtual int coordinate(int i) const noexcept { return i; }
  /// The singular place that `q` is nearest to, of those within `within`, rad.
  virtual SingularPlace nearest_singularity(
      const JointVector& /*q*/,
      double /*within*/ = std::numeric_limits<double>::infinity()) const noexcept {
    return SingularPlace::None;
  }
  /// rad: how far an arm is from being stretched or folded, where its tool can go on to one side
  /// alone and its axes would have to leap, or a chain from any singular place; infinite for robots
  /// without such places.
  virtual double stretch(const JointVector& /*q*/) const noexcept {
    return std::numeric_limits<double>::infinity();
  }
  /// In words, for messages: "places and turns its tool …".
  virtual const char* reach() const noexcept = 0;
};

}  // namespace rob::motion
