#pragma once

#include <vector>

#include "lang/syntax/ast.h"

namespace rob::lang {

/// One parameter of a routine, and the group it was written in.
struct Parameter {
  const Routine::Parameters* group;
  const Declaration::Declared* declared;
};

inline std::vector<Parameter> parameters_of(const Routine& routine) {
  std::vector<Parameter> parameters;
  for (const Routine::Parameters& group : routine.parameters) {
    for (const Declaration::Declared& declared : group.names) {
      parameters.push_back({&group, &declared});
    }
  }
  return parameters;
}

/// Whether computing an expression calls a routine, which may change variables.
bool calls_routine(const Expr& expression);

}  // namespace rob::lang
