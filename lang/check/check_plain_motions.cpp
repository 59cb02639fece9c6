#include <utility>

#include "lang/check/move_checker.h"
#include "lang/syntax/parser.h"

/// Motions in numbers alone. What is wrong with one is told by reading it once more as a tree.
namespace rob::lang {

void MoveChecker::check(PlainMotions& motions) {
  motions.values.reserve(motions.motions.size() * robot_.coordinates.size());
  bool leads = false;  // there may be a million: the first is named
  for (PlainMotions::Written& motion : motions.motions) {
    if (settle(motions, motion)) {
      if (motion.kind != MotionKind::Joint && !std::exchange(leads, true))
        checked_.features.push_back({motions.place(motion), MotionFeature::Lead});
      continue;
    }
    const Place place = motions.place(motion);
    for (const Statement& statement :
         parse_line(motions.source, motion.offset, place, diagnostics_)) {
      check(std::get<Move>(statement.node), place, false);
    }
  }
}

bool MoveChecker::settle(PlainMotions& motions, PlainMotions::Written& motion) {
  const auto read =
      read_plain_motion(motions.source.substr(motion.offset), word_of(motion.kind).size());
  const auto target = read ? plain_.of(*read, motions.file) : std::nullopt;
  if (!target) return false;
  const MoveCommand command{.kind = motion.kind,
                            .count = static_cast<int>(robot_.coordinates.size()),
                            .given = target->given,
                            .target = target->values};
  if (target->given != 0 && places_are_known() && judge_ && judge_(command)) return false;
  motion.given = target->given;
  for (std::size_t i = 0; i < command.target.size(); ++i) {
    if (command.has(static_cast<int>(i))) motions.values.push_back(command.target[i]);
  }
  return true;
}

}  // namespace rob::lang
