#pragma once

#include <string>
#include <vector>

#include "lang/code/chunk.h"
#include "lang/machine/robot_signature.h"
#include "motion/robots/robot_model.h"

namespace rob::runtime {

/// The name of an output in reports, and how they show its value: by the program's SIGNAL where
/// there is one (the first, if there are several), else by the robot file's name, else by its
/// channel.
class SignalNames {
 public:
  SignalNames(const motion::RobotModel& robot, const std::vector<lang::NamedSignal>& named);

  /// `channel` counts from 0.
  std::string output(int channel) const { return find(false, channel).name; }
  std::string analog_output(int channel) const { return find(true, channel).name; }

  /// A voltage as the program's quantity: a number in the unit that PRINT writes it with.
  struct Quantity {
    double number = 0;
    std::string unit;
    std::string text;  ///< both, "150mm/s"
  };
  Quantity quantity(int channel, double volts) const;

 private:
  const lang::NamedSignal& find(bool analog, int channel) const;

  lang::RobotSignature signature_;
  std::vector<lang::NamedSignal> signals_;  ///< by index in the signature
};

}  // namespace rob::runtime
