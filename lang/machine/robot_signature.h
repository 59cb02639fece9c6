#pragma once

#include <string>
#include <vector>

#include "lang/values/types.h"
#include "lang/values/units.h"

namespace rob::lang {

/// The language's knowledge of a robot: how its targets are written and which signals its
/// file declares. Limits are none of its business; motion refuses what is out of reach.
struct RobotSignature {
  struct Coordinate {
    std::string name;     ///< "x", "theta"
    Dimension dimension;  ///< kLength or kAngle
  };
  struct Signal {
    std::string name;     ///< "lift"; empty for a channel that has none
    bool output = false;  ///< may be assigned
    int channel = 0;      ///< n of DIN[n], DOUT[n], AIN[n] or AOUT[n]
    bool analog = false;  ///< a VOLTAGE from 0V to kMostVolts, not a BOOL
  };

  std::string name;
  std::vector<Coordinate> coordinates;  ///< at most kMaxCoordinates, in the order of a tuple
  std::vector<Coordinate> axes;         ///< at most kMaxCoordinates, in the order of JOINTS
  /// Of bare numbers in a tuple, where they are not mm or deg; by the number of the file.
  std::vector<std::vector<Unit>> units{};
  std::vector<Signal> signals;  ///< the index is the number that Machine is given
  bool force_sensor = false;    ///< `force`, `torque` and WRENCH() can be read
  /// Axes that a target may name beside its coordinates; the last ones of `axes`.
  std::vector<Coordinate> grippers{};
  std::vector<std::string> bodies{};     ///< that can hit something, for ALLOW
  std::vector<std::string> obstacles{};  ///< of the robot's file and its cell
  std::vector<std::string> declared{};   ///< those that earlier entries of a prompt have declared
};

/// All that a target can name: the coordinates, then the gripper axes.
std::vector<RobotSignature::Coordinate> elements_of(const RobotSignature& robot);

/// "DOUT": what the channels of a kind are called.
inline const char* channel_word(bool output, bool analog) {
  if (analog) return output ? "AOUT" : "AIN";
  return output ? "DOUT" : "DIN";
}

/// "lift", or "DOUT[3]" for what has no name.
std::string shown_name(const RobotSignature::Signal& signal);

/// The highest value of an analog channel, V; the lowest is 0V. [choice] The range of nearly all
/// analog modules.
inline constexpr double kMostVolts = 10;

inline constexpr int kMaxCoordinates = 8;

}  // namespace rob::lang
