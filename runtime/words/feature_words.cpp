#include "runtime/words/feature_words.h"

#include <fmt/format.h>

#include "motion/plan/capability.h"
#include "runtime/words/codes.h"

namespace rob::runtime {

using lang::MotionFeature;
using motion::Capability;

namespace {

/// A feature as the program writes it, why it is not there, and what to do instead.
struct Explained {
  Capability capability;
  const char* word;
  const char* reason;
  const char* help;
};

Explained explained(MotionFeature feature) {
  switch (feature) {
    case MotionFeature::Accel:
      return {Capability::AccelerationBound, "ACCEL",
              "under Paul's law the acceleration follows from the time of a corner",
              "a greater ZONE, for example ZONE 2s, turns more gently; LAW LOOKAHEAD has ACCEL"};
    case MotionFeature::Jerk:
      return {Capability::JerkBound, "JERK",
              "under Paul's law the jerk follows from the time of a corner",
              "a greater ZONE, for example ZONE 2s, turns more gently; LAW LOOKAHEAD has JERK"};
    case MotionFeature::Path:
      return {
          Capability::Path, "PATH", "under Paul's law each corner is planned by itself",
          "LAW LOOKAHEAD has PATH; without it leave PATH and ENDPATH out: AFTER and BEFORE stand "
          "after MOVE … DO"};
    case MotionFeature::Press:
      return {Capability::Force, "PRESS", "it has no force sensor",
              "MOVE … UNTIL touched stops where something is met"};
    case MotionFeature::FreeC:
      return {Capability::TurnAboutZ, "FREE c", "none of its axes turns the tool about z",
              "leave FREE out: the tool keeps its turn on this robot"};
    case MotionFeature::FreeSpin:
      return {Capability::TurnAboutZ, "FREE SPIN", "none of its axes turns the tool about its z",
              "leave FREE out: the tool keeps its turn on this robot"};
    case MotionFeature::Lead:
      break;
  }
  return {
      Capability::Lead, "leading the tool", "it is commanded in its axes alone",
      "MOVE (…) with a value for each axis, MOVE JOINT, MOVE to a taught point and JOG JOINT are "
      "there; FORWARD(j) says where joints bring the tool"};
}

}  // namespace

Words words_for(MotionFeature feature, const motion::RobotModel& robot) {
  const Explained what = explained(feature);
  const bool turn = what.capability == Capability::TurnAboutZ;
  return {turn ? code::kNothingTurns : code::kNotPossible,
          fmt::format("{} is not possible on {}: {}", what.word, robot.name, what.reason),
          what.help};
}

std::optional<Words> words_against(MotionFeature feature, const motion::RobotModel& robot) {
  if (motion::can(robot, explained(feature).capability)) return std::nullopt;
  return words_for(feature, robot);
}

Words words_against_paul(const motion::RobotModel& robot) {
  return {code::kNotPossible,
          fmt::format("Paul's law is not possible on {}: its file gives no t_acc", robot.name),
          "LAW LOOKAHEAD needs none; or give the robot file a t_acc"};
}

}  // namespace rob::runtime
