#include "lang/check/call_checker.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "lang/check/fold.h"
#include "lang/check/meaning.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"
#include "lang/text/suggest.h"
#include "lang/values/pose_slots.h"
#include "lang/values/units.h"

namespace rob::lang {
namespace {

/// All forms of the function together: FLOOR(x) and FLOOR(x, step) make "1 to 2 arguments".
std::string count_of_arguments(const Builtin& builtin) {
  std::size_t least = builtin.least;
  std::size_t most = builtin.most;
  for (const Builtin& other : builtins()) {
    if (other.name != builtin.name || other.rule == BuiltinRule::RowNumber) continue;
    least = std::min(least, other.least);
    most = std::max<std::size_t>(most, other.most);
  }
  if (most > least) return fmt::format("{} to {} arguments", least, most);
  return builtin.least == 1 ? "one argument" : fmt::format("{} arguments", builtin.least);
}

/// The exponents halved, or nothing if they are not even.
std::optional<Dimension> root_of(Dimension d) {
  const auto odd = [](std::int8_t exponent) { return exponent % 2 != 0; };
  if (odd(d.length) || odd(d.mass) || odd(d.time) || odd(d.angle) || odd(d.voltage)) {
    return std::nullopt;
  }
  const auto half = [](std::int8_t exponent) { return static_cast<std::int8_t>(exponent / 2); };
  return Dimension{.length = half(d.length),
                   .mass = half(d.mass),
                   .time = half(d.time),
                   .angle = half(d.angle),
                   .voltage = half(d.voltage)};
}

std::string axis_names(const RobotSignature& robot) {
  std::vector<std::string_view> names;
  for (const RobotSignature::Coordinate& axis : robot.axes) names.push_back(axis.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

/// LEN(a): known from the type, unless a routine must be called for a.
void fold_length(const Call& call, Expr& expression) {
  const Expr& array = *call.arguments.front();
  if (!array.type.is_row() && !calls_routine(array)) {
    expression.constant = array.type.detail->length;
  }
}

void fold_ordinal(const Call& call, Expr& expression) {
  const auto* const value = std::get_if<std::int64_t>(&call.arguments.front()->constant);
  if (value != nullptr) expression.constant = *value + 1;
}

std::size_t index_of(const TypeDetail& record, std::string_view field) {
  const auto found = std::ranges::find_if(
      record.fields, [&](const TypeDetail::Field& each) { return same_word(each.name, field); });
  return static_cast<std::size_t>(found - record.fields.begin());
}

/// Whether a variable can be given to a REF parameter.
bool fits_reference(const Type& variable, const Type& parameter) {
  if (variable == parameter) return true;
  return parameter.is_open() && variable.has_row() &&
         variable.detail->element == parameter.detail->element;
}

/// Built-in functions that change what they are given, and have no value.
bool is_procedure(const Builtin& builtin) {
  switch (builtin.rule) {
    case BuiltinRule::RowSort:
    case BuiltinRule::ListAppend:
    case BuiltinRule::ListRemove:
    case BuiltinRule::ListClear:
      return true;
    default:
      return false;
  }
}

std::optional<std::size_t> reference_of(const Call& call) {
  const auto found = std::ranges::find(call.references, true);
  if (found == call.references.end()) return std::nullopt;
  return static_cast<std::size_t>(found - call.references.begin());
}

}  // namespace

bool BuiltinChecker::stands_wrong(const Builtin& builtin, const Call& call, bool statement,
                                  Place place) {
  const bool procedure = is_procedure(builtin);
  if (const auto reference = reference_of(call); reference && (!procedure || *reference > 0)) {
    place = call.arguments[*reference]->place;
    diagnostics_.error(code::kReferenceArgument, place,
                       fmt::format("{} does not change what it is given here", builtin.name),
                       "leave REF out");
    return true;
  }
  if (statement == procedure) return false;
  if (procedure) {
    diagnostics_.error(code::kRoutineMisused, place, fmt::format("{} has no value", builtin.name),
                       "write it on a line of its own");
  } else {
    diagnostics_.error(code::kRoutineMisused, place,
                       fmt::format("{} gives a value, which is not used here", builtin.name),
                       "a statement calls a PROC");
  }
  return true;
}

Type BuiltinChecker::check(const Builtin& builtin, const Call& call, bool sound, Expr& expression) {
  if (builtin.rule == BuiltinRule::Joints) {
    return sound ? check_joints(call, expression) : Type{};
  }
  for (const std::string& name : call.names) {
    if (name.empty()) continue;
    diagnostics_.error(code::kArgumentName, expression.place,
                       fmt::format("the arguments of {} have no names", builtin.name));
    return {};
  }
  if (call.arguments.size() < builtin.least || call.arguments.size() > builtin.most) {
    diagnostics_.error(code::kArgumentCount, expression.place,
                       fmt::format("{} needs {}; here are {}", builtin.name,
                                   count_of_arguments(builtin), call.arguments.size()));
    return {};
  }
  if (!sound) return {};
  expression.type = type_of(builtin, call, expression.place);
  if (expression.type.kind != Type::Kind::Unknown) fold_known(builtin, call, expression);
  return expression.type;
}

bool BuiltinChecker::has_sensor(Reading reading, Place place) {
  if (!needs_sensor(reading) || robot_.force_sensor) return true;
  diagnostics_.error(
      code::kNoForceSensor, place,
      fmt::format("{} has no force sensor: it cannot read {}", robot_.name, name_of(reading)),
      "`rob robots` shows which robot has one");
  return false;
}

Type BuiltinChecker::type_of(const Builtin& builtin, const Call& call, Place place) {
  const std::string needs = fmt::format("{} needs", builtin.name);
  const auto first = [&]() -> const Expr& { return *call.arguments.front(); };
  const auto only = [&](const Type& wanted, const Type& result) {
    return values_.accept(first(), wanted, needs) ? result : Type{};
  };
  switch (builtin.rule) {
    case BuiltinRule::SameNumber:
      return common_dimension(call);
    case BuiltinRule::NumberToInt:
      return common_dimension(call).numeric() ? Type::integer() : Type{};
    case BuiltinRule::Root:
      return check_root(call);
    case BuiltinRule::SameReal: {
      const Type type = common_dimension(call);
      return type.numeric() ? Type::real(type.dimension) : Type{};
    }
    case BuiltinRule::SameToAngle:
      return common_dimension(call).numeric() ? Type::real(kAngle) : Type{};
    case BuiltinRule::AngleToReal:
      return only(Type::real(kAngle), Type::real());
    case BuiltinRule::RealToAngle:
      return only(Type::real(), Type::real(kAngle));
    case BuiltinRule::AngleToAngle:
      return only(Type::real(kAngle), Type::real(kAngle));
    case BuiltinRule::RealToReal:
      return only(Type::real(), Type::real());
    case BuiltinRule::RealToInt:
      return only(Type::real(), Type::integer());
    case BuiltinRule::AnyToText:
    case BuiltinRule::AnyToCsv:
      return Type::string();
    case BuiltinRule::FileExists:
      values_.check_file(call.arguments.front(), "EXISTS");
      return only(Type::string(), Type::boolean());
    case BuiltinRule::ArrayLength:
      return Type::integer();
    case BuiltinRule::Ordinal:
      return check_ordinal(first());
    case BuiltinRule::RowNumber:
      return check_row_number(builtin, first());
    case BuiltinRule::ListAppend:
    case BuiltinRule::ListRemove:
    case BuiltinRule::ListClear:
      return accept_changed(builtin, first()) ? check_list(builtin, call) : Type{};
    case BuiltinRule::Split:
    case BuiltinRule::Join:
      return check_parts(builtin, call);
    case BuiltinRule::RowSort:
      return accept_changed(builtin, first()) ? check_sort(first()) : Type{};
    case BuiltinRule::Random:
      return call.arguments.empty() ? Type::real() : common_dimension(call);
    case BuiltinRule::ToFrame:
      return check_to_frame(call);
    case BuiltinRule::Forward:
      return values_.accept(first(), joints_, needs) ? Type::pose() : Type{};
    case BuiltinRule::Wrench:
      return has_sensor(Reading::Wrench, place) ? Type{Type::Kind::Wrench} : Type{};
    case BuiltinRule::Unix:
      return Type::real(kTime);
    case BuiltinRule::Joints:  // has been checked as a whole
      return {};
    case BuiltinRule::Places:
      return check_poses(builtin, call);
    case BuiltinRule::Texts:
      return check_texts(builtin, call);
    case BuiltinRule::NumbersToVec: {
      const Type type = common_dimension(call);
      return type.known() ? Type::vec(type.dimension) : Type{};
    }
    default:
      return check_vectors(builtin, call);
  }
}

/// The type that all arguments share: INT, or REAL of one dimension.
Type BuiltinChecker::common_dimension(const Call& call) {
  Type common;
  for (const ExprPtr& argument : call.arguments) {
    if (!argument->type.numeric()) {
      diagnostics_.error(
          code::kTypeMismatch, argument->place,
          fmt::format("{} needs numbers; this is {}", to_upper(call.callee), described(*argument)));
      return {};
    }
    const Type next = common_type(common, argument->type);
    if (!next.numeric()) {
      diagnostics_.error(code::kDimensionMismatch, argument->place,
                         fmt::format("this is {}; {} needs {} here, as before{}",
                                     described(*argument), to_upper(call.callee), in_words(common),
                                     not_as_written(argument->type, common)));
      return {};
    }
    common = next;
  }
  return common;
}

Type BuiltinChecker::check_root(const Call& call) {
  const Type type = common_dimension(call);
  if (!type.numeric()) return {};
  if (const auto root = root_of(type.dimension)) return Type::real(*root);
  diagnostics_.error(
      code::kDimensionMismatch, call.arguments.front()->place,
      fmt::format("{} has no root: SQRT halves the exponents of the unit", in_words(type)));
  return {};
}

Type BuiltinChecker::check_ordinal(const Expr& value) {
  if (value.type.is(Type::Kind::Enum)) return Type::integer();
  diagnostics_.error(code::kTypeMismatch, value.place,
                     fmt::format("ORD needs a value of an ENUM; this is {}", described(value)));
  return {};
}

/// SUM, MIN and MAX of all elements.
Type BuiltinChecker::check_row_number(const Builtin& builtin, const Expr& row) {
  const auto elements = row.type.has_row() ? elements_of(row.type) : std::nullopt;
  if (elements && elements->type.numeric()) return elements->type;
  if (row.type.numeric() && builtin.name != "SUM") {
    diagnostics_.error(
        code::kArgumentCount, row.place,
        fmt::format("{} needs 2 to {} arguments; here are 1", builtin.name, kMostArguments),
        "or one: an ARRAY or LIST of numbers");
    return {};
  }
  diagnostics_.error(code::kTypeMismatch, row.place,
                     fmt::format("{} needs an ARRAY or LIST of numbers; this is {}", builtin.name,
                                 described(row)));
  return {};
}

/// A variable, or a part of one, that a built-in function changes.
bool BuiltinChecker::accept_changed(const Builtin& builtin, const Expr& variable) {
  const Name* const root = root_of(variable);
  const bool changes =
      root != nullptr && root->symbol != nullptr && root->symbol->kind == Symbol::Kind::Variable;
  if (changes && root->symbol->type.is(Type::Kind::List)) {
    uses_.met_list(variable.place);
    return true;
  }
  if (changes) {
    uses_.referred(*root->symbol, variable.place);
    return true;
  }
  diagnostics_.error(code::kReferenceArgument, variable.place,
                     fmt::format("{} changes a variable, and this is none", builtin.name),
                     "declare one with VAR, and give its name");
  return false;
}

Type BuiltinChecker::check_sort(const Expr& row) {
  const auto elements = row.type.has_row() ? elements_of(row.type) : std::nullopt;
  if (elements && (elements->type.numeric() || elements->type.text())) return {};
  diagnostics_.error(
      code::kNotSortable, row.place,
      fmt::format("SORT needs an ARRAY or LIST of numbers or texts; this is {}", described(row)));
  return {};
}

/// APPEND, REMOVE, CLEAR.
Type BuiltinChecker::check_list(const Builtin& builtin, const Call& call) {
  const Expr& list = *call.arguments.front();
  if (!list.type.is(Type::Kind::List)) {
    diagnostics_.error(
        code::kTypeMismatch, list.place,
        fmt::format("{} changes a LIST; this is {}", builtin.name, described(list)),
        list.type.is(Type::Kind::Array) ? "VAR l: LIST OF INT = [1, 2] declares one" : "");
    return {};
  }
  if (builtin.rule == BuiltinRule::ListClear) return {};
  const bool append = builtin.rule == BuiltinRule::ListAppend;
  const Type wanted = append ? list.type.detail->element : Type::integer();
  values_.accept(*call.arguments.back(), wanted, fmt::format("{} needs", builtin.name));
  return {};
}

/// SPLIT and JOIN.
Type BuiltinChecker::check_parts(const Builtin& builtin, const Call& call) {
  const std::string needs = fmt::format("{} needs", builtin.name);
  const Expr& first = *call.arguments.front();
  if (!values_.accept(*call.arguments.back(), Type::string(), needs)) return {};
  if (builtin.rule == BuiltinRule::Split) {
    return values_.accept(first, Type::string(), needs) ? text_list_ : Type{};
  }
  if (first.type.has_row() && first.type.detail->element.text()) return Type::string();
  diagnostics_.error(
      code::kTypeMismatch, first.place,
      fmt::format("JOIN needs an ARRAY or LIST of texts; this is {}", described(first)));
  return {};
}

/// Functions of one VEC, or of two.
Type BuiltinChecker::check_vectors(const Builtin& builtin, const Call& call) {
  for (const ExprPtr& argument : call.arguments) {
    if (argument->type.is(Type::Kind::Vec)) continue;
    diagnostics_.error(
        code::kTypeMismatch, argument->place,
        fmt::format("{} needs a VEC; this is {}", builtin.name, described(*argument)),
        "for example (1mm, 2mm, 3mm)");
    return {};
  }
  const Expr& first = *call.arguments.front();
  const Expr& last = *call.arguments.back();
  const Dimension product = first.type.dimension * last.type.dimension;
  switch (builtin.rule) {
    case BuiltinRule::VecsToProduct:
      return values_.bounded(product, last);
    case BuiltinRule::VecsToVec:
      return values_.bounded(product, last).known() ? Type::vec(product) : Type{};
    case BuiltinRule::VecToDirection:
      return Type::vec(kNone);
    default:
      return values_.accept(last, first.type, fmt::format("{} needs", builtin.name))
                 ? Type::real(first.type.dimension)
                 : Type{};
  }
}

/// A function of poses takes and gives what its signature says (builtins.def).
Type BuiltinChecker::check_poses(const Builtin& builtin, const Call& call) {
  const std::string needs = fmt::format("{} needs", builtin.name);
  const Expr* first_pose = nullptr;
  Type frame = free_pose();
  for (std::size_t i = 0; i < call.arguments.size(); ++i) {
    const Expr& argument = *call.arguments[i];
    switch (builtin.signature.parameters[i]) {
      case 'L':
        if (!values_.accept(argument, Type::real(kLength), needs)) return {};
        break;
      case 'A':
        if (!values_.accept(argument, Type::real(kAngle), needs)) return {};
        break;
      case 'R':
        if (!values_.accept(argument, Type::real(), needs)) return {};
        break;
      case 'V':
        if (!values_.accept(argument, Type::vec(kLength), needs)) return {};
        break;
      default:
        if (!accept_pose(builtin, argument, first_pose, frame)) return {};
    }
  }
  switch (builtin.signature.result) {
    case 'L':
      return Type::real(kLength);
    case 'A':
      return Type::real(kAngle);
    case 'P':
      return frame;
    default:
      return free_pose();
  }
}

/// `first`: the first pose that the function is given; `frame`: what it and the others are in.
bool BuiltinChecker::accept_pose(const Builtin& builtin, const Expr& argument, const Expr*& first,
                                 Type& frame) {
  if (!argument.type.is_place()) {
    diagnostics_.error(
        code::kTypeMismatch, argument.place,
        fmt::format("{} needs a pose here; this is {}", builtin.name, described(argument)),
        "for example POSE(10mm, 20mm, 0mm)");
    return false;
  }
  if (argument.type.is(Type::Kind::Tool)) argument.place_slots = kPoseSlots;
  if (first == nullptr) first = &argument;
  const Type common = values_.common_frame(*first, argument, builtin.name);
  if (common.known() && is_free(frame)) frame = common;
  return common.known();
}

/// TO_FRAME(p, f): f is the name of a FRAME, so that the frame of the result is known.
Type BuiltinChecker::check_to_frame(const Call& call) {
  const Expr& pose = *call.arguments[0];
  const Expr& frame = *call.arguments[1];
  if (!values_.accept(pose, Type::pose(), "TO_FRAME needs")) return {};
  const auto* const name = std::get_if<Name>(&frame.node);
  if (name != nullptr && name->symbol != nullptr && frame.type.is(Type::Kind::Frame) &&
      known(name->symbol->value)) {
    return Type::pose(name->symbol->frame);
  }
  diagnostics_.error(
      code::kNoFrame, frame.place,
      fmt::format("TO_FRAME needs the name of a FRAME; this is {}", described(frame)),
      "FRAME pallet = POSE(…) declares one");
  return {};
}

/// JOINTS() · JOINTS(q1, …, qn) · JOINTS(p) · JOINTS(p, near: j)
Type BuiltinChecker::check_joints(const Call& call, Expr& expression) {
  const std::size_t given = call.arguments.size();
  if (given > 0 && call.arguments.front()->type.is_place()) return check_inverse(call);
  if (std::ranges::any_of(call.names, [](const std::string& name) { return !name.empty(); })) {
    diagnostics_.error(code::kArgumentName, expression.place,
                       "the values of JOINTS have no names: they stand in the order of the axes",
                       fmt::format("the axes are {}", axis_names(robot_)));
    return {};
  }
  if (given == 0) return joints_;
  if (given != robot_.axes.size()) {
    diagnostics_.error(code::kArgumentCount, expression.place,
                       fmt::format("JOINTS needs a value for each axis of {} ({}); here are {}",
                                   robot_.name, axis_names(robot_), given));
    return {};
  }
  std::vector<double> values;
  for (std::size_t i = 0; i < given; ++i) {
    const Expr& value = *call.arguments[i];
    const RobotSignature::Coordinate& axis = robot_.axes[i];
    if (!values_.accept(value, Type::real(axis.dimension),
                        fmt::format("axis {} needs", axis.name))) {
      return {};
    }
    if (const auto known = constant_number(value)) values.push_back(*known);
  }
  if (values.size() == given) expression.constant = std::move(values);
  return joints_;
}

/// The axis values that bring the tool to a pose: the robot computes them while the program runs.
Type BuiltinChecker::check_inverse(const Call& call) {
  const bool named = call.names.size() > 1 && !call.names[1].empty();
  const bool sound = call.arguments.size() <= 2 && (call.names.empty() || call.names[0].empty()) &&
                     (!named || same_word(call.names[1], "near"));
  if (!sound) {
    diagnostics_.error(code::kArgumentName, call.arguments.back()->place,
                       "JOINTS of a pose takes the pose, and perhaps the joints to stay near to",
                       "as in JOINTS(p, near: JOINTS())");
    return {};
  }
  if (!values_.accept(*call.arguments[0], Type::pose(), "JOINTS needs")) return {};
  const bool near = call.arguments.size() == 2;
  return !near || values_.accept(*call.arguments[1], joints_, "near needs") ? joints_ : Type{};
}

Type BuiltinChecker::axis_type(const Index& index) {
  const std::vector<Dimension>& axes = joints_.detail->axes;
  const auto* const number = std::get_if<std::int64_t>(&index.index->constant);
  if (number != nullptr) {
    const bool there = *number >= 1 && *number <= static_cast<std::int64_t>(axes.size());
    return there ? Type::real(axes[static_cast<std::size_t>(*number - 1)]) : Type{};
  }
  if (alike(robot_.axes)) return Type::real(axes.front());
  diagnostics_.error(code::kAxisNotConstant, index.index->place,
                     fmt::format("the axes of {} are of different kinds: which one is meant has to "
                                 "be a constant",
                                 robot_.name),
                     fmt::format("write a number from 1 to {}", axes.size()));
  return {};
}

Type BuiltinChecker::check_texts(const Builtin& builtin, const Call& call) {
  const std::string needs = fmt::format("{} needs", builtin.name);
  for (std::size_t i = 0; i < call.arguments.size(); ++i) {
    const Expr& argument = *call.arguments[i];
    const char letter = builtin.signature.parameters[i];
    if (letter != 'Q') {
      if (!values_.accept(argument, letter == 'S' ? Type::string() : Type::integer(), needs))
        return {};
    } else if (!argument.type.numeric()) {
      diagnostics_.error(code::kTypeMismatch, argument.place,
                         fmt::format("{} a number here; this is {}", needs, described(argument)));
      return {};
    } else if (!check_unit(argument, *call.arguments[i + 1])) {
      return {};
    }
  }
  switch (builtin.signature.result) {
    case 'S':
      return Type::string();
    case 'I':
      return Type::integer();
    default:
      return Type::real();
  }
}

/// The unit in which STR writes a value: known here, so that its dimension can be checked.
bool BuiltinChecker::check_unit(const Expr& value, const Expr& unit_text) {
  if (unit_text.type != Type::string())
    return values_.accept(unit_text, Type::string(), "STR needs");
  const auto* const text = std::get_if<std::string>(&unit_text.constant);
  if (text == nullptr) {
    diagnostics_.error(code::kUnitNotWritten, unit_text.place,
                       "STR needs its unit written out, so that it can be checked",
                       "for example STR(x, \"mm\", 1)");
    return false;
  }
  const auto unit = text->empty() ? Unit{} : find_unit(*text);
  if (!unit) {
    diagnostics_.error(code::kUnknownUnit, unit_text.place,
                       fmt::format("there is no unit {}", shortened(*text)),
                       did_you_mean(suggest(*text, {unit_names().begin(), unit_names().end()})));
    return false;
  }
  if (unit->dimension == value.type.dimension) return true;
  diagnostics_.error(code::kDimensionMismatch, unit_text.place,
                     fmt::format("{} is the unit of {}; the value is {}", *text,
                                 in_words(unit->dimension), described(value)),
                     fmt::format("write \"{}\"", lang::unit_text(value.type.dimension)));
  return false;
}

void BuiltinChecker::fold_known(const Builtin& builtin, const Call& call, Expr& expression) {
  if (builtin.rule == BuiltinRule::ArrayLength) return fold_length(call, expression);
  if (builtin.rule == BuiltinRule::Ordinal) return fold_ordinal(call, expression);
  const bool computes = builtin.real != nullptr || builtin.rule == BuiltinRule::AnyToText;
  if (!computes) return;
  if (builtin.rule == BuiltinRule::AnyToText) {
    const Expr& value = *call.arguments.front();
    if (known(value.constant) && value.type != Type::string()) {
      expression.constant = text_of(value.constant, value.type);
    }
    return;
  }
  std::array<Constant, kMostArguments> arguments;
  const bool whole = computes_whole(builtin, call);
  const Type common = whole ? Type::integer() : Type::real();
  for (std::size_t i = 0; i < call.arguments.size(); ++i) {
    arguments[i] = converted(known_value(*call.arguments[i]), common);
    if (!known(arguments[i])) return;
  }
  values_.keep(fold(whole ? builtin.integer : builtin.real,
                    {arguments.data(), call.arguments.size()}, expression.type),
               expression);
}

Type CallChecker::check_routine(Call& call, Place place, const Routine& routine, bool statement) {
  if (routine.task) {
    diagnostics_.error(
        code::kRoutineMisused, place,
        fmt::format("{} is a TASK and is not called", shortened(routine.name)),
        fmt::format("START {} lets it run beside the program", shortened(routine.name)));
    return {};
  }
  if (statement && routine.function) {
    diagnostics_.error(
        code::kRoutineMisused, place,
        fmt::format("{} is a FUNC, and its value is not used here", shortened(routine.name)),
        "assign it to a variable, or make it a PROC");
    return {};
  }
  if (!statement && !routine.function) {
    diagnostics_.error(code::kRoutineMisused, place,
                       fmt::format("{} is a PROC and has no value", shortened(routine.name)),
                       "write the call on a line of its own, or make it a FUNC");
    return {};
  }
  if (routine.sound && bind(call, place, routine)) {
    const std::vector<Parameter> parameters = parameters_of(routine);
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      if (call.bound[i] == nullptr) continue;
      check_argument(*call.bound[i], routine, *parameters[i].group, parameters[i].declared->name);
    }
  }
  return routine.result;
}

/// Finds the argument of each parameter: the unnamed ones in order, then those by name; null where
/// the default stands in.
bool CallChecker::bind(Call& call, Place place, const Routine& routine) {
  const std::vector<Parameter> parameters = parameters_of(routine);
  call.bound.assign(parameters.size(), nullptr);
  bool named = false;
  for (std::size_t i = 0; i < call.arguments.size(); ++i) {
    const Expr& argument = *call.arguments[i];
    const std::string& name = call.names[i];
    std::size_t at = i;
    if (name.empty() && named) {
      return refuse(code::kArgumentName, argument.place,
                    "an argument without name after one with a name",
                    "name it, too, or put it before the named ones");
    }
    if (!name.empty()) {
      named = true;
      for (at = 0; at < parameters.size(); ++at) {
        if (same_word(parameters[at].declared->name, name)) break;
      }
      std::vector<std::string_view> names;
      for (const Parameter& parameter : parameters) names.push_back(parameter.declared->name);
      if (at == parameters.size()) {
        return refuse(
            code::kArgumentName, argument.place,
            fmt::format("{} has no parameter {}", shortened(routine.name), shortened(name)),
            did_you_mean(suggest(name, names)));
      }
    }
    if (at < parameters.size() && call.references[i] && !parameters[at].group->by_reference) {
      return refuse(code::kReferenceArgument, argument.place,
                    fmt::format("{} of {} is no REF parameter",
                                shortened(parameters[at].declared->name), shortened(routine.name)),
                    "leave REF out");
    }
    if (at >= parameters.size()) {
      return refuse(
          code::kArgumentCount, place,
          fmt::format("{} has {} parameter{}; here are {} arguments", shortened(routine.name),
                      parameters.size(), parameters.size() == 1 ? "" : "s", call.arguments.size()));
    }
    if (call.bound[at] != nullptr) {
      return refuse(code::kArgumentName, argument.place,
                    fmt::format("{} is given twice", shortened(parameters[at].declared->name)));
    }
    call.bound[at] = &argument;
  }
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (call.bound[i] != nullptr || parameters[i].group->value != nullptr) continue;
    return refuse(code::kArgumentCount, place,
                  fmt::format("{} needs {}", shortened(routine.name),
                              shortened(parameters[i].declared->name)),
                  fmt::format("it is {}", in_words(parameters[i].group->type)));
  }
  return true;
}

bool CallChecker::refuse(std::string_view code, Place place, std::string message,
                         std::string help) {
  diagnostics_.error(code, place, std::move(message), std::move(help));
  return false;
}

bool CallChecker::check_argument(const Expr& argument, const Routine& routine,
                                 const Routine::Parameters& group, std::string_view name) {
  const std::string needs = fmt::format("{} of {} needs", shortened(name), shortened(routine.name));
  if (!group.by_reference && group.type.is(Type::Kind::List)) uses_.met_list(argument.place);
  if (!group.by_reference) return values_.accept(argument, group.type, needs);
  if (argument.type.kind == Type::Kind::Unknown || group.type.kind == Type::Kind::Unknown) {
    return false;
  }
  const Name* const variable = root_of(argument);
  const bool fits = variable != nullptr && variable->symbol != nullptr &&
                    variable->symbol->kind == Symbol::Kind::Variable &&
                    fits_reference(argument.type, group.type);
  if (fits) {
    uses_.referred(*variable->symbol, argument.place);
    return true;
  }
  const bool is_variable = variable != nullptr && variable->symbol != nullptr &&
                           variable->symbol->kind == Symbol::Kind::Variable;
  if (is_variable) {
    diagnostics_.error(code::kReferenceArgument, argument.place,
                       fmt::format("{} is {}; {} of {} is REF {}", shortened(place_text(argument)),
                                   as_written(argument.type), shortened(name),
                                   shortened(routine.name), as_written(group.type)),
                       fmt::format("a REF parameter takes a variable of its own type: VAR {}: {}",
                                   shortened(variable->text), as_written(group.type)));
    return false;
  }
  diagnostics_.error(code::kReferenceArgument, argument.place,
                     fmt::format("{} a variable here, {}, since it is REF {}; this is {} ({})",
                                 needs, in_words(group.type), as_written(group.type),
                                 described(argument), as_written(argument.type)),
                     "declare one with VAR and its type, and give its name");
  return false;
}

Type CallChecker::check_record(Call& call, Place place, const Type& record, bool statement) {
  const TypeDetail& detail = *record.detail;
  call.record = &detail;
  call.bound.assign(detail.fields.size(), nullptr);
  if (statement) {
    diagnostics_.error(
        code::kRoutineMisused, place,
        fmt::format("this makes a {}, which is not used here", shortened(detail.name)),
        "assign it to a variable");
    return {};
  }
  for (std::size_t i = 0; i < call.arguments.size(); ++i) {
    if (!bind_field(call, *call.arguments[i], call.names[i])) return record;
  }
  for (std::size_t i = 0; i < detail.fields.size(); ++i) {
    const TypeDetail::Field& field = detail.fields[i];
    if (call.bound[i] != nullptr || has_default(field.type)) continue;
    diagnostics_.error(code::kFieldNeeded, place,
                       fmt::format("{} needs {}: it is {}", shortened(detail.name),
                                   shortened(field.name), in_words(field.type)),
                       fmt::format("{}({}: …)", shortened(detail.name), shortened(field.name)));
    return record;
  }
  return record;
}

bool CallChecker::bind_field(Call& call, const Expr& value, const std::string& name) {
  const TypeDetail& detail = *call.record;
  if (name.empty()) {
    std::string help;
    if (!detail.fields.empty()) {
      help = fmt::format("{}({}: …)", shortened(detail.name), shortened(detail.fields[0].name));
    }
    diagnostics_.error(
        code::kFieldGiven, value.place,
        fmt::format("the fields of {} are given by their names", shortened(detail.name)), help);
    return false;
  }
  const std::size_t at = index_of(detail, name);
  if (at == detail.fields.size()) {
    if (detail.faulty) return false;
    const std::vector<std::string_view> names = field_names({Type::Kind::Record, {}, &detail});
    std::string help = did_you_mean(suggest(name, names));
    if (help.empty()) help = fmt::format("it has {}", fmt::join(names, ", "));
    diagnostics_.error(code::kNoSuchField, value.place,
                       fmt::format("{} has no field {}", shortened(detail.name), shortened(name)),
                       help);
    return false;
  }
  if (call.bound[at] != nullptr) {
    diagnostics_.error(code::kFieldGiven, value.place,
                       fmt::format("{} is given twice", shortened(detail.fields[at].name)),
                       "leave one of them out");
    return false;
  }
  call.bound[at] = &value;
  return values_.accept(value, detail.fields[at].type,
                        fmt::format("{} of {} needs", shortened(name), shortened(detail.name)));
}

}  // namespace rob::lang
