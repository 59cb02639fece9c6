#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "lang/code/watch.h"
#include "lang/machine/move_command.h"
#include "lang/machine/reading.h"
#include "lang/machine/robot_signature.h"
#include "lang/values/pose_math.h"
#include "lang/values/setting.h"

namespace rob::lang {

/// The robot that a PrintingMachine has: where it is, and what its signals and its clock say. All
/// values are SI.
class ScriptedRobot {
 public:
  using Coordinates = std::array<double, kMaxCoordinates>;

  /// `robot` must outlive it.
  explicit ScriptedRobot(const RobotSignature& robot) : robot_(robot) {}

  /// The answers that the following looks at a signal find, one after another; the last stays.
  void script(int signal, std::vector<double> values);
  /// Sets what is found without a script.
  void write(int signal, double value) { written_[signal] = value; }
  /// Looks at a signal.
  double value_of(int signal);

  void work_in(const Setting& setting) { setting_ = setting; }
  /// Where a motion leads, from where the robot is; nothing if that is out of reach.
  std::optional<Coordinates> target_of(const MoveCommand& command) const;
  void go_to(const Coordinates& target) { at_ = target; }
  PoseValue forward(std::span<const double> joints) const;
  /// False if there are no joints for the pose.
  bool inverse(const PoseValue& pose, std::span<double> joints) const;
  void read(Reading what, Slot* value) { read(what, setting_, value); }

  /// Looks at the condition of the last motion until it holds or cannot be computed, or the scripts
  /// change no more. Unless it cannot be computed, HITPOSE is where the robot is, from then on.
  WatchResult watch(const Watch& condition);

  bool stands() const { return standing_; }
  /// Waits for a condition; each further time for one cycle. The time, in s.
  double stand();
  void go_on() { standing_ = false; }

 private:
  struct Script {
    std::vector<double> values;
    std::size_t next = 0;
  };

  void read(Reading what, const Setting& setting, Slot* value);
  double now() const;

  const RobotSignature& robot_;
  std::map<int, Script> scripts_;
  std::map<int, double> written_;
  Setting setting_;
  Coordinates at_{};   ///< where the last motion leads
  Coordinates hit_{};  ///< where the last guarded motion ended
  int cycle_ = 0;
  bool standing_ = false;
};

/// The name that script() has for a part of the force sensor's: force x y z, torque x y z.
constexpr int force_part(int component) { return -1 - component; }

}  // namespace rob::lang
