#pragma once

#include <string>
#include <vector>

#include "lang/types.h"

namespace rob::lang {

/// What the language has to know of a robot: how its targets are written and which signals its
/// file declares. Limits are none of its business; motion refuses what is out of reach.
struct RobotSignature {
  struct Coordinate {
    std::string name;     ///< "x", "theta"
    Dimension dimension;  ///< kLength or kAngle
  };
  struct Signal {
    std::string name;     ///< "lift"; empty for a channel that has none
    bool output = false;  ///< may be assigned
    int channel = 0;      ///< n of DIN[n] or DOUT[n]
  };

  std::string name;
  std::vector<Coordinate> coordinates;  ///< at most kMaxCoordinates, in the order of a tuple
  std::vector<Signal> signals;          ///< the index is the number that Machine is given
};

/// "lift", or "DOUT[3]" for what has no name.
inline std::string shown_name(const RobotSignature::Signal& signal) {
  if (!signal.name.empty()) return signal.name;
  return (signal.output ? "DOUT[" : "DIN[") + std::to_string(signal.channel) + "]";
}

inline constexpr int kMaxCoordinates = 8;

}  // namespace rob::lang
