#include "lang/code/chunk.h"

#include <algorithm>
#include <iterator>

namespace rob::lang {

const Place& PlaceTable::operator[](std::size_t word) const {
  const auto behind = std::ranges::upper_bound(runs_, word, {}, &Run::first);
  return std::prev(behind)->place;
}

bool takes_memory(const Chunk& chunk) {
  return std::ranges::any_of(chunk.routines,
                             [](const RoutineCode& routine) { return routine.memory != Slots{}; });
}

const OpcodeInfo& info(Opcode opcode) {
  static constexpr std::array kInfos = std::to_array<OpcodeInfo>({
#define ROB_OPCODE(name, operands) {#name, operands},
#include "lang/code/opcodes.def"
  });
  return kInfos[static_cast<std::size_t>(opcode)];
}

}  // namespace rob::lang
