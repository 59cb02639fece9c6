#pragma once

#include "motion/robots/robot_model.h"
#include "motion/servo/following_supervisor.h"
#include "runtime/words/words.h"

/// Texts about forces, for people.
namespace rob::runtime {

/// PRESS where nothing was met within its reach, m; or, `again`, where what was pressed on is gone.
Words words_for_no_contact(double reach, bool again);
/// ZERO force in a PRESS.
Words words_for_zero_in_press();
/// PRESS where an axis or the arm ended before anything was met.
Words words_for_press_at_end(bool again);
/// A motion in a PRESS that moves along its axis.
Words words_for_motion_against_press();
/// PRESS with a force of nothing, or of less than `least`, N, that the sensor resolves; with one
/// that the robot stops for, N; in a handler, or in another PRESS.
Words words_for_press_of_nothing(double least);
Words words_for_press_too_hard(double force, double limit);
Words words_for_press_in_press();
Words words_for_press_in_handler();
/// SIMULATE of a force along what is no axis of the world.
Words words_for_oblique_force();
/// force or torque of a machine whose sensor has said nothing.
Words words_for_no_sensor(const motion::RobotModel& robot);
/// AT LIVE whose computation has no result.
Words words_for_no_pace();

/// A force that is too great, or a sensor that has stopped telling.
Words words_for_force(const motion::FollowingFinding& finding, const motion::RobotModel& robot);

}  // namespace rob::runtime
