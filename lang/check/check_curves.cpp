#include <string>
#include <utility>

#include <fmt/core.h>

#include "lang/check/move_checker.h"
#include "lang/text/codes.h"

/// MOVEC, MOVES, SPIRAL and JOG, and the clauses that not every motion takes.
namespace rob::lang {
namespace {

constexpr Dimension kPerTime{.time = -1};

}  // namespace

bool MoveChecker::check_curve(const Move& move) {
  bool sound = true;
  for (const ExprPtr& point : move.via) sound = check_target(move, point) && sound;
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

bool MoveChecker::check_positive(const ExprPtr& value, const Type& wanted, std::string_view word) {
  if (!expressions_.check(value).known()) return false;
  if (!expressions_.accept(*value, wanted, fmt::format("{} needs", word))) return false;
  const auto number = constant_number(*value);
  if (!number || *number > 0) return true;
  diagnostics_.error(
      code::kNotPositive, value->place,
      fmt::format("{} needs a value above zero; this is {}", word, described(*value)));
  return false;
}

bool MoveChecker::check_spiral(const Move& move) {
  const bool radius = check_positive(move.radius, Type::real(kLength), "FROM");
  return check_positive(move.turns, Type::real(), "TURNS") && radius;
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
  if (!check_shape(tuple, wanted, move.target->place)) return false;
  const auto elements = by_coordinate(tuple, wanted);
  for (std::size_t i = 0; i < elements.size(); ++i) {
    if (elements[i] == nullptr) continue;
    const Expr& rate = *elements[i]->value;
    sound = rate.type.known() &&
            expressions_.accept(rate, Type::real(wanted[i].dimension * kPerTime),
                                fmt::format("{} of JOG needs", wanted[i].name)) &&
            sound;
  }
  return sound;
}

bool MoveChecker::refuse_clause(std::string_view clause, Place place, std::string message,
                                std::string help) {
  diagnostics_.error(code::kClauseMisplaced, place, fmt::format("{} {}", clause, message),
                     std::move(help));
  return false;
}

bool MoveChecker::check_clauses_of(const Move& move) {
  const Clauses& clauses = move.clauses;
  if (clauses.euler && move.kind != MotionKind::Line) {
    return refuse_clause("EULER", clauses.euler_place, "stands behind MOVEL alone",
                         "on a line the angles a, b, c can change evenly");
  }
  if (move.kind != MotionKind::Jog) {
    const ExprPtr& lasts = clauses[Clause::For];
    const ExprPtr& jerk = clauses[Clause::Jerk];
    if (lasts != nullptr)
      return refuse_clause("FOR", lasts->place, "stands behind JOG alone",
                           "OVER 3s gives another motion its time");
    return jerk == nullptr || clauses.profile != Profile::Rectangular ||
           refuse_clause("JERK", jerk->place,
                         "cannot be kept by PROFILE RECTANGULAR, whose acceleration comes at once",
                         "TRAPEZOIDAL, PARABOLIC and COSINE keep one");
  }
  const auto refuse = [&](std::string_view clause, Place place) {
    return refuse_clause(clause, place, "does not stand behind JOG, which has no target",
                         "its rates say how fast, FOR and UNTIL how long");
  };
  bool sound = true;
  if (clauses[Clause::Over]) sound = refuse("OVER", clauses[Clause::Over]->place);
  if (clauses[Clause::Zone]) sound = refuse("ZONE", clauses[Clause::Zone]->place);
  if (clauses.fine) sound = refuse("FINE", move.target->place);
  if (clauses.profile != Profile::Unspecified) sound = refuse("PROFILE", move.target->place);
  if (clauses.surroundings.has_frame()) {
    sound = refuse_clause("IN", clauses.surroundings.frame_place, "does not stand behind JOG",
                          "JOG WORLD and JOG TOOL say in which frame");
  }
  return sound;
}

}  // namespace rob::lang
