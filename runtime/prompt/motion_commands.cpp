#include "runtime/prompt/motion_commands.h"

#include <fmt/format.h>

#include "runtime/command/signal_access.h"
#include "runtime/prompt/session.h"
#include "runtime/prompt/wizard_commands.h"
#include "runtime/words/arguments.h"
#include "runtime/words/signature.h"
#include "runtime/words/units.h"

namespace rob::runtime::command {

namespace {

std::string pose_text(const std::vector<double>& pose) {
  return fmt::format("POSE({}mm, {}mm, {}mm, {}deg, {}deg, {}deg)", shown(pose[0], 3),
                     shown(pose[1], 3), shown(pose[2], 3), shown(pose[3], 3), shown(pose[4], 3),
                     shown(pose[5], 3));
}

}  // namespace

void where(Session& session, const Words&) {
  const LiveRobot& live = session.robot();
  const auto& last = live.reports().last();
  const motion::RobotModel& robot = live.robot();
  const motion::JointVector q = last ? last->measured : robot.start;
  session.screen().result(fmt::format("{}\n{}\n", axes_text(robot, q),
                                      pose_text(shown_pose(robot.kinematics->forward(q)))));
}

void signals(Session& session, const Words&) {
  const Channels& channels = session.robot().channels();
  for (const auto& signal : signature_of(session.robot().robot()).signals) {
    const std::string value = signal.analog
                                  ? fmt::format("{} V", shown(analog_value(channels, signal), 3))
                                  : (digital_value(channels, signal) ? "ON" : "OFF");
    session.screen().result(fmt::format("  {:<16} {:<6} {}\n", shown_name(signal),
                                        signal.output ? "out" : "in", value));
  }
}

void override_speed(Session& session, const Words& words) {
  LiveRobot& robot = session.robot();
  if (words.empty()) {
    return session.screen().result(fmt::format("{} %\n", shown(robot.override_share() * 100, 3)));
  }
  const auto share = override_of(words.front());
  if (!share) {
    return session.fail(
        fmt::format(":override takes a share from above 0% to 200%, not '{}'", words.front()),
        "for example :override 50%", ExitCode::Usage);
  }
  robot.set_override(*share);
}

void jog(Session& session, const Words&) {
  if (session.robot().held())
    return session.fail("the pendant needs a robot at rest; it is held", ":resume or :stop before");
  if (session.robot().reports().moves())
    return session.fail("the pendant needs a robot at rest", ":stop before");
  session.ask_for_pendant();
}

void hold(Session& session, const Words&) { session.robot().pause(true); }

void resume(Session& session, const Words&) {
  if (session.robot().paused()) {
    session.robot().channels().hold_points.hold_at_each(false);
    return session.robot().pause(false);
  }
  if (!session.asks()) return session.screen().message("nothing is held\n");
  session.answer("");
}

/// Where nothing moves it leaves what asks for positions.
void stop(Session& session, const Words&) {
  if (session.robot().idle()) leave_wizard(session);
  session.stop();
}

void reset(Session& session, const Words&) { session.reset(); }

void guide(Session& session, const Words& words) {
  if (words.size() != 1 || (words[0] != "on" && words[0] != "off"))
    return session.fail(":guide takes on or off", "", ExitCode::Usage);
  const LiveRobot& robot = session.robot();
  if (!robot.sees_hand())
    return session.fail("this machine counts its own steps: where a hand brings it is not seen",
                        ":jog brings it to the points that are to be taught", ExitCode::Usage);
  if (robot.over() || robot.guided() || session.stands(":guide")) session.guide(words[0] == "on");
}

void home(Session& session, const Words&) {
  if (session.robot().simulated())
    return session.fail("the simulation knows where it stands", ":home is for a machine");
  if (session.robot().over() || session.stands(":home")) session.home();
}

void robot(Session& session, const Words& words) {
  if (!words.empty()) {
    if (session.stands(":robot")) session.choose_robot(words.front(), std::nullopt);
    return;
  }
  const motion::RobotModel& model = session.robot().robot();
  session.screen().result(fmt::format("{}, law {}\n", model.name, motion::law_name(model.law)));
}

void law(Session& session, const Words& words) {
  if (words.empty()) {
    const std::string_view name = motion::law_name(session.robot().robot().law);
    return session.screen().result(fmt::format("{}\n", name));
  }
  if (words.size() != 1 || (words[0] != "paul" && words[0] != "lookahead")) {
    return session.fail(":law takes paul or lookahead", "", ExitCode::Usage);
  }
  if (!session.stands(":law")) return;
  session.choose_robot(session.chosen_robot(),
                       words[0] == "paul" ? motion::Law::Paul : motion::Law::LookAhead);
}

}  // namespace rob::runtime::command
