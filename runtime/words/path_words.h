#pragma once

#include <string>

#include "lang/values/pose_math.h"
#include "motion/plan/feasibility.h"
#include "motion/plan/planned_segment.h"
#include "motion/robots/robot_model.h"
#include "runtime/words/words.h"

/// Texts about faults of a tool's way, for people.
namespace rob::runtime {

/// The fault at a singular place; empty of None.
const char* words_for(motion::SingularPlace place);
/// A way that the axes cannot follow: what, where on it, what to do.
Words words_for_path(const motion::Refusal& refusal, const motion::RobotModel& robot);
/// AT asks for more than the axes can do there.
Words words_for_pace_cut(const motion::PaceCut& cut, const motion::RobotModel& robot);
/// The tool would turn by 180°.
Words words_for_half_turn();
/// Points through which there is no arc, no spline; a plane in which the frame shows no x axis.
Words words_for_no_arc();
Words words_for_no_spline();
Words words_for_no_joint_spline();
Words words_for_no_spiral();
/// MOVEL … EULER with b, rad, near ±90° at its beginning or its end.
Words words_for_steep_line(bool beginning, double b);
/// ", its wrist would have to be 65 mm farther out than it reaches"; empty where lengths do not
/// tell.
std::string by_how_much(const motion::Shortfall& shortfall);
/// "; the nearest that it reaches is POSE(…)", to 0.1 mm and 0.01°.
std::string text_for_nearest(const lang::PoseValue& pose);

}  // namespace rob::runtime
