#pragma once

#include <string>

#include "lang/values/arithmetic.h"
#include "lang/values/pose_math.h"
#include "motion/collision/clearance.h"
#include "motion/generate/position_error.h"
#include "motion/plan/feasibility.h"
#include "motion/robots/robot_model.h"
#include "motion/servo/following_supervisor.h"
#include "runtime/words/words.h"

/// Everything motion reports by numbers, in words for people: motion knows neither lines nor texts.
namespace rob::runtime {

/// "axis x: 9000 mm is beyond 400 mm".
Words words_for(const motion::Refusal& refusal, const motion::RobotModel& robot);
/// A WAIT for a time that motion control does not count to.
Words words_for_long_wait(double seconds);
/// A condition that is looked at in every control cycle could not be computed.
Words words_for_condition(lang::ArithmeticError error);
/// A pose that the robot cannot bring its tool to.
/// `shortfall`: by how much. `nearest`: where it could be instead, if known.
Words words_for_unreachable(const motion::RobotModel& robot, const lang::PoseValue& pose,
                            const motion::Shortfall& shortfall,
                            const std::optional<lang::PoseValue>& nearest);
/// The same where a turn is left open.
Words words_for_unreachable(const motion::RobotModel& robot, const lang::PoseValue& pose,
                            motion::Freedom free);
/// A whole pose for a robot whose place decides c, which would be `c` there, rad.
Words words_for_other_c(const motion::RobotModel& robot, const lang::PoseValue& pose, double c);
/// More SIMULATEs wait for their time than there is room for.
Words words_for_many_simulations();
/// HALT or ASK where nobody will ever answer.
Words words_for_nobody(const char* what);
/// HOLD of a signal script that has no further GO and no STOP.
Words words_for_endless_hold();
/// A path event that lies beyond its motion, m.
Words words_for_place(double distance, double way);
/// More places on one motion than it can have; a PATH of more motions than can be planned as one.
Words words_for_many_places(std::size_t most);
Words words_for_long_path(std::size_t most);
/// "axis x is 2.1 mm off its reference; 2 mm are permitted here".
/// `of_machine`: what the machine itself says about it (Channels::of_machine), "what is wrong; the
/// remedy"; empty: nothing.
Words words_for(const motion::FollowingFinding& finding, const motion::RobotModel& robot,
                const std::string& of_machine = "");
/// Why a jog goes no further: the axis that ends near `place`, m or rad; axis −1: none
/// does. `bodies`: those that the jog heeds, or null.
std::string text_for_stopped_jog(int axis, double place, const motion::RobotModel& robot,
                                 const motion::Clearance* bodies);
/// A path event that came too early by so many s; below 0: too late.
std::string text_for_missed_lead(double error);
/// `late`: s by which the event comes later than its LEAD asks for.
Words words_for_cut_lead(double late);
/// The motion task was so late that the path could not be made up.
Words words_for_overrun(double lateness);
/// A reference that is no number was about to be sent.
Words words_for_not_finite(int axis, const motion::RobotModel& robot);

/// An exact motion after which the robot has not come into position in time.
Words words_for_unsettled(const motion::PositionError& off, const motion::RobotModel& robot);
/// Where `rob check` foretells the reference's time, and the robot may take longer.
lang::Diagnostic note_on_settling();

/// ROBOT names a robot that is not carried along; or another one than --robot.
Words words_for_unknown_robot(const std::string& name);
Words words_for_other_robot(const std::string& declared, const std::string& asked);

}  // namespace rob::runtime
