#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "lang/check/checked_program.h"
#include "lang/check/expression_checker.h"
#include "lang/check/names.h"
#include "lang/check/shape_checker.h"
#include "lang/check/symbols.h"
#include "lang/check/value_checker.h"
#include "lang/machine/point_table.h"
#include "lang/syntax/ast.h"
#include "lang/text/diagnostic.h"

namespace rob::lang {

template <typename Node>
concept IsDeclaration =
    std::is_same_v<Node, Declaration> || std::is_same_v<Node, RecordDeclaration> ||
    std::is_same_v<Node, EnumDeclaration> || std::is_same_v<Node, PointDeclaration> ||
    std::is_same_v<Node, DeviceDeclaration> || std::is_same_v<Node, ObstacleDeclaration>;

/// Checks VAR, CONST, FRAME, TOOL, RECORD and POINT, and TEACH, which changes a point.
class DeclarationChecker {
 public:
  DeclarationChecker(Scopes& scopes, Declarations& declarations, Names& names,
                     ExpressionChecker& expressions, ValueChecker& values, MissingPoints& missing,
                     ShapeChecker& shapes, const PointTable& points, const Program& program,
                     Diagnostics& diagnostics)
      : scopes_(scopes),
        declarations_(declarations),
        names_(names),
        expressions_(expressions),
        values_(values),
        missing_(missing),
        shapes_(shapes),
        points_(points),
        program_(program),
        diagnostics_(diagnostics) {}

  void check(Declaration& declaration);
  void check(RecordDeclaration& record);
  void check(EnumDeclaration& enumeration);
  void check(DeviceDeclaration& device);
  void check(ObstacleDeclaration& obstacle) { shapes_.check(obstacle); }
  void check(PointDeclaration& declaration);
  /// `surely`: the statement is executed before those after it.
  void check(Teach& teach, bool surely);
  /// Takes over a name that an earlier entry of the prompt has declared.
  void know(const Symbol& symbol);

 private:
  /// Whether a PERSIST variable can be one; reports why not.
  bool may_persist(const Declaration::Declared& declared, const Type& type);
  Type settle_type(Declaration& declaration, Type given, bool& accepted);
  void check_frame(const Declaration& declaration, Constant& value, bool missed);
  Constant tool_number(const ExprPtr& value, const Type& wanted, std::string_view needed);
  void add_field(TypeDetail& detail, const Declaration::Declared& field, const Type& type);
  void declare(PointDeclaration::Point& point, const PointDeclaration& declaration,
               const Type& given);
  void keep_joints(const Symbol& symbol, PointTable::Point kept);
  bool is_of_other_file(const Declaration::Declared& point);
  Type type_of(const PointTable::Point& kept, Place place);

  Scopes& scopes_;
  Declarations& declarations_;
  Names& names_;
  ExpressionChecker& expressions_;
  ValueChecker& values_;
  MissingPoints& missing_;
  ShapeChecker& shapes_;
  const PointTable& points_;
  const Program& program_;
  Diagnostics& diagnostics_;
  std::map<std::string, Place> points_declared_;  ///< of all files, by their names in capitals
};

}  // namespace rob::lang
