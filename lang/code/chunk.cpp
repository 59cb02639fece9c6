#include "lang/code/chunk.h"

#include <algorithm>
#include <iterator>

namespace rob::lang {

void PlaceTable::push_back(const Place& place) {
  Place rest = place;
  rest.line = 0;
  const bool other = rests_.empty() || rests_.back().place != rest;
  if (other) rests_.push_back({static_cast<std::uint32_t>(runs_.size()), rest});
  if (other || runs_.back().line != place.line) runs_.push_back({size_, place.line});
  ++size_;
}

Place PlaceTable::operator[](std::size_t word) const {
  const auto run = std::prev(std::ranges::upper_bound(runs_, word, {}, &Run::first));
  const auto number = static_cast<std::uint32_t>(run - runs_.begin());
  Place place = std::prev(std::ranges::upper_bound(rests_, number, {}, &Rest::run))->place;
  place.line = run->line;
  return place;
}

std::span<const Dimension> axes_of(const Chunk& chunk) { return chunk.type_table->joints->axes; }

bool takes_memory(const Chunk& chunk) {
  return std::ranges::any_of(chunk.routines,
                             [](const RoutineCode& routine) { return routine.memory != Slots{}; });
}

bool has_handlers(const Chunk& chunk) {
  return std::ranges::any_of(chunk.routines, &RoutineCode::handler);
}

const OpcodeInfo& info(Opcode opcode) {
  static constexpr std::array kInfos = std::to_array<OpcodeInfo>({
#define ROB_OPCODE(name, operands) {#name, operands},
#include "lang/code/opcodes.def"
  });
  return kInfos[static_cast<std::size_t>(opcode)];
}

}  // namespace rob::lang
