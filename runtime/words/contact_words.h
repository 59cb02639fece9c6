#pragma once

#include <string>

#include "motion/robots/robot_model.h"
#include "runtime/words/words.h"

namespace rob::runtime {

/// Where a robot would hit itself or what stands around it.
struct Contact {
  int line = 0;             ///< tag of the motion
  std::string body;         ///< of the robot
  std::string other;        ///< another body, or an obstacle
  bool from_start = false;  ///< the two touch where the motion begins
  double at = 0;            ///< s from the beginning of the motion; 0: not known
  double share = 0;         ///< of its way, where the time is not known
  bool corner = false;      ///< in the corner that leads into the motion
  motion::JointVector q;    ///< m, rad
};

/// W680: `distance` m; below 0 the two are in each other.
std::string near_words(const std::string& body, const std::string& other, double distance);

/// E580 or E581.
Words words_for(const Contact& contact, const motion::RobotModel& robot);

}  // namespace rob::runtime
