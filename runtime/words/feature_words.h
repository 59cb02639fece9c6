#pragma once

#include <optional>

#include "lang/machine/motion_words.h"
#include "motion/robots/robot_model.h"
#include "runtime/words/words.h"

namespace rob::runtime {

/// That this robot cannot do what a program asks for, why, and what to do instead.
Words words_for(lang::MotionFeature feature, const motion::RobotModel& robot);

/// Why this robot cannot do what a program asks for; nothing if it can.
std::optional<Words> words_against(lang::MotionFeature feature, const motion::RobotModel& robot);

/// Why a robot cannot be run under Paul's law.
Words words_against_paul(const motion::RobotModel& robot);

}  // namespace rob::runtime
