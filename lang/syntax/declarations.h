#pragma once

#include <variant>

#include "lang/syntax/ast.h"

namespace rob::lang {

/// Whether a statement declares: it may stand before ROBOT, UNITS and LAW, and in a USEd file.
inline bool is_declaration(const Statement& statement) {
  return std::holds_alternative<Declaration>(statement.node) ||
         std::holds_alternative<SignalDeclaration>(statement.node) ||
         std::holds_alternative<PointDeclaration>(statement.node) ||
         std::holds_alternative<RecordDeclaration>(statement.node) ||
         std::holds_alternative<Defaults>(statement.node) ||
         std::holds_alternative<EnumDeclaration>(statement.node) ||
         std::holds_alternative<DeviceDeclaration>(statement.node) ||
         std::holds_alternative<ObstacleDeclaration>(statement.node) ||
         std::holds_alternative<Use>(statement.node);
}

}  // namespace rob::lang
