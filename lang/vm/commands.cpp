#include "lang/vm/commands.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "lang/machine/move_pose.h"
#include "lang/text/codes.h"
#include "lang/values/number_text.h"
#include "lang/values/percent_text.h"
#include "lang/values/pose_slots.h"

namespace rob::lang {
namespace {

Refusal because(std::string_view code, std::string message, std::string help = "") {
  return {.code = std::string(code), .message = std::move(message), .help = std::move(help)};
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

Dimension dimension_of(MoveCommand::Bound bound, Dimension tool, Dimension rotary) {
  if (bound == MoveCommand::Bound::Share) return kNone;
  return bound == MoveCommand::Bound::Tool ? tool : rotary;
}

/// The dimension of a component. That of a rate is meant without its time, which changes no number.
Dimension dimension_of(const MoveForm& form, int component) {
  const unsigned bit = 1U << static_cast<unsigned>(component);
  return (form.lengths & bit) != 0 ? kLength : (form.angles & bit) != 0 ? kAngle : kNone;
}

/// The values of a motion, in the order of their registers. The first that is impossible is kept.
class MoveValues {
 public:
  explicit MoveValues(const Slot* first) : next_(first) {}

  /// In SI.
  double any(Dimension dimension) { return to_si((next_++)->real, dimension); }

  double positive(std::string_view word, Dimension dimension) {
    const double value = any(dimension);
    if (value > 0) return value;
    const bool pace = word == "AT" || word == "OVER";
    object(pace ? code::kPaceNotPositive : code::kClauseOutOfRange,
           fmt::format("{} turned out to be {}; it must be above zero", word,
                       si_text(value, dimension)));
    return value;
  }

  double zone(Dimension dimension) {
    const double value = any(dimension);
    if (value >= 0) return value;
    object(code::kClauseOutOfRange, fmt::format("ZONE turned out to be {}; it must be zero or more",
                                                si_text(value, dimension)));
    return value;
  }

  /// One of `count` axes, as MoveCommand::given.
  std::uint8_t axis(int count) {
    const std::int64_t axis = (next_++)->integer;
    if (axis >= 1 && axis <= count) {
      return static_cast<std::uint8_t>(1U << static_cast<unsigned>(axis - 1));
    }
    object(code::kAxisOutOfRange,
           fmt::format("the robot has axes 1 to {}; here axis {} is asked for", count, axis));
    return 0;
  }

  Objection objection() { return std::move(objection_); }

 private:
  void object(std::string_view code, std::string message) {
    if (!objection_) objection_ = because(code, std::move(message));
  }

  const Slot* next_;
  Objection objection_;
};

void take_bounds(const MoveForm& form, MoveValues& values, MoveCommand& command) {
  using Bound = MoveCommand::Bound;
  command.accel = form.accel;
  if (form.accel != Bound::Unspecified) {
    command.accel_value =
        values.positive("ACCEL", dimension_of(form.accel, kAcceleration, kAngularAcceleration));
  }
  command.jerk = form.jerk;
  if (form.jerk != Bound::Unspecified) {
    command.jerk_value = values.positive("JERK", dimension_of(form.jerk, kJerk, kAngularJerk));
  }
}

void take_clauses(const MoveForm& form, MoveValues& values, MoveCommand& command) {
  command.fine = form.fine;
  command.live = form.live;
  command.euler = form.euler;
  command.free = form.free;
  command.free_axis = form.free_axis;
  command.profile = form.profile;
  command.pace = form.pace;
  if (form.pace != MoveCommand::Pace::Unspecified) {
    command.pace_value = values.positive("AT", lang::dimension_of(form.pace));
  }
  if (form.over) command.over = values.positive("OVER", kTime);
  take_bounds(form, values, command);
  command.zone = form.zone;
  if (form.zone != MoveCommand::Zone::Unspecified) {
    command.zone_value = values.zone(dimension_of(form.zone));
  }
  if (form.zone_angle) command.zone_angle = values.positive("the angle of ZONE", kAngle);
  if (form.fine_within) command.fine_within = values.positive("FINE", kLength);
  if (form.lasts) command.lasts = values.positive("FOR", kTime);
  if (form.near == 0) return;
  command.near.emplace();
  for (std::size_t i = 0; i < form.near; ++i)
    (*command.near)[i] = values.any((form.near_lengths >> i & 1U) != 0 ? kLength : kAngle);
}

Objection check_override(double share) {
  if (share > 0 && share <= kMostOverride) return {};
  return because(code::kOverrideBeyond,
                 fmt::format("OVERRIDE turned out to be {}; it is above 0% and at most 200%",
                             percent_text(share)),
                 std::string(override_help(share)));
}

Objection check_wait(double seconds) {
  if (seconds >= 0) return {};
  return because(code::kWaitNegative,
                 fmt::format("WAIT turned out to be for {}", number_text(seconds, kTime)),
                 "a time to wait is 0s or more");
}

Objection check_pulse(double seconds) {
  if (seconds > 0 && seconds <= kLongestPulse) return {};
  return because(
      code::kPulseTime, fmt::format("PULSE turned out to be for {}", number_text(seconds, kTime)),
      fmt::format("a pulse takes more than 0s and at most {}", number_text(kLongestPulse, kTime)));
}

Objection check_after(double seconds) {
  if (seconds >= 0) return {};
  return because(code::kAfterNegative,
                 fmt::format("AFTER turned out to be {}", number_text(seconds, kTime)),
                 "SIMULATE acts now or later");
}

}  // namespace

Objection build_move(const MoveForm& form, const Slot* n, MoveCommand& command) {
  MoveValues values(n);
  command.kind = form.kind;
  command.jog = form.jog;
  command.means = form.means;
  command.in_frame = form.in_frame;
  command.relative = form.relative;
  command.count = form.count;
  command.given = form.computed_axis ? values.axis(form.count) : form.given;
  for (int i = 0; i < form.count; ++i) {
    if (!command.has(i)) continue;
    command.target[static_cast<std::size_t>(i)] = values.any(dimension_of(form, i));
  }
  if (form.kind == MotionKind::Spiral) {
    command.radius = values.positive("FROM", kLength);
    command.turns = values.positive("TURNS", kNone);
  }
  take_clauses(form, values, command);
  return values.objection();
}

Objection build_defaults(const MoveForm& form, const Slot* n, int line, MoveCommand& clauses) {
  clauses.pace_line = clauses.zone_line = clauses.accel_line = line;
  return build_move(form, n, clauses);
}

MoveCommand plain_move(const MoveForm& form, const Instruction* components) {
  MoveCommand command{.kind = form.kind, .count = form.count, .given = form.given};
  for (int i = 0; i < form.count; ++i) {
    if (!command.has(i)) continue;
    command.target[static_cast<std::size_t>(i)] = real_at(components);
    components += 2;
  }
  command.pace = form.pace;
  command.zone = form.zone;
  if (form.pace != MoveCommand::Pace::Unspecified) {
    command.pace_value = real_at(components);
    components += 2;
  }
  if (form.zone != MoveCommand::Zone::Unspecified) command.zone_value = real_at(components);
  return command;
}

Objection build_path_place(bool before, const Slot* n, const Place& written, PathPlace& place) {
  place = {.before = before,
           .distance = to_si(n[0].real, kLength),
           .lead = n[1].real,
           .written = written};
  if (place.distance >= 0 && std::abs(place.lead) <= kLongestLead) return {};
  return because(code::kPlaceUnsound,
                 fmt::format("a path event lies 0mm or more from the end of its motion, with at "
                             "most {}s of LEAD or LAG; this is {} and {}",
                             kLongestLead, si_text(place.distance, kLength),
                             number_text(std::abs(place.lead), kTime)));
}

Watch watch_of(const Chunk& chunk, const WatchForm& form, const Slot* n, const Setting& setting) {
  Watch watch;
  watch.chunk = &chunk;
  watch.form = form;
  std::copy_n(n, form.values, watch.values.begin());
  watch.setting = setting;
  watch.setting.allowed.reset();  // no watch asks for it
  return watch;
}

Setting setting_of(unsigned named, const Slot* n, Setting around) {
  if ((named & 1U) != 0) {
    around.tool = load_tool(n);
    n += kToolSlots;
  }
  if ((named & 2U) != 0) around.frame = to_si(load_pose(n));
  if ((named & 6U) != 0) around.in_tool = (named & 4U) != 0;
  return around;
}

Setting allowing(const std::vector<std::string>& bodies, Setting around) {
  std::vector<std::string> all = bodies;
  if (around.allowed) all.insert(all.end(), around.allowed->begin(), around.allowed->end());
  around.allowed = std::make_shared<const std::vector<std::string>>(std::move(all));
  return around;
}

Objection build_press(int axis, const Slot* n, PressCommand& command) {
  command = {.axis = axis, .force = to_si(n[0].real, kForce), .limit = to_si(n[1].real, kSpeed)};
  if (command.limit >= 0) return {};
  return because(code::kClauseOutOfRange,
                 fmt::format("LIMIT turned out to be {}; it must be above zero",
                             si_text(command.limit, kSpeed)));
}

Objection build_load(bool with_cog, const Slot* n, const Setting& setting, LoadCommand& load) {
  load = {n[0].real, with_cog ? to_si(load_vector(n + 1)) : setting.tool.tip.position};
  if (load.mass >= 0 && load.mass <= kMostLoad) return {};
  return because(code::kLoadBeyond,
                 fmt::format("LOAD turned out to be {}; it is 0kg or more and at most {}",
                             number_text(load.mass, kMass), number_text(kMostLoad, kMass)),
                 "LOAD 0kg lets go");
}

static std::vector<double> joints_in_si(const Chunk& chunk, std::span<const Slot> joints) {
  std::vector<double> in_si;
  for (const Slot& joint : joints) in_si.push_back(to_si(joint.real, axes_of(chunk)[in_si.size()]));
  return in_si;
}

TaughtPoint taught_point(const Chunk& chunk, const Instruction* teach, const Slot* n,
                         const Slot* joints, const Setting& setting) {
  const PoseValue& tip = setting.tool.tip;
  const auto tool =
      std::ranges::find_if(chunk.tools, [&](const NamedTool& one) { return one.tip == tip; });
  const bool named = has_tool(setting) && tool != chunk.tools.end();
  return {.name = chunk.texts[(teach + 1)->word],
          .frame = chunk.texts[(teach + 2)->word],
          .tool = named ? std::string_view(tool->name) : "",
          .pose = to_si(load_pose(n)),
          .tip = tip,
          .joints = joints_in_si(chunk, {joints, teach->c()})};
}

void take_kept(const TaughtPoint& point, const Chunk& chunk, Slot* pose, std::span<Slot> joints) {
  store(from_si(point.pose), pose);
  for (std::size_t i = 0; i < joints.size(); ++i)
    joints[i].real = from_si(point.joints.at(i), axes_of(chunk)[i]);
}

Objection check_group(Instruction command, std::uint32_t count, const Slot* n) {
  const std::int64_t most = (std::int64_t{1} << (count - 1)) - 1 + (std::int64_t{1} << (count - 1));
  if (n->integer < 0 || n->integer > most) {
    return because(code::kGroupBeyond,
                   fmt::format("{} does not fit into {} channels", n->integer, count),
                   fmt::format("they hold 0 to {}", most));
  }
  return command.opcode() == Opcode::simulate_group ? check_after(n[1].real) : Objection{};
}

Reply set_group(Machine& machine, int line, Instruction command, int count, const Slot* n) {
  for (int i = 0; i < count; ++i) {
    const bool bit = (n->integer >> i & 1) != 0;
    const int signal = command.x() + i;
    const Reply reply = command.opcode() == Opcode::write_group
                            ? machine.write_signal(line, signal, bit)
                            : machine.simulate(line, signal, bit ? 1 : 0, n[1].real);
    if (reply != Reply::Done) return reply;
  }
  return Reply::Done;
}

Objection check_command(Opcode opcode, const Slot* n) {
  switch (opcode) {
    case Opcode::set_override:
      return check_override(n->real);
    case Opcode::wait:
      return check_wait(n->real);
    case Opcode::pulse:
      return check_pulse(n->real);
    case Opcode::simulate:
    case Opcode::simulate_analog:
    case Opcode::simulate_force:
    case Opcode::simulate_go:
    case Opcode::simulate_answer:
    case Opcode::simulate_line:
      return check_after(n[1].real);
    default:
      return {};
  }
}

Reply tell(Machine& machine, const Place& at, Instruction command, const Slot* n,
           const std::string* t) {
  const int line = line_tag(at);
  switch (command.opcode()) {
    case Opcode::set_override:
      return machine.override_speed(line, n->real);
    case Opcode::stop:
      return machine.stop(line);
    case Opcode::brake:
      return machine.brake(line);
    case Opcode::wait:
      return machine.wait(line, n->real);
    case Opcode::waited:
      return machine.waited(line);
    case Opcode::zero_force:
      return machine.zero_force(line);
    case Opcode::write_signal:
      return machine.write_signal(line, command.x(), n->integer != 0);
    case Opcode::write_analog:
      return machine.write_analog(line, command.x(), n->real);
    case Opcode::pulse:
      return machine.pulse(line, command.x(), n->real);
    case Opcode::when_raise:
      return machine.when_raise(at, t[command.a()]);
    case Opcode::print:
      return machine.print(line, t[command.a()]);
    case Opcode::write:
      return machine.write(line, t[command.a()], t[command.b()]);
    case Opcode::halt:
      return machine.halt(line, t[command.a()]);
    case Opcode::expect_failed:
      return machine.expectation_failed(line, t[command.a()]);
    case Opcode::simulate:
      return machine.simulate(line, command.x(), n->integer != 0 ? 1 : 0, n[1].real);
    case Opcode::simulate_analog:
      return machine.simulate(line, command.x(), n->real, n[1].real);
    case Opcode::simulate_force:
      return machine.simulate_force(line, command.b(),
                                    to_si(n->real, command.b() < 3 ? kForce : kTorque), n[1].real);
    case Opcode::simulate_go:
      return machine.simulate_go(line, n->integer != 0, n[1].real);
    case Opcode::simulate_answer:
      return machine.simulate_answer(line, t[command.b()], n[1].real);
    default:  // `answer`: stands in code that is jumped over
      return Reply::Done;
  }
}

}  // namespace rob::lang
