#include <algorithm>
#include <string>
#include <utility>

#include <fmt/core.h>

#include "lang/check/observations.h"
#include "lang/check/statement_checker.h"
#include "lang/check/target.h"
#include "lang/text/codes.h"

/// Member functions of StatementChecker for WITH, PATH and PRESS.
namespace rob::lang {
namespace {

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

void StatementChecker::check(With& with) {
  clauses_.check(with.surroundings);
  moves_.enter_surroundings();
  check(with.body);
  moves_.leave_surroundings();
}

void StatementChecker::check_watched(WatchedMotion& watched) {
  const auto& move = std::get<Move>(watched.motion.front().node);
  moves_.check(move, place_, watched.until != nullptr);
  if (watched.until == nullptr && watched.events.empty()) {
    diagnostics_.warning(code::kNoEvents, place_, "nothing is done on the way of this motion",
                         "leave DO and ENDMOVE out, or write AFTER 5mm : lift = ON between them");
  }
  if (move.kind != MotionKind::Jog || watched.events.empty()) return;
  diagnostics_.error(code::kClauseMisplaced, watched.events.front().place,
                     "a JOG has no length on which a place could lie",
                     "set or pulse it before or behind the JOG");
}

void StatementChecker::check(WayPoint& event) {
  const bool path = std::exchange(in_path_, false);  // the action is done on the way
  check(event.action);
  in_path_ = path;
  watches_.check_event(event);
  for (const ExprPtr* value : {&event.distance, &event.shift}) check_not_read(*value);
}

void StatementChecker::check(PathBlock& path) {
  const Place place = place_;
  features_.push_back({place, MotionFeature::Path});
  clauses_.check(path.clauses, place);
  check_path_clauses(path.clauses, place);
  const bool outer = in_path_;  // told by the PATH around it
  in_path_ = true;
  const int loops = std::exchange(inside_.loops, 0);
  moves_.enter_surroundings();
  const bool in_path = uses_.in_path(true);
  check(path.body);
  uses_.in_path(in_path);
  moves_.leave_surroundings();
  inside_.loops = loops;
  in_path_ = outer;
  if (has_motion(path.body)) return;
  diagnostics_.warning(code::kPathWithoutMotion, place, "this PATH has no motion",
                       "motions between PATH and ENDPATH are planned as one");
}

void StatementChecker::check_path_clauses(const Clauses& clauses, Place place) {
  if (clauses.live) watches_.check_live(*clauses[Clause::At]);
  const char* const word = clauses.profile != Profile::Unspecified ? "PROFILE"
                           : clauses[Clause::For] != nullptr       ? "FOR"
                           : clauses.euler                         ? "EULER"
                                                                   : nullptr;
  if (word == nullptr) return;
  diagnostics_.error(code::kClauseMisplaced, place,
                     fmt::format("{} does not stand behind PATH", word),
                     "AT, OVER, ACCEL, JERK, ZONE and FINE do: for each motion in it");
}

/// What is not a motion, a place, an assignment, IF or FOR would have to wait for the path that it
/// belongs to.
void StatementChecker::check_in_path(const Statement& statement) {
  const auto refuse = [&](std::string_view help) {
    diagnostics_.error(code::kNotInPath, statement.place,
                       "this cannot stand in a PATH, which is planned as one before it starts",
                       std::string(help));
  };
  if (const auto* const move = std::get_if<Move>(&statement.node)) {
    return check_motion_in_path(*move, statement.place);
  }
  if (const auto* const conditional = std::get_if<If>(&statement.node)) {
    for (const If::Branch& branch : conditional->branches) check_not_read(branch.condition);
  } else if (const auto* const loop = std::get_if<For>(&statement.node)) {
    for (const ExprPtr* value : {&loop->from, &loop->to, &loop->step}) check_not_read(*value);
  } else if (const auto* const assign = std::get_if<Assign>(&statement.node)) {
    const auto* const name = std::get_if<Name>(&assign->target->node);
    const bool signal =
        name != nullptr && name->symbol != nullptr && name->symbol->kind == Symbol::Kind::Signal;
    if (signal) return refuse("AFTER 0mm : lift = ON does it on the way");
    check_not_read(assign->value);
  } else if (std::holds_alternative<WatchedMotion>(statement.node)) {
    refuse("AFTER and BEFORE stand in the PATH itself, and count along it; UNTIL ends one motion");
  } else if (!std::holds_alternative<WayPoint>(statement.node)) {
    refuse("motions stand there, AFTER and BEFORE, assignments to variables, IF and FOR");
  }
}

void StatementChecker::check_motion_in_path(const Move& move, Place place) {
  check_not_read(move.target);
  for (const ExprPtr& point : move.via) check_not_read(point);
  for (const ExprPtr& value : move.clauses.values) check_not_read(value);
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

void StatementChecker::check_not_read(const ExprPtr& value) {
  if (value != nullptr) path_values_.push_back(value.get());
}

/// A global that a TASK changes counts as read from the robot.
void StatementChecker::report_reads_in_paths() {
  for (const Expr* const value : path_values_) {
    if (observations(*value) == 0) continue;
    diagnostics_.error(code::kReadInPath, value->place,
                       "a PATH is planned before it starts: what is read from the robot here would "
                       "come too early",
                       "give it a variable before PATH");
  }
}

void StatementChecker::check(Press& press) {
  const Place place = place_;
  features_.push_back({place, MotionFeature::Press});
  if (pressing_) {
    diagnostics_.error(code::kPressInPress, place,
                       "a PRESS cannot stand inside another: it begins at standstill",
                       "close the first with ENDPRESS");
  }
  expressions_.check(press.force);
  if (press.force != nullptr) {
    expressions_.accept(*press.force, Type::real(kForce), "PRESS needs");
  }
  expressions_.check(press.limit);
  if (press.limit != nullptr &&
      expressions_.accept(*press.limit, Type::real(kSpeed), "LIMIT needs") &&
      constant_number(*press.limit).value_or(1) <= 0) {
    diagnostics_.error(
        code::kNotPositive, press.limit->place,
        fmt::format("LIMIT needs a value above zero; this is {}", described(*press.limit)));
  }
  clauses_.check(press.surroundings);
  const bool outer = std::exchange(pressing_, true);
  check(press.body);
  pressing_ = outer;
}

}  // namespace rob::lang
