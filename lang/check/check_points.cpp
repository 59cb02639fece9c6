#include <fmt/core.h>

#include "lang/check/fold.h"
#include "lang/check/statement_checker.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"

/// Member functions of StatementChecker for POINT and TEACH.
namespace rob::lang {

/// What has been taught counts, before the value in the program.
void StatementChecker::check(PointDeclaration& declaration) {
  const Type given = settled(expressions_.check(declaration.value));
  const bool has_value = declaration.value != nullptr;
  if (has_value && given.known() && !given.is(Type::Kind::Pose)) {
    expressions_.accept(
        *declaration.value, Type::pose(),
        fmt::format("{} needs", shortened(declaration.points.front().declared.name)));
  }
  for (PointDeclaration::Point& point : declaration.points) {
    if (is_of_other_file(point.declared)) continue;
    Type type = given.is(Type::Kind::Pose) ? given : Type::pose();
    Constant value;
    const PointTable::Point* const kept = points_.find(point.declared.name);
    if (kept != nullptr) {
      type = type_of(*kept, point.declared.place);
      point.kept = kept->pose;
      value = constant_of(kept->pose);
    } else if (has_value && given == type) {
      value = known_value(*declaration.value);
    }
    if (!declaration.sound) type = Type{};
    // What comes behind an entry of the prompt may teach any of them.
    const bool taught = entry_ != 0 || taught_.contains(to_upper(point.declared.name));
    point.declared.symbol = declare(Symbol::Kind::Point, point.declared.name, point.declared.place,
                                    type, taught ? Constant{} : value);
    scopes_.keep(*point.declared.symbol, std::move(value));
    if (kept != nullptr) scopes_.keep_joints(*point.declared.symbol, *kept);
    if (taught) {
      scopes_.teach(*point.declared.symbol, *scopes_.hide(expressions_.joints()),
                    *scopes_.hide(Type::boolean()), entry_ != 0);
    }
    if (kept == nullptr && !has_value && declaration.sound) {
      missing_.declare(*point.declared.symbol);
    }
  }
}

/// All points of a program are kept in one points file, by their names.
bool StatementChecker::is_of_other_file(const Declaration::Declared& point) {
  const auto [earlier, is_new] = points_declared_.try_emplace(to_upper(point.name), point.place);
  if (is_new || earlier->second.file == point.place.file) return false;
  diagnostics_.error(
      code::kPointOfTwoFiles, point.place,
      fmt::format("{} is a POINT of another file already, in {}", shortened(point.name),
                  diagnostics_.line_of(earlier->second, point.place)),
      "all points of a program are kept together: give one another name, or"
      " declare it in one file that both USE");
  return true;
}

/// A pose in the frame that its entry names.
Type StatementChecker::type_of(const PointTable::Point& kept, Place place) {
  if (kept.frame.empty()) return Type::pose();
  const Symbol* const frame = scopes_.find_global(kept.frame);
  if (frame != nullptr && frame->frame != nullptr) return Type::pose(frame->frame);
  diagnostics_.error(
      code::kPointFrame, place,
      fmt::format("{} is kept in the frame {}, which is no FRAME declared above", kept.name,
                  shortened(kept.frame)),
      fmt::format("FRAME {} = POSE(…) before the POINT declares one", shortened(kept.frame)));
  return {};
}

void StatementChecker::check(Teach& teach) {
  const Symbol* const symbol = expressions_.resolve(teach.target.text, teach.target_place);
  teach.target.symbol = symbol;
  if (symbol == nullptr || !symbol->type.known()) return;
  if (symbol->kind != Symbol::Kind::Point) {
    diagnostics_.error(code::kNotAPoint, teach.target_place,
                       fmt::format("{} is no POINT; TEACH stores the place of the robot in one",
                                   shortened(symbol->name)),
                       fmt::format("POINT pick declares one; here = HERE keeps a place in a "
                                   "variable, for this run only"));
    return;
  }
  teach.frame = expressions_.frame_of(symbol->type);
  missing_.teach(*symbol, inside_.routine == nullptr && scopes_.at_top_level());
}

void StatementChecker::warn_of_missing_points() {
  for (MissingPoint& point : missing_.found()) {
    diagnostics_.warning(
        code::kPointMissing, point.place,
        fmt::format("nobody has taught {}: the points file of the program does not have it",
                    shortened(point.name)),
        fmt::format("TEACH {0} before its first use, or give it a value: POINT {0} = POSE(…)",
                    shortened(point.name)));
    missing_points_.push_back(std::move(point));
  }
}

}  // namespace rob::lang
