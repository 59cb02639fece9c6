#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "lang/code/chunk.h"

namespace rob::lang {

/// The tables that instructions refer to by index: constants, texts, dimensions, types, and forms
/// of motions. Each table holds a value once. A function adds its value if it is new, and returns
/// its index.
class CodeTables {
 public:
  /// `bits` is the bit pattern of the value. Constants differ if their bits, their kinds or their
  /// dimensions differ; only listings use the dimension.
  std::uint32_t constant(Slot value, std::uint64_t bits, Type type);
  std::uint32_t text(const std::string& text);
  std::size_t dimension(Dimension dimension);
  std::size_t type(const Type& type);
  std::size_t form(const MoveForm& form);

  /// Moves all tables into the chunk, when the code is complete.
  void move_into(Chunk& chunk);

 private:
  std::vector<Slot> constants_;
  std::vector<Type> constant_types_;
  std::map<std::tuple<std::uint64_t, Type::Kind, Dimension>, std::uint32_t> constant_numbers_;
  std::vector<std::string> texts_;
  std::map<std::string, std::uint32_t> text_numbers_;
  std::vector<Dimension> dimensions_;
  std::vector<Type> types_;
  std::vector<MoveForm> forms_;
};

}  // namespace rob::lang
