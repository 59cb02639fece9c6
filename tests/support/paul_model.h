#pragma once

#include <cstddef>
#include <vector>

namespace rob::test {

/// One value per axis, in the units of the published formulas and of the trace: mm or deg.
using AxisValues = std::vector<double>;

/// What S1's law has to know of a robot. mm/s or deg/s per axis; s.
struct PaulRobot {
  AxisValues v_max;
  double t_acc = 0;
  std::size_t tool_axes = 2;  ///< the first axes are the tool's place in mm; the others turn it
};

/// The corner at a target: S1 gives every target the robot's t_acc; ZONE gives it one of its own.
struct PaulZone {
  enum class Kind { Robots, Time, Share, Length, Fine };
  Kind kind = Kind::Robots;
  double value = 0;  ///< s, 1 = 100 %, mm
};

/// One statement of a program: a MOVE, or a STOP or END.
struct PaulStep {
  int line = 0;
  bool stop = false;  ///< STOP or END; costs nothing where the axes are exact already
  AxisValues target;  ///< of a MOVE: every axis, mm or deg
  double t_user = 0;  ///< of a MOVE: lower bound on T1, s
  PaulZone zone{};
};

/// One segment B→C of the run with the reference A at which it was taken up.
struct PaulSegment {
  int line = 0;
  bool stop = false;
  bool further = false;  ///< the stop that FINE makes, of the same statement as the one before
  double start = 0;      ///< s since the start of the run: the decision point before it
  double t1 = 0;         ///< s
  double t_in = 0;       ///< s: t_acc at b
  double t_out = 0;      ///< s: t_acc at c
  AxisValues a, b, c;

  /// s from the decision point before it to its own: t runs from −t_in to t1 − t_out.
  double span() const { return t1 + (t_in - t_out); }
};

/// Position, velocity and acceleration of every axis at one instant: mm or deg, per s, per s².
struct AxisState {
  AxisValues q, qd, qdd;
};

/// A second, independent reading of the published transition law (S1, after R. P. Paul), against
/// which runs are judged. It knows the whole program beforehand and answers for any instant; it
/// shares no code with the controller and is written for clearness, not for a tick.
class PaulModel {
 public:
  /// `start`: where the axes stand. Every target and v_max must have as many axes.
  PaulModel(PaulRobot robot, const AxisValues& start, const std::vector<PaulStep>& steps);

  const PaulRobot& robot() const { return robot_; }
  const std::vector<PaulSegment>& segments() const { return segments_; }
  /// s: of the tightest corner.
  double least_t_acc() const;
  /// s; the sum of all segment times.
  double total() const;
  /// Before 0 the start, after total() the end, both at rest.
  AxisState at(double time) const;
  /// Least distance, in mm, of the tool from the target of that segment while it passes: in the
  /// transition around the target, looked for in 4000 places (to better than 0.01 mm).
  double corner_miss(std::size_t segment) const;
  /// The same on the whole of the two segments that meet at the target. It is less where the tool,
  /// on its way in or out, passes nearer than in the corner itself.
  double nearest_pass(std::size_t segment) const;

 private:
  void move(const PaulStep& step);
  void stop(int line, bool further);
  double zone_t_acc(const PaulZone& zone, double distance, double t_user) const;
  void add(PaulSegment next);
  AxisState in_segment(const PaulSegment& segment, double t) const;
  double least_distance(const AxisValues& place, double from, double to) const;

  PaulRobot robot_;
  AxisValues start_;
  AxisValues last_target_;
  double last_t_acc_;
  bool exact_ = true;  ///< nothing has moved, or the last segment had no length
  std::vector<PaulSegment> segments_;
};

/// Distance of the tool from a place, in mm, over the first `tool_axes` axes.
double tool_distance(const AxisValues& p, const AxisValues& q, std::size_t tool_axes);

}  // namespace rob::test
