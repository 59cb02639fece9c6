#pragma once

#include <vector>

#include "lang/check/checker.h"
#include "lang/check/kept_name.h"
#include "lang/check/routine_uses.h"
#include "lang/check/symbols.h"

namespace rob::lang {

/// Declares the names that earlier entries of the prompt have kept, so that the entry being checked
/// can use them. Notes in `known` which symbol stands for which kept name.
class KeptNames {
 public:
  KeptNames(Scopes& scopes, RoutineUses& uses, std::vector<CheckedProgram::Known>& known)
      : scopes_(scopes), uses_(uses), known_(known) {}

  /// At the top level.
  const Symbol& declare(const KeptName& kept);

 private:
  /// The joints of a point, or whether they are known: no program can name them.
  const Symbol& declare_hidden(const KeptName& kept);

  Scopes& scopes_;
  RoutineUses& uses_;
  std::vector<CheckedProgram::Known>& known_;
};

}  // namespace rob::lang
