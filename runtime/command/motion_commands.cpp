#include "runtime/command/motion_commands.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "runtime/command/path_events.h"
#include "runtime/words/codes.h"
#include "runtime/words/feature_words.h"
#include "runtime/words/path_words.h"
#include "runtime/words/units.h"

namespace rob::runtime {

using lang::MotionKind;
using lang::Reply;

namespace {

/// [choice] as many as the longest buffer holds; 60 MB
constexpr std::size_t kMostInPath = 16384;

}  // namespace

/// The tool's mass counts from the next motion on.
void MotionCommands::work_in(const lang::Setting& setting) {
  surroundings_.work_in(setting);
  loads_.mount(setting.tool);
}

/// An exact target takes two segments, which are queued together. In a PATH places wait for its
/// end.
Reply MotionCommands::move(int line, const lang::MoveCommand& asked) {
  if (const Reply reply = tell_load(line); reply != Reply::Done) return reply;
  if (asked.kind == MotionKind::Jog) return jog(line, asked);
  if (!queue_.rested()) return Reply::Later;
  const bool collecting = queue_.collecting();
  const std::size_t needed = (asked.exact() ? 2U : 1U) + (tip_jumps() ? 1U : 0U);
  if (!collecting && queue_.room() < needed) return Reply::Later;
  if (collecting && queue_.path_motions().size() >= kMostInPath)
    return links_.refuse(words_for_long_path(kMostInPath));
  const bool stopped = stop_for_tool(line);
  Commanded commanded{{}, false, stopped, asked, surroundings_.setting(), loads_.last()};
  if (!collecting) commanded.events = next_.take_events();
  commanded.via = next_.take_via();
  commanded.live = next_.take_live();
  if (auto words = plans_.plan(line, commanded)) return links_.refuse(std::move(*words));
  if (!collecting) commanded.along.reset();
  for (std::size_t i = 0; i < commanded.events.size(); ++i) links_.log.queued_effect();
  queue_.add_motion(line, std::move(commanded));
  return Reply::Done;
}

/// A jog begins at rest, or joins one before it. Its end is known only after the axes have come to
/// rest; before that only another JOG may follow.
Reply MotionCommands::jog(int line, const lang::MoveCommand& asked) {
  queue_.rested();
  if (queue_.room() < 2) return Reply::Later;
  const auto exact = links_.planner.stop(static_cast<motion::Tag>(line));
  if (exact) queue_.add(*exact, true);
  Commanded commanded{{}, false, exact.has_value(), asked, surroundings_.setting(), {}};
  commanded.clearance = plans_.clearance(commanded.setting);
  if (auto words = plans_.plan_jog(line, asked, commanded.segment))
    return links_.refuse(std::move(*words));
  queue_.move_tip(surroundings_.setting().tool.tip.position);
  queue_.add_brakable(std::move(commanded));
  return Reply::Done;
}

Reply MotionCommands::jog_while(int line, const lang::MoveCommand& command,
                                const motion::Watch& held) {
  guard_.hold(held);
  const Reply reply = jog(line, command);
  guard_.release(reply == Reply::Done);
  return reply;
}

/// Whether the tool has been changed in a corner, so that its tip would jump there.
bool MotionCommands::tip_jumps() const {
  using lang::pose_math::operator-;
  constexpr double kSamePlace = 1e-9;  // m; [choice] far above rounding
  const lang::Vector3 jump = surroundings_.setting().tool.tip.position - queue_.moved_tip();
  return !progress_.exact() && lang::pose_math::length(jump) > kSamePlace;
}

/// Then the target before is reached exactly; whether it had to be.
bool MotionCommands::stop_for_tool(int line) {
  using lang::pose_math::operator-;
  const lang::Vector3 tip = surroundings_.setting().tool.tip.position;
  const bool jumps = tip_jumps();
  if (jumps) {
    const double jump = lang::pose_math::length(tip - queue_.moved_tip());
    links_.log.found(
        {lang::Severity::Warning, code::kToolJumps, lang::tagged_place(line),
         fmt::format("another tool begins here, whose tip is {} away: the target of line {}"
                     " is reached exactly",
                     shown(jump, motion::AxisKind::Linear),
                     lang::tagged_place(plans_.last_line()).line),
         "FINE at the target before, or STOP, says so in the program"});
    const bool guarded = guard_.switch_off();  // it belongs to the motion before
    if (const auto segment = links_.planner.stop(static_cast<motion::Tag>(line)))
      queue_.add(*segment, true);
    guard_.switch_to(guarded);
  }
  queue_.move_tip(tip);
  return jumps;
}

/// In a PATH, which is planned as one, nothing changes.
Reply MotionCommands::tell_load(int line) {
  return queue_.collecting() ? Reply::Done : loads_.tell(line);
}

Reply MotionCommands::carry(int line, const lang::LoadCommand& load) {
  if (!loads_.known()) return Reply::Later;
  loads_.grasp(load);
  return tell_load(line);
}

/// Its motions are planned one by one and kept until its end. Then places are laid along the whole
/// path, and it is queued. Until then nothing of it moves.
Reply MotionCommands::begin_path(int line) {
  if (auto words = words_against(lang::MotionFeature::Path, links_.robot))
    return links_.refuse(std::move(*words));
  if (!queue_.rested() || tell_load(line) == Reply::Later) return Reply::Later;
  queue_.open_path();
  return Reply::Done;
}

Reply MotionCommands::end_path(int /*line*/) {
  if (queue_.collecting()) {
    if (auto words = lay_places()) {
      queue_.drop_path();
      return links_.refuse(std::move(*words));
    }
    queue_.close_path();
  }
  return queue_.send_path() ? Reply::Done : Reply::Later;
}

std::optional<Words> MotionCommands::lay_places() {
  if (auto words = share_out(next_.take_events(), queue_.path_motions())) return words;
  for (Commanded& one : queue_.path_motions()) {
    for (std::size_t i = 0; i < one.events.size(); ++i) links_.log.queued_effect();
    if (auto words = lay_events(one)) return words;
  }
  return std::nullopt;
}

/// The motion is made exact; its Rest says how it ended.
Reply MotionCommands::ended(int line, bool& hit) {
  if (!progress_.exact() && !progress_.jogging()) {
    if (queue_.full()) return Reply::Later;
    if (const auto segment = links_.planner.stop(static_cast<motion::Tag>(line)))
      queue_.add(*segment, true, true);
  }
  motion::Rest rest;
  if (!take_end(rest)) return Reply::Later;
  guard_.switch_to(false);
  queue_.bar_brake();
  if (rest.early()) {
    queue_.restart_from(rest.q);
  } else if (progress_.jogging()) {
    queue_.come_to_rest(rest.q);
  }
  guard_.set_hit(rest.early()       ? rest.trip_q
                 : press_.present() ? links_.channels.joints.load()
                                    : rest.q);
  hit = rest.outcome == motion::Rest::Outcome::Hit;
  if (rest.outcome != motion::Rest::Outcome::Failed) return Reply::Done;
  return links_.refuse(words_for_condition(guard_.error()));
}

bool MotionCommands::take_end(motion::Rest& rest) {
  if (auto left = guard_.take_left()) {
    rest = *left;
    return true;
  }
  return queue_.take_end(rest);
}

std::optional<Words> MotionCommands::plan_anew(std::deque<Commanded>& commanded) {
  for (Commanded& one : commanded)
    if (auto words = plan_one_anew(one)) return words;
  if (!queue_.path_open()) return std::nullopt;
  queue_.reopen_path();
  for (Commanded& one : queue_.path_motions())
    if (auto words = plan_one_anew(one)) return words;
  return std::nullopt;
}

std::optional<Words> MotionCommands::plan_one_anew(Commanded& commanded) {
  motion::SegmentDescriptor& segment = commanded.segment;
  const motion::Watch guard = segment.guard;
  const motion::SettleWindow settle = segment.settle;
  const int line = static_cast<int>(segment.tag);
  if (commanded.move) {
    work_in(commanded.setting);
    links_.planner.carry(commanded.carried == nullptr ? motion::ArmLoad{}
                                                      : commanded.carried->all());
    if (auto words = plans_.plan(line, commanded)) {
      words->message = fmt::format("the motion of line {} starts from elsewhere after BRAKE: {}",
                                   lang::tagged_place(line).line, words->message);
      return words;
    }
    if (!queue_.collecting()) commanded.along.reset();
  } else {
    const auto stop = segment.dwell ? std::nullopt : links_.planner.stop(segment.tag);
    // Where the axes stand already the number is taken all the same.
    segment =
        stop ? *stop : links_.planner.dwell(segment.tag, segment.dwell ? segment.duration : 0);
  }
  segment.guard = guard;
  segment.settle = settle;
  return std::nullopt;
}

}  // namespace rob::runtime
