#include <bit>

#include "lang/check/fold.h"
#include "lang/check/target.h"
#include "lang/compile/statement_compiler.h"

/// Code for motions: their values into registers, in the order of MoveForm.
namespace rob::lang {

void StatementCompiler::compile(const Move& move) {
  const Place place = place_;
  enter(move.clauses.surroundings);
  compile_motion(move);
  leave(move.clauses.surroundings, place);
}

/// Without its surroundings. Whether a point's joints are where MOVE must go is decided when it
/// comes to it: with another tool, or in a frame that lies elsewhere now, it goes to the pose.
void StatementCompiler::compile_motion(const Move& move) {
  const Symbol* const point = bare_point(move);
  if (point == nullptr || (point->taught == nullptr && point->joints.empty())) {
    return compile_motion(move, nullptr);
  }
  const Place place = place_;
  const std::vector<CodeBuilder::Jump> by_pose = unless_at_joints(*point, *move.target);
  compile_motion(move, point);
  const CodeBuilder::Jump done = code_.jump(place);
  for (const CodeBuilder::Jump& jump : by_pose) code_.land(jump);
  compile_motion(move, nullptr);
  code_.land(done);
}

/// The jumps taken where a point's joints are not known, or do not bring the tool of now to it.
std::vector<CodeBuilder::Jump> StatementCompiler::unless_at_joints(const Symbol& point,
                                                                   const Expr& target) {
  const auto mark = code_.mark();
  std::vector<CodeBuilder::Jump> jumps;
  const auto unless = [&](Register truth) {
    code_.emit(Opcode::if_bool, place_, truth, 0);
    jumps.push_back(code_.jump(place_));
  };
  if (point.taught != nullptr) unless(expressions_.variable(*point.has_taught, place_));
  MoveForm form;
  const Register same = code_.number_registers();
  const Register joints = compile_taught(point, form);
  const auto count = static_cast<std::uint32_t>(form.count);
  code_.emit(Opcode::at_joints, place_, same, joints, compile_value(target, form));
  code_.emit(Instruction{count}, place_);
  unless(same);
  code_.release(mark);
  return jumps;
}

/// To the joints of a point, if that is given.
void StatementCompiler::compile_motion(const Move& move, const Symbol* taught) {
  const Place place = place_;
  for (const ExprPtr& point : move.via) compile_via(*point, place);
  const auto mark = code_.mark();
  MoveForm form{.kind = move.kind, .relative = move.by};
  if (const Expr* const pace = live_pace(move.clauses)) compile_live(*pace);
  const Register first =
      taught != nullptr ? compile_taught(*taught, form) : compile_way(move, form);
  compile_clauses(move.clauses, form);
  code_.move(first, form, place);
  code_.release(mark);
}

void StatementCompiler::compile(const PlainMotions& motions) {
  constexpr std::size_t kWordsOfReal = 2;
  const std::size_t count = motions.motions.size();
  code_.reserve(count, 1 + kWordsOfReal * motions.values.size() / count);
  auto values = motions.values.begin();
  for (const PlainMotions::Written& motion : motions.motions) {
    const MoveForm form{.kind = motion.kind,
                        .count = static_cast<int>(robot_.coordinates.size()),
                        .given = motion.given};
    const auto end = values + std::popcount(motion.given);
    code_.move_to(form, {values, end}, motions.place(motion));
    values = end;
  }
}

void StatementCompiler::compile_via(const Expr& point, Place place) {
  const auto mark = code_.mark();
  MoveForm form;
  const Register first = compile_target(point, form);
  code_.via(first, form, place);
  code_.release(mark);
}

Register StatementCompiler::compile_way(const Move& move, MoveForm& form) {
  if (move.axis != nullptr) return compile_axis(move, form);
  if (move.kind == MotionKind::Jog) return compile_rates(move, form);
  if (move.kind != MotionKind::Spiral) return compile_target(*move.target, form);
  const Register radius = code_.number_registers(2);
  expressions_.value_into(*move.radius, radius);
  expressions_.value_into(*move.turns, static_cast<Register>(radius + 1), true);
  return radius;
}

Register StatementCompiler::compile_rates(const Move& move, MoveForm& form) {
  form.jog = move.jog;
  const auto elements = by_coordinate(std::get<Tuple>(move.target->node), jogged(move.jog, robot_));
  if (move.jog == JogFrame::Joint) form.means = MoveCommand::Target::Axes;
  const Register first = registers_for(elements, form);
  Register next = first;
  for (const Tuple::Element* element : elements) {
    if (element != nullptr) expressions_.value_into(*element->value, next++, true);
  }
  return first;
}

/// The joints that a point was taught with: what the points file says, or TEACH has found.
Register StatementCompiler::compile_taught(const Symbol& point, MoveForm& form) {
  form.means = MoveCommand::Target::Axes;
  form.count = static_cast<int>(robot_.axes.size());
  form.given = given_all(form.count);
  const Register first = code_.number_registers(form.count);
  if (point.taught != nullptr) {
    expressions_.load_variable(*point.taught, first, place_);
    return first;
  }
  for (std::size_t i = 0; i < point.joints.size(); ++i) {
    code_.load_real(static_cast<Register>(first + i), point.joints[i], robot_.axes[i].dimension,
                    place_);
  }
  return first;
}

/// A row of registers, one for each component that was written.
Register StatementCompiler::registers_for(const std::vector<const Tuple::Element*>& elements,
                                          MoveForm& form) {
  form.count = static_cast<int>(elements.size());
  int given = 0;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    if (elements[i] == nullptr) continue;
    form.given = static_cast<std::uint8_t>(form.given | 1U << i);
    ++given;
  }
  return code_.number_registers(given);
}

/// Registers are taken one behind another, so that they lie together.
Register StatementCompiler::compile_axis(const Move& move, MoveForm& form) {
  form.means = MoveCommand::Target::Axes;
  form.count = static_cast<int>(robot_.axes.size());
  const Register first = code_.number_registers();
  const auto axis = constant_number(*move.axis);
  if (axis) {
    form.given = static_cast<std::uint8_t>(1U << static_cast<unsigned>(*axis - 1));
    expressions_.value_into(*move.target, first, true);
  } else {
    form.computed_axis = true;
    expressions_.value_into(*move.axis, first);
    expressions_.value_into(*move.target, code_.number_registers(), true);
  }
  return first;
}

Register StatementCompiler::compile_target(const Expr& target, MoveForm& form) {
  const auto* const tuple = std::get_if<Tuple>(&target.node);
  if (tuple == nullptr) return compile_value(target, form);
  const auto elements = by_coordinate(*tuple, robot_.coordinates);
  const Register first = registers_for(elements, form);
  Register next = first;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    if (elements[i] == nullptr) continue;
    compile_component(*elements[i]->value, robot_.coordinates[i].dimension, next++);
  }
  return first;
}

/// A pose, JOINTS, or a VEC behind BY, as it lies in registers.
Register StatementCompiler::compile_value(const Expr& target, MoveForm& form) {
  const bool axes = target.type.is(Type::Kind::Joints);
  form.means = axes ? MoveCommand::Target::Axes : MoveCommand::Target::Pose;
  form.in_frame = target.type.is_place() && is_free(as_pose(target.type));
  form.count = slots_of(target.type).numbers;
  form.given = given_all(form.count);
  const Register first = code_.number_registers(form.count);
  expressions_.value_into(target, first);
  return first;
}

/// What AT LIVE computes, of the motion or of its PATH; null without it.
const Expr* StatementCompiler::live_pace(const Clauses& clauses) const {
  const bool own = clauses[Clause::At] != nullptr || path_ == nullptr;
  const Clauses& said = own ? clauses : path_->clauses;
  return said.live ? said[Clause::At].get() : nullptr;
}

/// The checker has warned of a constant share above 100% and said that it is cut.
void StatementCompiler::compile_clause(Clause clause, const Expr& said, Register target) {
  const bool cut =
      clause == Clause::At && is_bare(said.type) && constant_number(said).value_or(0) > 1;
  if (cut) return code_.load_real(target, 1, kNone, said.place);
  expressions_.value_into(said, target, true);
}

void StatementCompiler::compile_clauses(const Clauses& clauses, MoveForm& form) {
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
  std::array<const Expr*, kClauses> settled{};
  for (std::size_t i = 0; i < kClauses; ++i) {
    settled[i] = clauses.values[i].get();
    const bool missing = settled[i] == nullptr && path_ != nullptr && !settled_by_own(i);
    if (missing) settled[i] = path_->clauses.values[i].get();
    if (settled[i] == live_pace(clauses)) settled[i] = nullptr;
    if (settled[i] == nullptr) continue;
    const Register value = code_.number_registers();
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
}

/// A component in SI; a bare number takes the UNITS of its place.
void StatementCompiler::compile_component(const Expr& component, Dimension dimension,
                                          Register target) {
  if (const auto constant = constant_component(component, dimension, robot_)) {
    code_.load_real(target, *constant, dimension, component.place);
    return;
  }
  expressions_.value_into(component, target, true);
  if (!is_bare(component.type)) return;
  const auto mark = code_.mark();
  const BareUnit unit = bare_unit(dimension, robot_, component.place);
  const Register scale = code_.number_registers();
  if (unit.divisor != 1) {
    code_.load_real(scale, unit.divisor, kNone, component.place);
    code_.emit(Opcode::quot_real, component.place, target, target, scale);
  }
  if (unit.factor != 1) {
    code_.load_real(scale, unit.factor, kNone, component.place);
    code_.emit(Opcode::mul_real, component.place, target, target, scale);
  }
  code_.release(mark);
}

}  // namespace rob::lang
