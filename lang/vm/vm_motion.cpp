#include <string>
#include <string_view>

#include <fmt/core.h>

#include "lang/text/codes.h"
#include "lang/values/number_text.h"
#include "lang/vm/vm.h"

/// Member functions of Vm that put motions together from registers.
namespace rob::lang {
namespace {

Dimension dimension_of(MoveCommand::Pace pace) {
  switch (pace) {
    case MoveCommand::Pace::ToolSpeed:
      return kSpeed;
    case MoveCommand::Pace::AngularSpeed:
      return kAngularSpeed;
    default:
      return kNone;
  }
}

Dimension dimension_of(MoveCommand::Zone zone) {
  switch (zone) {
    case MoveCommand::Zone::Length:
      return kLength;
    case MoveCommand::Zone::Time:
      return kTime;
    default:
      return kNone;
  }
}

}  // namespace

bool Vm::build(Code pc, MoveCommand& command) {
  const MoveForm& form = chunk_->moves[pc->x()];
  const Slot* next = &numbers_[pc->a()];
  command.kind = form.kind;
  command.jog = form.jog;
  command.means = form.means;
  command.in_frame = form.in_frame;
  command.relative = form.relative;
  command.count = form.count;
  command.given = form.given;
  if (form.computed_axis && !choose_axis(pc, *next++, command)) return false;
  for (std::size_t i = 0; i < static_cast<std::size_t>(form.count); ++i) {
    if ((command.given >> i & 1) != 0) command.target[i] = (next++)->real;
  }
  if (form.kind == MotionKind::Spiral) {
    command.radius = (next++)->real;
    command.turns = (next++)->real;
    if (!check_positive(pc, "FROM", command.radius, kLength) ||
        !check_positive(pc, "TURNS", command.turns, kNone)) {
      return false;
    }
  }
  return build_clauses(pc, form, next, command);
}

MoveCommand Vm::build_plain(Code pc) const {
  const MoveForm& form = chunk_->moves[pc->x()];
  MoveCommand command{.kind = form.kind, .count = form.count, .given = form.given};
  Code next = pc + 1;
  for (int i = 0; i < form.count; ++i) {
    if (!command.has(i)) continue;
    command.target[static_cast<std::size_t>(i)] = real_at(next);
    next += 2;
  }
  return command;
}

bool Vm::choose_axis(Code pc, Slot axis, MoveCommand& command) {
  if (axis.integer >= 1 && axis.integer <= command.count) {
    command.given = static_cast<std::uint8_t>(1U << static_cast<unsigned>(axis.integer - 1));
    return true;
  }
  error_ = {.code = std::string(code::kAxisOutOfRange),
            .place = place(pc),
            .message = fmt::format("the robot has axes 1 to {}; here axis {} is asked for",
                                   command.count, axis.integer),
            .help = ""};
  return false;
}

bool Vm::build_clauses(Code pc, const MoveForm& form, const Slot* next, MoveCommand& command) {
  command.fine = form.fine;
  command.euler = form.euler;
  command.profile = form.profile;
  command.pace = form.pace;
  if (form.pace != MoveCommand::Pace::Unspecified) {
    command.pace_value = (next++)->real;
    if (!check_positive(pc, "AT", command.pace_value, dimension_of(form.pace))) return false;
  }
  if (form.over) {
    command.over = (next++)->real;
    if (!check_positive(pc, "OVER", command.over, kTime)) return false;
  }
  command.accel = form.accel;
  if (form.accel != MoveCommand::Bound::Unspecified) {
    command.accel_value = (next++)->real;
    const bool tool = form.accel == MoveCommand::Bound::Tool;
    if (!check_positive(pc, "ACCEL", command.accel_value,
                        tool ? kAcceleration : kAngularAcceleration)) {
      return false;
    }
  }
  command.jerk = form.jerk;
  if (form.jerk != MoveCommand::Bound::Unspecified) {
    command.jerk_value = (next++)->real;
    const bool tool = form.jerk == MoveCommand::Bound::Tool;
    if (!check_positive(pc, "JERK", command.jerk_value, tool ? kJerk : kAngularJerk)) return false;
  }
  command.zone = form.zone;
  if (form.zone != MoveCommand::Zone::Unspecified) {
    command.zone_value = (next++)->real;
    if (!check_zone(pc, command.zone_value, dimension_of(form.zone))) return false;
  }
  if (form.zone_angle) {
    command.zone_angle = (next++)->real;
    if (!check_positive(pc, "the angle of ZONE", command.zone_angle, kAngle)) return false;
  }
  if (form.fine_within) {
    command.fine_within = (next++)->real;
    if (!check_positive(pc, "FINE", command.fine_within, kLength)) return false;
  }
  if (!form.lasts) return true;
  command.lasts = next->real;
  return check_positive(pc, "FOR", command.lasts, kTime);
}

bool Vm::check_zone(Code pc, double value, Dimension dimension) {
  if (value >= 0) return true;
  error_ = {.code = std::string(code::kClauseOutOfRange),
            .place = place(pc),
            .message = fmt::format("ZONE turned out to be {}; it has to be zero or more",
                                   number_text(value, dimension)),
            .help = ""};
  return false;
}

bool Vm::check_positive(Code pc, std::string_view word, double value, Dimension dimension) {
  if (value > 0) return true;
  const bool pace = word == "AT" || word == "OVER";
  error_ = {.code = std::string(pace ? code::kPaceNotPositive : code::kClauseOutOfRange),
            .place = place(pc),
            .message = fmt::format("{} turned out to be {}; it has to be above zero", word,
                                   number_text(value, dimension)),
            .help = ""};
  return false;
}

}  // namespace rob::lang
