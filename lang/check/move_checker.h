#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lang/check/checked_program.h"
#include "lang/check/clause_checker.h"
#include "lang/check/expression_checker.h"
#include "lang/check/meaning.h"
#include "lang/check/names.h"
#include "lang/check/value_checker.h"
#include "lang/check/watch_checker.h"
#include "lang/machine/robot_signature.h"
#include "lang/syntax/plain_motion.h"

namespace rob::lang {

/// The targets of motions in numbers alone, in a robot's coordinates.
class PlainTargets {
 public:
  struct Target {
    std::uint8_t given = 0;                        ///< as in MoveCommand
    std::array<double, kMaxCoordinates> values{};  ///< SI; what is not given is 0
  };

  explicit PlainTargets(const RobotSignature& robot) : robot_(robot) {}
  /// Nothing where components do not fit the robot: then the checker reports why. `file`: the
  /// number of the file that it stands in.
  std::optional<Target> of(const PlainMotion& motion, std::uint32_t file);

 private:
  const RobotSignature& robot_;
  std::uint32_t file_ = 0;   ///< that units_ are of
  std::vector<Unit> units_;  ///< of bare numbers, by coordinate
};

/// Checks motions: the target against the robot's coordinates or axes, and the clauses.
class MoveChecker {
 public:
  MoveChecker(const RobotSignature& robot, const Names& names, ExpressionChecker& expressions,
              ValueChecker& values, const TargetJudge& judge, Diagnostics& diagnostics,
              CheckedProgram& checked)
      : robot_(robot),
        elements_(elements_of(robot)),
        plain_(robot),
        judge_(judge),
        names_(names),
        expressions_(expressions),
        values_(values),
        clauses_(expressions, values, diagnostics),
        watches_(expressions, values, diagnostics),
        diagnostics_(diagnostics),
        checked_(checked) {}

  /// `place`: of the statement; `guarded`: UNTIL stands after it.
  void check(const Move& move, Place place, bool guarded);
  void check(PlainMotions& motions);
  /// Says whether the next statements stand in a routine.
  void in_routine(bool inside) { in_routine_ = inside; }
  /// The same for a block of WITH.
  void enter_surroundings() { ++surroundings_; }
  void leave_surroundings() { --surroundings_; }
  /// A ZONE before UNTIL, or directly before STOP, WAIT and the like, which make its target exact.
  void warn_of_zones(const Block& block);

 private:
  // The way to the target
  bool check_way(const Move& move, Place place, bool guarded);
  bool check_joint(const Move& move);
  bool check_curve(const Move& move);
  bool check_alike(const Move& move);
  bool check_spiral(const Move& move);
  bool check_jog(const Move& move, Place place, bool guarded);

  // Targets
  bool check_target(const Move& move, const ExprPtr& target);
  bool check_via(const Move& move, const ExprPtr& point);
  bool check_shape(const Tuple& tuple, const Coordinates& in_place, const Coordinates& all,
                   Place place);
  bool check_count(std::size_t given, const Coordinates& coordinates, Place place);
  bool check_names(const Tuple& tuple, const Coordinates& coordinates);
  void report_no_coordinate(const Tuple::Element& element, const Coordinates& coordinates);
  bool names_gripper(const Tuple::Element& element) const;
  bool check_component(std::string_view word, const Tuple::Element& element,
                       std::size_t coordinate);
  bool check_value(const Move& move, const ExprPtr& target);
  bool check_frame(const Move& move, const Expr& target);
  void report_no_target(const Move& move, const Expr& target);
  bool settle(PlainMotions& motions, PlainMotions::Written& motion);

  // Clauses that not every motion takes, features that not every robot has
  bool check_clauses_of(const Move& move);
  bool check_choice(const Move& move);
  bool check_clauses_of_jog(const Move& move);
  bool refuse_clause(std::string_view clause, Place place, std::string message, std::string help);
  void warn_of_last_zone(const PlainMotions& motions, const Statement& next);
  void warn_of_zone(Place zone, std::string_view word, Place place);
  void remember_features(const Move& move, Place place);

  // Whether the robot can go there
  bool places_are_known() const;
  void judge_constants(const Move& move);
  void judge_target(MoveCommand command, const Expr& target, const Symbol* point);
  void judge_value(MoveCommand command, const Expr& target, const Symbol* point);
  void keep_component(MoveCommand& command, std::size_t i, const Expr& value,
                      Dimension dimension) const;
  void judge(const MoveCommand& command, Place place);

  const RobotSignature& robot_;
  const Coordinates elements_;  ///< of a target
  PlainTargets plain_;
  const TargetJudge& judge_;
  const Names& names_;
  ExpressionChecker& expressions_;
  ValueChecker& values_;
  ClauseChecker clauses_;
  WatchChecker watches_;
  Diagnostics& diagnostics_;
  CheckedProgram& checked_;
  bool in_routine_ = false;
  int surroundings_ = 0;  ///< WITHs that are open around the motion
};

/// Checks what stands in a PATH, which is planned as one before it starts.
class PathChecker {
 public:
  explicit PathChecker(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  /// Whether what comes now stands in a PATH; returns whether the last did.
  bool enter(bool path) { return std::exchange(inside_, path); }
  /// A statement, which has been checked as such before.
  void check(const Statement& statement);
  void check_clauses(const Clauses& clauses, Place place);
  /// Where and when something is done on the way.
  void note(const WayPoint& event);
  /// A PATH without motions.
  void warn_of_empty(const PathBlock& path, Place place);
  /// Where all is checked, and it is known what TASKs change: what a PATH reads of the robot.
  void report_reads();

 private:
  void check(const Move& move, Place place);
  void refuse(Place place, std::string_view help);
  void note(const ExprPtr& value);

  Diagnostics& diagnostics_;
  bool inside_ = false;
  std::vector<const Expr*> values_;  ///< what PATHs are computed from
};

}  // namespace rob::lang
