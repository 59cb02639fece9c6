#include "lang/check/called_builtins.h"

#include <algorithm>

namespace rob::lang {

const Builtin* find_builtin(const Call& call) {
  const Builtin* const plain = find_builtin(call.callee, call.arguments.size());
  if (plain == nullptr || call.arguments.empty()) return plain;
  const Type& first = call.arguments.front()->type;
  const bool array = first.is(Type::Kind::Array);
  if (!array && !first.is_place()) return plain;
  const BuiltinRule rule = array ? BuiltinRule::ArrayLength : BuiltinRule::Places;
  for (const Builtin& builtin : builtins()) {
    if (builtin.name == plain->name && builtin.rule == rule &&
        builtin.least == call.arguments.size()) {
      return &builtin;
    }
  }
  return plain;
}

bool computes_whole(const Builtin& builtin, const Call& call) {
  return builtin.integer != nullptr &&
         std::ranges::all_of(call.arguments, [](const ExprPtr& argument) {
           return argument->type.kind == Type::Kind::Int;
         });
}

}  // namespace rob::lang
