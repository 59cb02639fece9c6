#pragma once

#include <algorithm>

#include "lang/code/chunk.h"
#include "lang/text/ascii.h"

namespace rob::test {

/// Whether two compiled programs do the same. Places do not count, nor do capital letters in the
/// names of variables, which are for listings only.
inline bool same_code(const lang::Chunk& a, const lang::Chunk& b) {
  using namespace lang;
  const auto same_word_of_code = [](Instruction x, Instruction y) { return x.word == y.word; };
  const auto same_bits = [](Slot x, Slot y) { return x.integer == y.integer; };
  const auto same_name = [](const NamedRegister& x, const NamedRegister& y) {
    return same_word(x.name, y.name) && x.index == y.index && x.text == y.text &&
           x.from == y.from && x.to == y.to;
  };
  return std::ranges::equal(a.code, b.code, same_word_of_code) &&
         std::ranges::equal(a.constants, b.constants, same_bits) && a.texts == b.texts &&
         a.dimensions == b.dimensions && a.moves == b.moves && a.signals == b.signals &&
         a.named_signals == b.named_signals && std::ranges::equal(a.names, b.names, same_name) &&
         a.registers == b.registers && a.text_registers == b.text_registers && a.memory == b.memory;
}

}  // namespace rob::test
