#include "runtime/command/robot_machine.h"

#include <utility>

#include <fmt/format.h>

#include "runtime/words/codes.h"
#include "runtime/words/units.h"

/// Member functions of RobotMachine for what surrounds motions: WITH, IN, OVERRIDE and LOAD.
namespace rob::runtime {

using lang::Reply;

namespace {

Eigen::Vector3d eigen_of(const lang::Vector3& place) { return {place.x, place.y, place.z}; }

}  // namespace

/// The tool's mass counts from the next motion on.
void RobotMachine::work_in(int /*line*/, const lang::Setting& setting) {
  setting_ = setting;
  loads_.mount(motion::ArmLoad::point(setting.tool.mass, eigen_of(setting.tool.cog)));
  const auto& [place, turn] = setting.tool.tip;
  planner_.set_tool({Eigen::Vector3d(place.x, place.y, place.z),
                     Eigen::Quaterniond(turn.w, turn.i, turn.j, turn.k)});
}

bool RobotMachine::tip_jumps() const {
  using lang::pose_math::operator-;
  constexpr double kSamePlace = 1e-9;  // m; [choice] far above rounding
  const double jump = lang::pose_math::length(setting_.tool.tip.position - moved_tip_);
  return !exact_ && jump > kSamePlace;
}

bool RobotMachine::stop_for_tool(int line) {
  using lang::pose_math::operator-;
  const bool jumps = tip_jumps();
  if (jumps) {
    const double jump = lang::pose_math::length(setting_.tool.tip.position - moved_tip_);
    log_.found(
        {lang::Severity::Warning, code::kToolJumps, lang::tagged_place(line),
         fmt::format("another tool begins here, whose tip is {} away: the target of line {}"
                     " is reached exactly",
                     shown(jump, motion::AxisKind::Linear), lang::tagged_place(line_before_).line),
         "FINE at the target before, or STOP, says so in the program"});
    const bool guarded = std::exchange(guarded_, false);  // it belongs to the motion before
    if (const auto segment = planner_.stop(static_cast<motion::Tag>(line))) queue(*segment, true);
    guarded_ = guarded;
  }
  moved_tip_ = setting_.tool.tip.position;
  return jumps;
}

void RobotMachine::set_override(double share) {
  operators_override_ = share;
  planner_.set_override(share);
}

/// Up to 1 it is an effect in motion order, which slows the path's time; above, the planner raises
/// what is commanded from here on.
Reply RobotMachine::override_speed(int line, double share) {
  if (buffer_.effects_full()) return Reply::Later;
  motion::Effect effect;
  effect.tag = static_cast<motion::Tag>(line);
  effect.kind = motion::Effect::Kind::Override;
  effect.share = operators_override_ * share;
  const Reply reply = queue(effect);
  if (reply == Reply::Done) planner_.set_override(effect.share);
  return reply;
}

/// Of a handler the load is the program's, too, which learns of it when it goes on.
Reply RobotMachine::carry(int line, const lang::LoadCommand& load) {
  if (!load_is_known()) return Reply::Later;
  loads_.grasp(motion::ArmLoad::point(load.mass, eigen_of(load.cog)));
  const Reply reply = tell_load(line);
  if (reply == Reply::Done && errand_) errand_->program->loads_.doubt();
  return reply;
}

/// Where what was said may not have become true it shows when all that was commanded has acted.
bool RobotMachine::load_is_known() {
  if (!loads_.doubted()) return true;
  if (!has_acted()) return false;
  loads_.take_up(channels_.carried.load(std::memory_order_acquire));
  planner_.carry(loads_.told().all());
  return true;
}

/// In a PATH, which is planned as one, nothing changes.
Reply RobotMachine::tell_load(int line) {
  if (collecting()) return Reply::Done;
  if (!load_is_known()) return Reply::Later;
  if (!loads_.news()) return Reply::Done;
  if (buffer_.effects_full()) return Reply::Later;
  motion::Effect effect;
  effect.tag = static_cast<motion::Tag>(line);
  effect.kind = motion::Effect::Kind::Load;
  effect.carried = loads_.tell();
  planner_.carry(effect.carried->all());
  return queue(effect);
}

}  // namespace rob::runtime
