#include "lang/compile/motion_compiler.h"

#include <bit>

#include "lang/check/fold.h"
#include "lang/compile/operations.h"
#include "lang/values/pose_slots.h"

namespace rob::lang {
namespace {

/// In a pose the first three components are lengths.
constexpr std::uint8_t kPlaceOfPose = 0b111;

/// Notes which components are lengths and which are angles.
void name_dimensions(const Coordinates& coordinates, MoveForm& form) {
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    std::uint8_t& kind = coordinates[i].dimension == kLength ? form.lengths : form.angles;
    kind = static_cast<std::uint8_t>(kind | 1U << i);
  }
}

}  // namespace

void MotionCompiler::compile(const Move& move, Place place) {
  enter(move.clauses.surroundings, place);
  compile_motion(move, place);
  leave(move.clauses.surroundings, place);
}

/// Whether a point's joints are where MOVE must go is decided when it comes to it: with another
/// tool, or in a frame that lies elsewhere now, it goes to the pose.
void MotionCompiler::compile_motion(const Move& move, Place place) {
  const Symbol* const point = bare_point(move);
  if (point == nullptr || (point->taught == nullptr && point->joints.empty())) {
    return compile_to(move, nullptr, place);
  }
  const CodeBuilder::Jumps by_pose = unless_at_joints(*point, *move.target, place);
  compile_to(move, point, place);
  const CodeBuilder::Jump done = code_.jump(place);
  code_.land(by_pose);
  compile_to(move, nullptr, place);
  code_.land(done);
}

/// The jumps taken where a point's joints are not known, or do not bring the tool of now to it.
CodeBuilder::Jumps MotionCompiler::unless_at_joints(const Symbol& point, const Expr& target,
                                                    Place place) {
  const auto mark = frame_.mark();
  CodeBuilder::Jumps jumps;
  const auto unless = [&](Register truth) {
    code_.emit(Opcode::if_bool, place, truth, 0);
    jumps.push_back(code_.jump(place));
  };
  if (point.taught != nullptr) unless(variables_.variable(*point.has_taught, place));
  MoveForm form;
  const Register same = frame_.number_registers();
  const Register joints = compile_taught(point, form, place);
  const auto count = static_cast<std::uint32_t>(form.count);
  code_.emit(Opcode::at_joints, place, same, joints, compile_value(target, form));
  code_.emit(Instruction{count}, place);
  unless(same);
  frame_.release(mark);
  return jumps;
}

/// To the joints of a point, if that is given.
void MotionCompiler::compile_to(const Move& move, const Symbol* taught, Place place) {
  for (const ExprPtr& point : move.via) compile_via(*point, place);
  const auto mark = frame_.mark();
  MoveForm form{.kind = move.kind, .relative = move.by};
  if (const Expr* const pace = live_pace(move.clauses)) compile_live(*pace);
  const Register first =
      taught != nullptr ? compile_taught(*taught, form, place) : compile_way(move, form);
  compile_clauses(move.clauses, form);
  if (move.clauses.free == FreeTurn::C) form.free_axis = frame_axis(move);
  code_.move(first, form, place);
  frame_.release(mark);
}

void MotionCompiler::compile(const PlainMotions& motions) {
  constexpr std::size_t kWordsOfReal = 2;
  const std::size_t count = motions.motions.size();
  code_.reserve(count, 1 + kWordsOfReal * motions.values.size() / count);
  auto values = motions.values.begin();
  for (const PlainMotions::Written& motion : motions.motions) {
    const MoveForm form{.kind = motion.kind,
                        .count = static_cast<int>(elements_.size()),
                        .given = motion.given,
                        .pace = motion.pace,
                        .zone = motion.zone};
    const auto end = values + plain_values(form);
    code_.move_to(form, {values, end}, motions.place(motion));
    values = end;
  }
}

void MotionCompiler::compile_via(const Expr& point, Place place) {
  const auto mark = frame_.mark();
  MoveForm form;
  const Register first = compile_target(point, form);
  code_.via(first, form, place);
  frame_.release(mark);
}

Register MotionCompiler::compile_way(const Move& move, MoveForm& form) {
  if (move.axis != nullptr) return compile_axis(move, form);
  if (move.kind == MotionKind::Jog) return compile_rates(move, form);
  if (move.kind != MotionKind::Spiral) return compile_target(*move.target, form);
  const Register radius = frame_.number_registers(2);
  expressions_.value_into(*move.radius, radius);
  expressions_.value_into(*move.turns, static_cast<Register>(radius + 1), true);
  return radius;
}

Register MotionCompiler::compile_rates(const Move& move, MoveForm& form) {
  form.jog = move.jog;
  const auto elements = by_coordinate(std::get<Tuple>(move.target->node), jogged(move.jog, robot_));
  if (move.jog == JogFrame::Joint) form.means = MoveCommand::Target::Axes;
  name_dimensions(jogged(move.jog, robot_), form);
  const Register first = registers_for(elements, form);
  Register next = first;
  for (const Tuple::Element* element : elements) {
    if (element != nullptr) expressions_.value_into(*element->value, next++, true);
  }
  return first;
}

/// The joints that a point was taught with: what the points file says, or TEACH has found. A
/// gripper, the last of them, has no part in a pose: it stays as it is.
Register MotionCompiler::compile_taught(const Symbol& point, MoveForm& form, Place place) {
  form.means = MoveCommand::Target::Axes;
  form.count = static_cast<int>(robot_.axes.size());
  form.given = given_all(form.count - static_cast<int>(robot_.grippers.size()));
  name_dimensions(robot_.axes, form);
  const Register first = frame_.number_registers(form.count);
  if (point.taught != nullptr) {
    variables_.load_variable(*point.taught, first, place);
  } else {
    load_joints(code_, point, robot_, first, place);
  }
  return first;
}

/// A row of registers, one for each component that was written.
Register MotionCompiler::registers_for(const std::vector<const Tuple::Element*>& elements,
                                       MoveForm& form) {
  form.count = static_cast<int>(elements.size());
  int given = 0;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    if (elements[i] == nullptr) continue;
    form.given = static_cast<std::uint8_t>(form.given | 1U << i);
    ++given;
  }
  return frame_.number_registers(given);
}

/// Registers are taken one after another, so that they lie together.
Register MotionCompiler::compile_axis(const Move& move, MoveForm& form) {
  form.means = MoveCommand::Target::Axes;
  form.count = static_cast<int>(robot_.axes.size());
  name_dimensions(robot_.axes, form);
  const Register first = frame_.number_registers();
  const auto axis = constant_number(*move.axis);
  if (axis) {
    form.given = static_cast<std::uint8_t>(1U << static_cast<unsigned>(*axis - 1));
    expressions_.value_into(*move.target, first, true);
  } else {
    form.computed_axis = true;
    expressions_.value_into(*move.axis, first);
    expressions_.value_into(*move.target, frame_.number_registers(), true);
  }
  return first;
}

Register MotionCompiler::compile_target(const Expr& target, MoveForm& form) {
  const auto* const tuple = std::get_if<Tuple>(&target.node);
  if (tuple == nullptr) return compile_value(target, form);
  const auto elements = by_coordinate(*tuple, elements_);
  name_dimensions(elements_, form);
  const Register first = registers_for(elements, form);
  Register next = first;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    if (elements[i] == nullptr) continue;
    compile_component(*elements[i]->value, elements_[i].dimension, next++);
  }
  return first;
}

/// A pose, JOINTS, or a VEC after BY, as it lies in registers.
Register MotionCompiler::compile_value(const Expr& target, MoveForm& form) {
  const bool axes = target.type.is(Type::Kind::Joints);
  form.means = axes ? MoveCommand::Target::Axes : MoveCommand::Target::Pose;
  form.in_frame = target.type.is_place() && is_free(as_pose(target.type));
  form.count = slots_of(target.type).numbers;
  form.given = given_all(form.count);
  if (axes) {
    name_dimensions(robot_.axes, form);
  } else {
    form.lengths = kPlaceOfPose;
  }
  const Register first = frame_.number_registers(form.count);
  expressions_.value_into(target, first);
  return first;
}

/// A component as a quantity; a bare number takes the UNITS of its place.
void MotionCompiler::compile_component(const Expr& component, Dimension dimension,
                                       Register target) {
  if (const auto constant = constant_component(component, dimension, robot_)) {
    code_.load_real(target, *constant, dimension, component.place);
    return;
  }
  expressions_.value_into(component, target, true);
  if (!is_bare(component.type)) return;
  const auto mark = frame_.mark();
  const BareUnit unit = bare_unit(dimension, robot_, component.place);
  const Register scale = frame_.number_registers();
  if (unit.divisor != 1) {
    code_.load_real(scale, unit.divisor, kNone, component.place);
    code_.emit(Opcode::quot_real, component.place, target, target, scale);
  }
  if (unit.factor != 1) {
    code_.load_real(scale, unit.factor, kNone, component.place);
    code_.emit(Opcode::mul_real, component.place, target, target, scale);
  }
  frame_.release(mark);
}

/// The pace that AT LIVE computes, of the motion or of its PATH; null without it.
const Expr* MotionCompiler::live_pace(const Clauses& clauses) const {
  const bool own = clauses[Clause::At] != nullptr || path_ == nullptr;
  const Clauses& said = own ? clauses : path_->clauses;
  return said.live ? said[Clause::At].get() : nullptr;
}

/// The checker has warned of a constant share above 100% and said that it is cut.
void MotionCompiler::compile_clause(Clause clause, const Expr& said, Register target) {
  const bool share = clause == Clause::At || clause == Clause::Accel || clause == Clause::Jerk;
  const bool cut = share && is_bare(said.type) && constant_number(said).value_or(0) > 1;
  if (cut) return code_.load_real(target, 1, kNone, said.place);
  expressions_.value_into(said, target, true);
}

void MotionCompiler::compile_clauses(const Clauses& clauses, MoveForm& form) {
  const bool zoned = clauses[Clause::Zone] != nullptr;
  form.fine = clauses.fine || (path_ != nullptr && path_->clauses.fine && !zoned);
  const auto settled_by_own = [&](std::size_t i) {
    const auto clause = static_cast<Clause>(i);
    const bool arrival =
        clause == Clause::Zone || clause == Clause::ZoneAngle || clause == Clause::Fine;
    return arrival && (clauses.fine || zoned);
  };
  form.profile = clauses.profile;
  form.euler = clauses.euler;
  form.free = clauses.free;
  form.live = live_pace(clauses) != nullptr;
  std::array<const Expr*, kClauses> settled{};
  for (std::size_t i = 0; i < kClauses; ++i) {
    settled[i] = clauses.values[i].get();
    const bool missing = settled[i] == nullptr && path_ != nullptr && !settled_by_own(i);
    if (missing) settled[i] = path_->clauses.values[i].get();
    if (settled[i] == live_pace(clauses)) settled[i] = nullptr;
    if (settled[i] == nullptr) continue;
    const Register value = frame_.number_registers();
    if (missing) {
      code_.emit(Opcode::copy, settled[i]->place, value, path_values_[i]);
    } else {
      compile_clause(static_cast<Clause>(i), *settled[i], value);
    }
  }
  const auto of = [&](Clause clause) { return settled[static_cast<std::size_t>(clause)]; };
  if (of(Clause::At) != nullptr) form.pace = *pace_of(of(Clause::At)->type);
  form.over = of(Clause::Over) != nullptr;
  if (of(Clause::Accel) != nullptr) form.accel = *accel_of(of(Clause::Accel)->type);
  if (of(Clause::Jerk) != nullptr) form.jerk = *jerk_of(of(Clause::Jerk)->type);
  if (of(Clause::Zone) != nullptr) form.zone = *zone_of(of(Clause::Zone)->type);
  form.zone_angle = of(Clause::ZoneAngle) != nullptr;
  form.fine_within = of(Clause::Fine) != nullptr;
  form.lasts = of(Clause::For) != nullptr;
  if (clauses.near != nullptr) compile_near(*clauses.near, form);
}

/// Its registers are those after all others.
void MotionCompiler::compile_near(const Expr& joints, MoveForm& form) {
  MoveForm axes;
  name_dimensions(robot_.axes, axes);
  form.near_lengths = axes.lengths;
  form.near = static_cast<std::uint8_t>(robot_.axes.size());
  expressions_.value_into(joints, frame_.number_registers(form.near));
}

/// AT LIVE: set up before the motion that it belongs to.
void MotionCompiler::compile_live(const Expr& pace) {
  const auto mark = frame_.mark();
  const ExpressionCompiler::WatchCode watch = expressions_.watch(pace);
  code_.emit(Instruction::ax(Opcode::live_pace, watch.values, watch.index), pace.place);
  code_.emit(Instruction{static_cast<std::uint32_t>(*pace_of(pace.type))}, pace.place);
  frame_.release(mark);
}

void MotionCompiler::enter(const Surroundings& surroundings, Place place) {
  if (surroundings.none()) return;
  constexpr unsigned kTool = 1;
  constexpr unsigned kFrame = 2;
  constexpr unsigned kInTool = 4;
  const auto mark = frame_.mark();
  const int slots = (surroundings.tool != nullptr ? kToolSlots : 0) +
                    (surroundings.frame != nullptr ? kPoseSlots : 0);
  const Register first = frame_.number_registers(slots);
  Register next = first;
  unsigned parts = surroundings.in_tool ? kInTool : 0;
  if (surroundings.tool != nullptr) {
    expressions_.value_into(*surroundings.tool, next);
    next = static_cast<Register>(next + kToolSlots);
    parts |= kTool;
  }
  if (surroundings.frame != nullptr) {
    expressions_.value_into(*surroundings.frame, next);
    parts |= kFrame;
  }
  code_.emit(Opcode::with, place, first, parts);
  frame_.release(mark);
  blocks_.open(OpenScopes::Kind::With);
}

void MotionCompiler::leave(const Surroundings& surroundings, Place place) {
  if (!surroundings.none()) blocks_.close(OpenScopes::Kind::With, place);
}

namespace {

bool gives_defaults(const Clauses& clauses) {
  return clauses.fine || clauses[Clause::At] != nullptr || clauses[Clause::Zone] != nullptr ||
         clauses[Clause::Accel] != nullptr;
}

}  // namespace

void MotionCompiler::begin_defaults(const Clauses& clauses, Place place) {
  if (!gives_defaults(clauses)) return;
  emit_defaults(Opcode::enter_defaults, clauses, place);
  blocks_.open(OpenScopes::Kind::With);
}

void MotionCompiler::end_defaults(const Clauses& clauses, Place place) {
  if (gives_defaults(clauses)) blocks_.close(OpenScopes::Kind::With, place);
}

void MotionCompiler::set_defaults(const Clauses& clauses, Place place) {
  emit_defaults(Opcode::set_defaults, clauses, place);
}

/// The values are computed here, once. A PATH around it, which takes no WITH, has no say.
void MotionCompiler::emit_defaults(Opcode opcode, const Clauses& clauses, Place place) {
  const auto mark = frame_.mark();
  MoveForm form;
  const Register first = frame_.number_registers(0);
  compile_clauses(clauses, form);
  code_.defaults(opcode, first, form, place);
  frame_.release(mark);
}

/// The clauses are evaluated once; their values are copied for the motions that have none.
void MotionCompiler::begin_path(const PathBlock& path, Place place) {
  for (std::size_t i = 0; i < kClauses; ++i) {
    if (path.clauses.values[i] == nullptr) continue;
    if (path.clauses.live && i == static_cast<std::size_t>(Clause::At)) continue;
    path_values_[i] = frame_.number_registers();
    compile_clause(static_cast<Clause>(i), *path.clauses.values[i], path_values_[i]);
  }
  code_.emit(Opcode::begin_path, place);
  path_ = &path;
}

void MotionCompiler::end_path(Place place) {
  path_ = nullptr;
  code_.emit(Opcode::end_path, place);
}

}  // namespace rob::lang
