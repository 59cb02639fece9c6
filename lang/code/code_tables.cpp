#include "lang/code/code_tables.h"

#include <algorithm>
#include <utility>

namespace rob::lang {
namespace {

/// The number of `value` in `table`, where it is appended if it is new.
template <typename T>
std::size_t number_in(std::vector<T>& table, const T& value) {
  const auto found = std::ranges::find(table, value);
  if (found != table.end()) return static_cast<std::size_t>(found - table.begin());
  table.push_back(value);
  return table.size() - 1;
}

}  // namespace

std::uint32_t CodeTables::constant(Slot value, std::uint64_t bits, Type type) {
  const auto next = static_cast<std::uint32_t>(constants_.size());
  const auto [entry, added] =
      constant_numbers_.try_emplace(std::tuple(bits, type.kind, type.dimension), next);
  if (added) {
    constants_.push_back(value);
    constant_types_.push_back(type);
  }
  return entry->second;
}

std::uint32_t CodeTables::text(const std::string& text) {
  const auto [entry, added] =
      text_numbers_.try_emplace(text, static_cast<std::uint32_t>(texts_.size()));
  if (added) texts_.push_back(text);
  return entry->second;
}

std::size_t CodeTables::dimension(Dimension dimension) { return number_in(dimensions_, dimension); }

std::size_t CodeTables::type(const Type& type) { return number_in(types_, type); }

std::size_t CodeTables::form(const MoveForm& form) { return number_in(forms_, form); }

void CodeTables::move_into(Chunk& chunk) {
  chunk.constants = std::move(constants_);
  chunk.constant_types = std::move(constant_types_);
  chunk.texts = std::move(texts_);
  chunk.dimensions = std::move(dimensions_);
  chunk.types = std::move(types_);
  chunk.moves = std::move(forms_);
}

}  // namespace rob::lang
