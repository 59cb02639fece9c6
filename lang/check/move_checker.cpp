#include "lang/check/move_checker.h"

#include <algorithm>
#include <string>
#include <utility>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "lang/check/fold.h"
#include "lang/syntax/parser.h"
#include "lang/text/codes.h"
#include "lang/text/suggest.h"

namespace rob::lang {
namespace {

constexpr Dimension kPerTime{.time = -1};

std::vector<std::string_view> names_of(const Coordinates& coordinates) {
  std::vector<std::string_view> names;
  for (const RobotSignature::Coordinate& coordinate : coordinates) {
    names.push_back(coordinate.name);
  }
  return names;
}

struct BarrierWord {
  std::string_view operator()(const Stop&) const { return "STOP"; }
  std::string_view operator()(const Wait&) const { return "WAIT"; }
  std::string_view operator()(const Halt&) const { return "HALT"; }
  std::string_view operator()(const Ask&) const { return "ASK"; }
  std::string_view operator()(const Read&) const { return "READ"; }
  std::string_view operator()(const Teach&) const { return "TEACH"; }
  std::string_view operator()(const ZeroForce&) const { return "ZERO"; }
  std::string_view operator()(const Move& move) const {  // one with a profile begins at rest
    return move.clauses.profile == Profile::Unspecified ? "" : "PROFILE";
  }
  std::string_view operator()(const WatchedMotion& watched) const {
    return std::visit(*this, watched.motion.front().node);
  }
  std::string_view operator()(const auto& /*leaves the corner*/) const { return {}; }
};

/// The word of a statement that makes the motion before it exact; empty for all others.
std::string_view barrier(const Statement& statement) {
  return std::visit(BarrierWord{}, statement.node);
}

bool has_motion(const Block& block);

struct MotionSearch {
  bool operator()(const Move&) const { return true; }
  bool operator()(const WatchedMotion&) const { return true; }
  bool operator()(const If& conditional) const {
    return has_motion(conditional.otherwise) ||
           std::ranges::any_of(conditional.branches,
                               [](const If::Branch& branch) { return has_motion(branch.body); });
  }
  bool operator()(const For& loop) const { return has_motion(loop.body); }
  bool operator()(const auto& /*other*/) const { return false; }
};

/// Whether a block holds a motion, in blocks inside of it too.
bool has_motion(const Block& block) {
  return std::ranges::any_of(
      block, [](const Statement& statement) { return std::visit(MotionSearch{}, statement.node); });
}

}  // namespace

std::optional<PlainTargets::Target> PlainTargets::of(const PlainMotion& motion,
                                                     std::uint32_t file) {
  if (units_.empty() || file_ != file) {
    units_.clear();
    file_ = file;
    for (const RobotSignature::Coordinate& coordinate : robot_.coordinates) {
      units_.push_back(default_unit(coordinate.dimension, robot_, file));
    }
  }
  // Six axes: (x, y, z) keeps the orientation.
  const auto count = static_cast<int>(units_.size());
  if (motion.count != count && (count != 6 || motion.count != 3)) return std::nullopt;
  Target target;
  for (std::size_t i = 0; i < static_cast<std::size_t>(motion.count); ++i) {
    const PlainMotion::Component& component = motion.components[i];
    if (component.number.empty()) continue;
    const Unit unit = component.unit.value_or(units_[i]);
    if (unit.dimension != units_[i].dimension) return std::nullopt;
    const auto quantity = quantity_of(component.number, unit);
    if (!quantity) return std::nullopt;
    const double value = to_si(*quantity, unit.dimension);
    target.values[i] = component.negative ? 0 - value : value;
    target.given = static_cast<std::uint8_t>(target.given | 1U << i);
  }
  return target;
}

void MoveChecker::check(const Move& move, Place place, bool guarded) {
  bool sound = check_way(move, place, guarded);
  sound = clauses_.check(move.clauses, place) && check_clauses_of(move) && sound;
  remember_features(move, place);
  if (sound && move.clauses.live) {
    watches_.check_live(*move.clauses[Clause::At]);
  }
  if (sound) judge_constants(move);
}

/// A faulty one is read once more, as a tree, which reports its mistakes.
void MoveChecker::check(PlainMotions& motions) {
  motions.values.reserve(motions.motions.size() * robot_.coordinates.size() +
                         motions.paces_and_zones.size());
  auto clause = motions.paces_and_zones.cbegin();
  bool leads = false;  // there may be a million: the first is named
  for (PlainMotions::Written& motion : motions.motions) {
    const bool settled = settle(motions, motion);
    const int clauses = (motion.pace != MoveCommand::Pace::Unspecified ? 1 : 0) +
                        (motion.zone != MoveCommand::Zone::Unspecified ? 1 : 0);
    motions.values.insert(motions.values.end(), clause, clause + clauses);
    clause += clauses;
    if (settled) {
      if (motion.kind != MotionKind::Joint && !std::exchange(leads, true))
        checked_.features.push_back({motions.place(motion), MotionFeature::Lead});
      continue;
    }
    const Place place = motions.place(motion);
    for (const Statement& statement :
         parse_line(motions.source, motion.offset, place, diagnostics_)) {
      check(std::get<Move>(statement.node), place, false);
    }
  }
}

// The way to the target

/// The way from where the motion begins to where it ends.
bool MoveChecker::check_way(const Move& move, Place place, bool guarded) {
  switch (move.kind) {
    case MotionKind::Arc:
    case MotionKind::Spline:
      return check_curve(move);
    case MotionKind::Spiral:
      return check_spiral(move);
    case MotionKind::Jog:
      return check_jog(move, place, guarded);
    case MotionKind::Joint:
    case MotionKind::Line:
      break;
  }
  if (move.axis != nullptr) return check_joint(move);
  return move.target != nullptr && check_target(move, move.target);
}

/// MOVE JOINT: which axis must be known, unless all take values of one dimension.
bool MoveChecker::check_joint(const Move& move) {
  const Type type = expressions_.check(move.axis);
  expressions_.check(move.target);
  if (type.kind == Type::Kind::Unknown ||
      !values_.accept(*move.axis, Type::integer(), "the axis of MOVE JOINT must be")) {
    return false;
  }
  const auto* const number = std::get_if<std::int64_t>(&move.axis->constant);
  const auto count = static_cast<std::int64_t>(robot_.axes.size());
  if (number == nullptr && !alike(robot_.axes)) {
    diagnostics_.error(
        code::kAxisNotConstant, move.axis->place,
        fmt::format("the axes of {} are of different kinds: which one is meant has to"
                    " be a constant",
                    robot_.name),
        fmt::format("write a number from 1 to {}", count));
    return false;
  }
  if (number != nullptr && (*number < 1 || *number > count)) {
    diagnostics_.error(code::kNoSuchAxis, move.axis->place,
                       fmt::format("{} has no axis {}", robot_.name, *number),
                       fmt::format("it has axes 1 to {}", count));
    return false;
  }
  const auto& axis =
      number == nullptr ? robot_.axes.front() : robot_.axes[static_cast<std::size_t>(*number - 1)];
  return move.target->type.kind != Type::Kind::Unknown &&
         values_.accept(
             *move.target, Type::real(axis.dimension),
             number == nullptr ? "each axis needs" : fmt::format("axis {} needs", axis.name));
}

bool MoveChecker::check_curve(const Move& move) {
  bool sound = true;
  for (const ExprPtr& point : move.via) sound = check_via(move, point) && sound;
  if (move.target == nullptr || !check_target(move, move.target) || !sound) return false;
  return check_alike(move);
}

/// MOVES goes through joints, or through places.
bool MoveChecker::check_alike(const Move& move) {
  const auto is_joints = [](const ExprPtr& point) { return point->type.is(Type::Kind::Joints); };
  for (const ExprPtr& point : move.via) {
    if (is_joints(point) == is_joints(move.target)) continue;
    const Expr& joints = is_joints(point) ? *point : *move.target;
    diagnostics_.error(code::kNoTarget, joints.place,
                       "MOVES goes through joints or through places, not through both",
                       "FORWARD(j) is the place that the joints j bring the tool to");
    return false;
  }
  return true;
}

bool MoveChecker::check_spiral(const Move& move) {
  const auto check = [&](const ExprPtr& value, const Type& wanted, std::string_view word) {
    return expressions_.check_as(value, wanted, fmt::format("{} needs", word)) &&
           value->type.known() && values_.require_positive(*value, word);
  };
  const bool radius = check(move.radius, Type::real(kLength), "FROM");
  return check(move.turns, Type::real(), "TURNS") && radius;
}

/// Its tuple are rates: what is left out stands still, and bare numbers have no unit to take.
bool MoveChecker::check_jog(const Move& move, Place place, bool guarded) {
  bool sound = guarded || move.clauses[Clause::For] != nullptr;
  if (!sound) {
    diagnostics_.error(code::kJogWithoutEnd, place, "this JOG never ends",
                       "FOR says how long it lasts, UNTIL what ends it");
  }
  const auto& tuple = std::get<Tuple>(move.target->node);
  for (const Tuple::Element& element : tuple.elements) expressions_.check(element.value);
  const Coordinates& wanted = jogged(move.jog, robot_);
  if (!check_shape(tuple, wanted, wanted, move.target->place)) return false;
  const auto elements = by_coordinate(tuple, wanted);
  for (std::size_t i = 0; i < elements.size(); ++i) {
    if (elements[i] == nullptr) continue;
    const Expr& rate = *elements[i]->value;
    sound = rate.type.known() &&
            values_.accept(rate, Type::real(wanted[i].dimension * kPerTime),
                           fmt::format("{} of JOG needs", wanted[i].name)) &&
            sound;
  }
  return sound;
}

// Targets

bool MoveChecker::check_target(const Move& move, const ExprPtr& point) {
  const Expr& target = *point;
  const auto* const tuple = std::get_if<Tuple>(&target.node);
  if (tuple == nullptr) return check_value(move, point);
  // Checked whatever the shape of the tuple, so that all mistakes inside are found at once.
  for (const Tuple::Element& element : tuple->elements) expressions_.check(element.value);
  if (!check_shape(*tuple, robot_.coordinates, elements_, target.place)) return false;
  bool sound = true;
  const auto elements = by_coordinate(*tuple, elements_);
  for (std::size_t i = 0; i < elements.size(); ++i) {
    if (elements[i] == nullptr) continue;
    sound = check_component(word_of(move.kind), *elements[i], i) && sound;
  }
  return sound;
}

/// A gripper goes evenly from the beginning of a curve to its end.
bool MoveChecker::check_via(const Move& move, const ExprPtr& point) {
  if (!check_target(move, point)) return false;
  const auto* const tuple = std::get_if<Tuple>(&point->node);
  if (tuple == nullptr) return true;
  for (const Tuple::Element& element : tuple->elements) {
    if (!names_gripper(element)) continue;
    diagnostics_.error(code::kGripperOnTheWay, element.place,
                       fmt::format("{} cannot be given a value on the way: it goes to that of TO "
                                   "along the whole curve",
                                   shortened(element.name)),
                       "leave it out after VIA");
    return false;
  }
  return true;
}

bool MoveChecker::names_gripper(const Tuple::Element& element) const {
  return !element.name.empty() && coordinate_named(robot_.grippers, element.name).has_value();
}

/// Gripper axes are named, after components with or without names.
bool MoveChecker::check_shape(const Tuple& tuple, const Coordinates& in_place,
                              const Coordinates& all, Place place) {
  const auto& elements = tuple.elements;
  const auto named = [](const Tuple::Element& element) { return !element.name.empty(); };
  if (std::ranges::all_of(elements, named)) return check_names(tuple, all);
  const auto first = std::ranges::find_if(elements, named);
  const bool mixed = !std::all_of(
      first, elements.end(), [&](const Tuple::Element& element) { return names_gripper(element); });
  if (!mixed) {
    const auto count = static_cast<std::size_t>(first - elements.begin());
    return check_count(count, in_place, place) && check_names(tuple, all);
  }
  diagnostics_.error(code::kMixedComponents, place, "some components are named and some are not",
                     "name all of them, or none");
  return false;
}

bool MoveChecker::check_count(std::size_t given, const Coordinates& coordinates, Place place) {
  const std::size_t wanted = coordinates.size();
  // Six axes: (x, y, z) keeps the orientation.
  if (given == wanted || (wanted == 6 && given == 3)) return true;
  const bool hand = given == wanted + robot_.grippers.size() && given > wanted;
  diagnostics_.error(
      code::kComponentCount, place,
      fmt::format("a target of {} has {} components ({}); here are {}", robot_.name, wanted,
                  fmt::join(names_of(coordinates), ", "), given),
      hand ? fmt::format("a gripper axis is named, as in (…, {}: 60deg); JOINTS(…) has all axes",
                         robot_.grippers.front().name)
      : given == 1
          ? "a pose stands without parentheses, as in MOVE pick; one component, as in (140, , )"
      : given < wanted
          ? "leave a place empty to keep its value, as in (140, , ), or name components"
          : "decimals are written with a point, as in 1.5");
  return false;
}

bool MoveChecker::check_names(const Tuple& tuple, const Coordinates& coordinates) {
  std::vector<bool> given(coordinates.size(), false);
  bool sound = true;
  for (const Tuple::Element& element : tuple.elements) {
    if (element.name.empty()) continue;
    const auto coordinate = coordinate_named(coordinates, element.name);
    if (!coordinate) {
      report_no_coordinate(element, coordinates);
      sound = false;
    } else if (given[*coordinate]) {
      diagnostics_.error(code::kComponentTwice, element.place,
                         fmt::format("{} is given twice", coordinates[*coordinate].name));
      sound = false;
    } else {
      given[*coordinate] = true;
    }
  }
  return sound;
}

/// An axis of the arm is no coordinate of its tool.
void MoveChecker::report_no_coordinate(const Tuple::Element& element,
                                       const Coordinates& coordinates) {
  const auto axis = coordinate_named(robot_.axes, element.name);
  const std::string meant = did_you_mean(suggest(element.name, names_of(coordinates)));
  diagnostics_.error(
      code::kUnknownComponent, element.place,
      fmt::format("{} has no coordinate {}", robot_.name, shortened(element.name)),
      axis ? fmt::format("it is axis {0}: MOVE JOINT {0} TO moves it alone, or BY", *axis + 1)
      : meant.empty() ? fmt::format("it has {}", fmt::join(names_of(coordinates), ", "))
                      : meant);
}

bool MoveChecker::check_component(std::string_view word, const Tuple::Element& element,
                                  std::size_t coordinate) {
  const RobotSignature::Coordinate& wanted = elements_[coordinate];
  const Expr& value = *element.value;
  if (value.type.kind == Type::Kind::Unknown) return false;
  if (!is_bare(value.type)) {
    return values_.accept(value, Type::real(wanted.dimension),
                          fmt::format("{} of {} needs", wanted.name, word));
  }
  if (!known(value.constant) || constant_component(value, wanted.dimension, robot_)) return true;
  diagnostics_.error(code::kNotFinite, value.place, "this is beyond the range of numbers");
  return false;
}

bool MoveChecker::check_value(const Move& move, const ExprPtr& point) {
  const Expr& target = *point;
  const Type type = expressions_.check(point);
  if (!type.known()) return false;
  const std::string_view word = word_of(move.kind);
  if (type.is_place() && !move.by) {
    const Symbol* const taught = bare_point(move);
    if (taught != nullptr) checked_.symbols[taught->id].moved_to = true;
    if (taught == nullptr && move.kind == MotionKind::Joint && !known(known_value(target)))
      checked_.features.push_back({target.place, MotionFeature::Lead});
    return values_.accept(target, Type::pose(), fmt::format("{} needs", word)) &&
           check_frame(move, target);
  }
  if (type == Type::vec(kLength) && move.by) return true;
  const bool in_axes = move.kind == MotionKind::Joint || move.kind == MotionKind::Spline;
  if (type.is(Type::Kind::Joints) && !move.by && in_axes) return true;
  report_no_target(move, target);
  return false;
}

/// A pose that has a frame keeps it: IN must not name another.
bool MoveChecker::check_frame(const Move& move, const Expr& target) {
  const Surroundings& around = move.clauses.surroundings;
  const Type pose = as_pose(target.type);
  if (!around.has_frame() || is_free(pose)) return true;
  if (around.frame != nullptr) {
    const auto& name = std::get<Name>(around.frame->node);
    const Symbol* const symbol = names_.find(name.text);
    const bool world = symbol != nullptr && symbol->kind == Symbol::Kind::BuiltIn;
    if (symbol == nullptr || !symbol->type.is(Type::Kind::Frame))
      return true;  // reported elsewhere
    if (world ? pose == Type::pose() : symbol->frame != nullptr && symbol->frame == pose.detail) {
      return true;
    }
  }
  diagnostics_.error(code::kFrames, target.place,
                     fmt::format("this is {}, and IN names another frame", described(target)),
                     "leave IN out, or give components, or a POSE(…) without a frame");
  return false;
}

void MoveChecker::report_no_target(const Move& move, const Expr& target) {
  const Type& type = target.type;
  const std::string_view word = word_of(move.kind);
  if (type.is(Type::Kind::Joints)) {
    diagnostics_.error(
        code::kNoTarget, target.place,
        fmt::format("{}{} does not take a value for each joint", word, move.by ? " BY" : ""),
        move.by ? "MOVE j + k goes to the sum of two"
                : fmt::format("MOVE j goes to the joints j, {} FORWARD(j) to the "
                              "place that they bring the tool to",
                              word));
    return;
  }
  if (move.by) {
    diagnostics_.error(code::kNoTarget, target.place,
                       fmt::format("{} BY needs components or a VEC of lengths; this is {}", word,
                                   described(target)),
                       type.is_place()
                           ? fmt::format("{} p * q goes to the pose q as seen from p", word)
                           : fmt::format("{} BY (20mm, 0mm, 0deg)", word));
    return;
  }
  const bool shift = type.is(Type::Kind::Vec) && move.via.empty();
  diagnostics_.error(code::kNoTarget, target.place,
                     fmt::format("{} needs components in parentheses or a pose; this is {}", word,
                                 described(target)),
                     shift ? fmt::format("{} BY v shifts the tool by a VEC", word)
                           : fmt::format("{}(140, 40, 0)", move.via.empty() ? word : "MOVE"));
}

bool MoveChecker::settle(PlainMotions& motions, PlainMotions::Written& motion) {
  const auto read =
      read_plain_target(motions.source.substr(motion.offset), word_of(motion.kind).size());
  const auto target = read ? plain_.of(*read, motions.file) : std::nullopt;
  if (!target) return false;
  const MoveCommand command{.kind = motion.kind,
                            .count = static_cast<int>(elements_.size()),
                            .given = target->given,
                            .target = target->values};
  if (target->given != 0 && places_are_known() && judge_ && judge_(command)) return false;
  motion.given = target->given;
  for (std::size_t i = 0; i < command.target.size(); ++i) {
    if (command.has(static_cast<int>(i))) motions.values.push_back(command.target[i]);
  }
  return true;
}

// Clauses that not every motion takes, features that not every robot has

bool MoveChecker::check_clauses_of(const Move& move) {
  const Clauses& clauses = move.clauses;
  if (clauses.euler && move.kind != MotionKind::Line) {
    return refuse_clause("EULER", clauses.euler_place, "stands after MOVEL alone",
                         "on a line the angles a, b, c can change evenly");
  }
  if (!check_choice(move)) return false;
  if (move.kind == MotionKind::Jog) return check_clauses_of_jog(move);
  const ExprPtr& lasts = clauses[Clause::For];
  const ExprPtr& jerk = clauses[Clause::Jerk];
  if (lasts != nullptr)
    return refuse_clause("FOR", lasts->place, "stands after JOG alone",
                         "OVER 3s gives another motion its time");
  return jerk == nullptr || clauses.profile != Profile::Rectangular ||
         refuse_clause("JERK", jerk->place,
                       "cannot be kept by PROFILE RECTANGULAR, whose acceleration comes at once",
                       "TRAPEZOIDAL, PARABOLIC and COSINE keep one");
}

/// NEAR and FREE choose among the joints that bring the tool to a pose.
bool MoveChecker::check_choice(const Move& move) {
  const Clauses& clauses = move.clauses;
  const bool near = clauses.near != nullptr;
  if (!near && clauses.free == FreeTurn::None) return true;
  const std::string_view word = near ? "NEAR" : "FREE";
  const Place place = near ? clauses.near_place : clauses.free_place;
  const bool pose = move.kind <= MotionKind::Spline && move.axis == nullptr;
  if (!pose)
    return refuse_clause(word, place, "stands after MOVE, MOVEL, MOVEC and MOVES to a pose alone",
                         "only there is anything to choose");
  if (move.target != nullptr && move.target->type.is(Type::Kind::Joints))
    return refuse_clause(word, place, "does not stand after joints, which leave nothing to choose",
                         "MOVE FORWARD(j) goes to the pose that the joints j bring the tool to");
  if (clauses.euler && clauses.free != FreeTurn::None)
    return refuse_clause("FREE", clauses.free_place, "does not stand with EULER",
                         "EULER says how a, b and c change; leave one of the two out");
  return true;
}

bool MoveChecker::check_clauses_of_jog(const Move& move) {
  const Clauses& clauses = move.clauses;
  const auto refuse = [&](std::string_view clause, Place place) {
    return refuse_clause(clause, place, "does not stand after JOG, which has no target",
                         "its rates say how fast, FOR and UNTIL how long");
  };
  bool sound = true;
  if (clauses[Clause::Over]) sound = refuse("OVER", clauses[Clause::Over]->place);
  if (clauses[Clause::Zone]) sound = refuse("ZONE", clauses[Clause::Zone]->place);
  if (clauses.fine) sound = refuse("FINE", move.target->place);
  if (clauses.profile != Profile::Unspecified) sound = refuse("PROFILE", move.target->place);
  if (clauses.surroundings.has_frame()) {
    sound = refuse_clause("IN", clauses.surroundings.frame_place, "does not stand after JOG",
                          "JOG WORLD and JOG TOOL say in which frame");
  }
  return sound;
}

bool MoveChecker::refuse_clause(std::string_view clause, Place place, std::string message,
                                std::string help) {
  diagnostics_.error(code::kClauseMisplaced, place, fmt::format("{} {}", clause, message),
                     std::move(help));
  return false;
}

void MoveChecker::remember_features(const Move& move, Place place) {
  const bool joints = move.kind == MotionKind::Spline && move.target != nullptr &&
                      move.target->type.is(Type::Kind::Joints);
  const bool in_axes = move.kind == MotionKind::Jog ? move.jog == JogFrame::Joint
                                                    : move.kind == MotionKind::Joint || joints;
  if (!in_axes) checked_.features.push_back({place, MotionFeature::Lead});
  const Clauses& clauses = move.clauses;
  const ExprPtr& accel = clauses[Clause::Accel];
  const ExprPtr& jerk = clauses[Clause::Jerk];
  if (accel) checked_.features.push_back({accel->place, MotionFeature::Accel});
  if (jerk) checked_.features.push_back({jerk->place, MotionFeature::Jerk});
  if (clauses.near) checked_.features.push_back({clauses.near_place, MotionFeature::Lead});
  if (clauses.free != FreeTurn::None)
    checked_.features.push_back({clauses.free_place, clauses.free == FreeTurn::C
                                                         ? MotionFeature::FreeC
                                                         : MotionFeature::FreeSpin});
}

void MoveChecker::warn_of_zones(const Block& block) {
  for (std::size_t i = 0; i < block.size(); ++i) {
    if (const auto* const plain = std::get_if<PlainMotions>(&block[i].node)) {
      if (i + 1 < block.size()) warn_of_last_zone(*plain, block[i + 1]);
      continue;
    }
    const auto* const watched = std::get_if<WatchedMotion>(&block[i].node);
    const bool guarded = watched != nullptr && watched->until != nullptr;
    const Statement& statement = watched != nullptr ? watched->motion.front() : block[i];
    const auto* const move = std::get_if<Move>(&statement.node);
    if (move == nullptr || move->clauses[Clause::Zone] == nullptr) continue;
    const Expr& zone = *move->clauses[Clause::Zone];
    const Statement* const next = i + 1 < block.size() ? &block[i + 1] : nullptr;
    if (constant_number(zone) == 0.0) continue;
    if (guarded) {
      warn_of_zone(zone.place, "UNTIL", statement.place);
    } else if (move->clauses.profile != Profile::Unspecified) {
      warn_of_zone(zone.place, "PROFILE", statement.place);
    } else if (next != nullptr && !barrier(*next).empty()) {
      warn_of_zone(zone.place, barrier(*next), next->place);
    }
  }
}

void MoveChecker::warn_of_last_zone(const PlainMotions& motions, const Statement& next) {
  const PlainMotions::Written& last = motions.motions.back();
  if (last.zone == MoveCommand::Zone::Unspecified || barrier(next).empty()) return;
  const auto read =
      read_plain_motion(motions.source.substr(last.offset), word_of(last.kind).size());
  const auto column = static_cast<std::uint32_t>(last.column + read->zone_offset);
  const std::string_view number = motions.source.substr(last.offset + read->zone_offset);
  const std::size_t length = std::min(number.find_first_of(" \t\r\n/"), number.size());
  warn_of_zone({last.line, column, static_cast<std::uint32_t>(length), motions.file}, barrier(next),
               next.place);
}

void MoveChecker::warn_of_zone(Place zone, std::string_view word, Place place) {
  diagnostics_.warning(
      code::kZoneWithoutCorner, zone,
      fmt::format("the {} of line {} makes this target exact: ZONE has no corner to bound", word,
                  place.line),
      "leave ZONE out, or write FINE");
}

// Whether the robot can go there

/// With another tool or frame a constant target is not a place that is known here, and a routine
/// may be called with any.
bool MoveChecker::places_are_known() const {
  return surroundings_ == 0 && !(in_routine_ && checked_.program.surroundings);
}

void MoveChecker::judge_constants(const Move& move) {
  if (!places_are_known() || !move.clauses.surroundings.none()) return;
  if (move.by || move.target == nullptr || move.kind == MotionKind::Jog) return;
  if (move.axis == nullptr) {
    MoveCommand asked;
    asked.free = move.clauses.free;
    if (asked.free == FreeTurn::C) asked.free_axis = frame_axis(move);
    for (const ExprPtr& point : move.via) judge_target(asked, *point, nullptr);
    return judge_target(asked, *move.target, bare_point(move));
  }
  const auto number = constant_number(*move.axis);
  if (!number) return;
  const auto axis = static_cast<std::size_t>(*number - 1);
  MoveCommand command;
  command.means = MoveCommand::Target::Axes;
  command.count = static_cast<int>(robot_.axes.size());
  keep_component(command, axis, *move.target, robot_.axes[axis].dimension);
  if (command.given != 0) judge(command, move.target->place);
}

/// `command`: what it says beside its target.
void MoveChecker::judge_target(MoveCommand command, const Expr& target, const Symbol* point) {
  const auto* const tuple = std::get_if<Tuple>(&target.node);
  if (tuple == nullptr) return judge_value(command, target, point);
  const auto elements = by_coordinate(*tuple, elements_);
  command.count = static_cast<int>(elements.size());
  for (std::size_t i = 0; i < elements.size(); ++i) {
    if (elements[i] == nullptr) continue;
    keep_component(command, i, *elements[i]->value, elements_[i].dimension);
  }
  if (command.given != 0) judge(command, target.place);
}

/// `point`: where the target is a bare POINT.
void MoveChecker::judge_value(MoveCommand command, const Expr& target, const Symbol* point) {
  const bool by_joints = point != nullptr && known(point->value) && point->flange_joints;
  const Constant value = by_joints ? Constant(point->joints) : known_value(target);
  const auto* const slots = std::get_if<std::vector<double>>(&value);
  if (slots == nullptr) return;
  const bool axes = by_joints || target.type.is(Type::Kind::Joints);
  command.means = axes ? MoveCommand::Target::Axes : MoveCommand::Target::Pose;
  command.count = static_cast<int>(slots->size());
  command.given = given_all(command.count);
  for (std::size_t i = 0; i < slots->size(); ++i) {
    const Dimension dimension = axes ? robot_.axes[i].dimension : i < 3 ? kLength : kNone;
    command.target[i] = to_si((*slots)[i], dimension);
  }
  judge(command, target.place);
}

void MoveChecker::keep_component(MoveCommand& command, std::size_t i, const Expr& value,
                                 Dimension dimension) const {
  const auto known = constant_component(value, dimension, robot_);
  if (!known) return;
  command.target[i] = to_si(*known, dimension);
  command.given = static_cast<std::uint8_t>(command.given | 1U << i);
}

/// A target that is known beforehand is looked at before anything moves.
void MoveChecker::judge(const MoveCommand& command, Place place) {
  const auto refusal = judge_ ? judge_(command) : std::nullopt;
  if (refusal) diagnostics_.error(refusal->code, place, refusal->message, refusal->help);
}

// PATH

void PathChecker::check_clauses(const Clauses& clauses, Place place) {
  const char* const word = clauses.profile != Profile::Unspecified ? "PROFILE"
                           : clauses[Clause::For] != nullptr       ? "FOR"
                           : clauses.euler                         ? "EULER"
                           : clauses.near != nullptr               ? "NEAR"
                           : clauses.free != FreeTurn::None        ? "FREE"
                                                                   : nullptr;
  if (word == nullptr) return;
  diagnostics_.error(code::kClauseMisplaced, place,
                     fmt::format("{} does not stand after PATH", word),
                     "AT, OVER, ACCEL, JERK, ZONE and FINE do: for each motion in it");
}

/// Motions, AFTER and BEFORE, assignments, IF and FOR may stand there: all else would have to wait
/// for the path that it belongs to.
void PathChecker::check(const Statement& statement) {
  if (!inside_) return;
  if (const auto* const move = std::get_if<Move>(&statement.node)) {
    check(*move, statement.place);
  } else if (const auto* const conditional = std::get_if<If>(&statement.node)) {
    for (const If::Branch& branch : conditional->branches) note(branch.condition);
  } else if (const auto* const loop = std::get_if<For>(&statement.node)) {
    for (const ExprPtr* value : {&loop->elements, &loop->from, &loop->to, &loop->step}) {
      note(*value);
    }
  } else if (const auto* const assign = std::get_if<Assign>(&statement.node)) {
    const auto* const name = std::get_if<Name>(&assign->target->node);
    const bool signal =
        name != nullptr && name->symbol != nullptr && name->symbol->kind == Symbol::Kind::Signal;
    if (signal) return refuse(statement.place, "AFTER 0mm : lift = ON does it on the way");
    note(assign->value);
  } else if (std::holds_alternative<WatchedMotion>(statement.node)) {
    refuse(statement.place,
           "AFTER and BEFORE stand in the PATH itself, and count along it; UNTIL ends one motion");
  } else if (!std::holds_alternative<WayPoint>(statement.node)) {
    refuse(statement.place,
           "motions stand there, AFTER and BEFORE, assignments to variables, IF and FOR");
  }
}

void PathChecker::refuse(Place place, std::string_view help) {
  diagnostics_.error(code::kNotInPath, place,
                     "this cannot stand in a PATH, which is planned as one before it starts",
                     std::string(help));
}

void PathChecker::check(const Move& move, Place place) {
  note(move.target);
  for (const ExprPtr& point : move.via) note(point);
  for (const ExprPtr& value : move.clauses.values) note(value);
  note(move.clauses.near);
  const bool jog = move.kind == MotionKind::Jog;
  if (jog || move.clauses.profile != Profile::Unspecified) {
    diagnostics_.error(code::kNotInPath, place,
                       fmt::format("{} cannot stand in a PATH, which runs on without a rest",
                                   jog ? "JOG" : "PROFILE"),
                       jog ? "it has no target" : "leave it out here");
  } else if (move.clauses.surroundings.tool != nullptr) {
    diagnostics_.error(code::kNotInPath, move.clauses.surroundings.tool->place,
                       "one tool goes along the whole PATH", "PATH WITH tool DO");
  }
}

void PathChecker::note(const WayPoint& event) {
  note(event.distance);
  note(event.shift);
}

void PathChecker::note(const ExprPtr& value) {
  if (value != nullptr) values_.push_back(value.get());
}

/// A global that a TASK changes counts as read from the robot.
void PathChecker::report_reads() {
  for (const Expr* const value : values_) {
    if (observations(*value) == 0) continue;
    diagnostics_.error(code::kReadInPath, value->place,
                       "a PATH is planned before it starts: what is read from the robot here would "
                       "come too early",
                       "give it a variable before PATH");
  }
}

void PathChecker::warn_of_empty(const PathBlock& path, Place place) {
  if (has_motion(path.body)) return;
  diagnostics_.warning(code::kPathWithoutMotion, place, "this PATH has no motion",
                       "motions between PATH and ENDPATH are planned as one");
}

}  // namespace rob::lang
