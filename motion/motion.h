#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "motion/plan/feasibility.h"
#include "motion/plan/motion_request.h"
#include "motion/robots/robot_library.h"
#include "motion/robots/robot_model.h"
#include "motion/space/joint_vector.h"

/// Rob's motion for a program of your own: a robot, motions that it shall make, and one reference
/// for its axes in every period. SI: m, rad, s.
///
///     using namespace rob::motion;
///     const RobotModel robot = load_robot("gantry");  // or a file that ends in .toml
///     Trajectory trajectory(robot, Law::LookAhead);
///
///     MotionRequest move;
///     move.given = 0b011;         // axes 0 and 1; the others stay
///     move.target = {0.1, 0.05};  // m
///     if (const auto refusal = trajectory.add(move)) …  // it says why; nothing has been added
///     trajectory.close();
///
///     JointReference reference;
///     for (Result result = Result::Working; result == Result::Working;) {
///       trajectory.plan();
///       …  // wait for the next period
///       result = trajectory.update(reference);
///       …  // give reference.q to the drives
///     }
namespace rob::motion {

/// The result of update().
enum class Result : std::uint8_t {
  Working,   ///< there is more to come, or may be
  Finished,  ///< close() has been called, all motions are done, and the axes stand
  Failed     ///< a reference would have been no number; the axes stand, and no motion begins
};

/// Motions in the axes of one robot, one after another, and the references that they ask for.
///
/// Where two motions meet the axes pass by the target, as near as the law and MotionRequest::zone
/// let them; stop() and close() make it exact. Whatever is asked, the axes keep within the speeds
/// and accelerations of the robot file.
///
/// add(), stop() and close() belong to one thread at a time, plan() to one, and update() to one;
/// that may be the same thread or three. hold() and override_speed() may be called by any thread.
/// No call waits for another.
class Trajectory {
 public:
  /// The axes stand at the start that the robot file gives, or at `start`, m, rad. Throws
  /// std::invalid_argument if the robot cannot be run under that law, or cannot stand there.
  Trajectory(const RobotModel& robot, Law law);
  Trajectory(const RobotModel& robot, Law law, const JointVector& start);
  ~Trajectory();
  Trajectory(Trajectory&&) noexcept;
  Trajectory& operator=(Trajectory&&) noexcept;

  /// The next motion begins where the last one ends. Takes any number of them. A refused one leaves
  /// everything as it was. Throws std::logic_error after close().
  std::optional<Refusal> add(const MotionRequest& request);
  /// The last motion ends exactly at its target, and the axes stand there before the next one.
  void stop();
  /// stop(), and nothing follows.
  void close();

  /// Plans ahead what has been added; nothing moves without it. It may take memory, and some
  /// milliseconds. Until all is done it must be called again and again, every 20 ms at least, or
  /// before each update(). Where it comes too late the axes come to rest on their path, and go on.
  void plan();

  /// The reference of the next period; the first one is that of the time 0, where the axes stand.
  /// Call it once in each RobotModel::reference_period. It takes no memory and no lock, and its
  /// work is bounded. After Finished and Failed the axes stand.
  Result update(JointReference& reference) noexcept;

  /// true: the axes slow down on their path, and stand there; false: they go on.
  void hold(bool stand) noexcept;
  /// The axes run at this share of the programmed speed; 1 at first. At most 1 under Paul's law, 2
  /// under the look-ahead law, where it is never more than the axes can do. A share that is not
  /// above 0 changes nothing.
  void override_speed(double share) noexcept;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace rob::motion
