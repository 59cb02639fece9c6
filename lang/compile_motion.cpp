#include "lang/fold.h"
#include "lang/statement_compiler.h"
#include "lang/target.h"

/// Code for motions: their values into registers, in the order of MoveForm.
namespace rob::lang {

void StatementCompiler::compile(const Move& move) {
  const Symbol* const point = bare_point(move);
  if (point == nullptr || point->taught == nullptr) {
    const bool by_joints = point != nullptr && known(point->value) && !point->joints.empty();
    return compile_motion(move, by_joints ? point : nullptr);
  }
  const Place place = place_;
  const auto mark = code_.mark();
  code_.emit(Opcode::if_bool, place, expressions_.variable(*point->has_taught, place), 0);
  const CodeBuilder::Jump by_pose = code_.jump(place);
  code_.release(mark);
  compile_motion(move, point);
  const CodeBuilder::Jump done = code_.jump(place);
  code_.land(by_pose);
  compile_motion(move, nullptr);
  code_.land(done);
}

/// To the joints of a point, if that is given.
void StatementCompiler::compile_motion(const Move& move, const Symbol* taught) {
  const Place place = place_;
  const auto mark = code_.mark();
  MoveForm form{.kind = move.kind, .relative = move.by};
  if (move.clauses.live) compile_live(*move.clauses[Clause::At]);
  const Register first = taught != nullptr      ? compile_taught(*taught, form)
                         : move.axis != nullptr ? compile_axis(move, form)
                                                : compile_target(move, form);
  compile_clauses(move.clauses, form);
  code_.move(first, form, place);
  code_.release(mark);
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

Register StatementCompiler::compile_target(const Move& move, MoveForm& form) {
  if (!std::holds_alternative<Tuple>(move.target->node)) return compile_value(*move.target, form);
  const auto elements = by_coordinate(std::get<Tuple>(move.target->node), robot_);
  form.count = static_cast<int>(elements.size());
  int given = 0;
  for (const Tuple::Element* element : elements) given += element != nullptr ? 1 : 0;
  const Register first = code_.number_registers(given);
  Register next = first;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    if (elements[i] == nullptr) continue;
    form.given = static_cast<std::uint8_t>(form.given | 1U << i);
    compile_component(*elements[i]->value, robot_.coordinates[i].dimension, next++);
  }
  return first;
}

/// A pose, JOINTS, or a VEC behind BY, as it lies in registers.
Register StatementCompiler::compile_value(const Expr& target, MoveForm& form) {
  form.means =
      target.type.is(Type::Kind::Joints) ? MoveCommand::Target::Axes : MoveCommand::Target::Pose;
  form.count = slots_of(target.type).numbers;
  form.given = given_all(form.count);
  const Register first = code_.number_registers(form.count);
  expressions_.value_into(target, first);
  return first;
}

void StatementCompiler::compile_clauses(const Clauses& clauses, MoveForm& form) {
  form.fine = clauses.fine;
  form.profile = clauses.profile;
  const ExprPtr& at = clauses[Clause::At];
  for (const ExprPtr& value : clauses.values) {
    const bool set_up = clauses.live && &value == &at;
    if (value != nullptr && !set_up)
      expressions_.value_into(*value, code_.number_registers(), true);
  }
  if (at && !clauses.live) form.pace = *pace_of(at->type);
  form.over = clauses[Clause::Over] != nullptr;
  if (clauses[Clause::Accel]) form.accel = *accel_of(clauses[Clause::Accel]->type);
  if (clauses[Clause::Jerk]) form.jerk = *jerk_of(clauses[Clause::Jerk]->type);
  if (clauses[Clause::Zone]) form.zone = *zone_of(clauses[Clause::Zone]->type);
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
  const BareUnit unit = bare_unit(dimension, robot_);
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
