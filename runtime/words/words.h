#pragma once

#include <utility>

#include "lang/machine/machine.h"

namespace rob::runtime {

/// Code, what is wrong, and the remedy. A program's commands are refused with it.
using Words = lang::Refusal;

/// The same words about this place of the program.
inline Words words_at(lang::Place place, Words words) {
  words.place = place;
  return words;
}

}  // namespace rob::runtime
