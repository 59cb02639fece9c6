#pragma once

#include <deque>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lang/check/symbols.h"
#include "lang/code/chunk.h"
#include "lang/code/location.h"
#include "lang/machine/machine.h"
#include "lang/syntax/ast.h"
#include "lang/text/diagnostic.h"

/// The input of the checker beside the program, and its result.
namespace rob::lang {

/// Asked for every motion whose written coordinates are known before the program runs, while
/// nothing moves yet: why the robot cannot go there, or nothing. The command holds the constant
/// components only.
using TargetJudge = std::function<std::optional<Refusal>(const MoveCommand& command)>;

/// A name that an entry of the prompt has declared, as later entries find it.
struct KeptName {
  Symbol symbol;                    ///< what it points to is of this prompt's types, or in `hidden`
  Location home;                    ///< where its value lies
  std::vector<KeptName> hidden;     ///< of a POINT: its joints, and whether they are known
  std::optional<SafeValue> safe{};  ///< of a SIGNAL with SAFE
};

using KnownNames = std::span<const KeptName* const>;

/// Where a program asks for something that not every robot can do.
struct FeatureUse {
  Place place;
  MotionFeature feature = MotionFeature::Accel;
};

/// A declared point that has no value before the program runs, and is used all the same.
struct MissingPoint {
  std::string name;
  Place place;  ///< of its declaration
};

/// A program whose names, types, dimensions and constants are settled.
struct CheckedProgram {
  Program program;
  std::deque<Symbol> symbols;  ///< all that Name::symbol and the like point to
  std::vector<FeatureUse> features;
  std::vector<MissingPoint> missing_points;
  /// A name that an earlier entry of the prompt has declared.
  struct Known {
    const Symbol* symbol = nullptr;
    const KeptName* kept = nullptr;
  };
  std::vector<Known> known{};
};

/// Whether a variable of an earlier entry is shared with TASKs, as it was not before this one.
inline bool newly_shared(const CheckedProgram::Known& known) {
  const Symbol& before = known.kept->symbol;
  return (known.symbol->shared && !before.shared) || (known.symbol->of_tasks && !before.of_tasks);
}

}  // namespace rob::lang
