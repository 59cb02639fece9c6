#pragma once

#include <utility>

#include "lang/machine/machine.h"

namespace rob::runtime {

/// Code, what is wrong, and the remedy. What a program's commands are refused with.
using Words = lang::Refusal;

/// The same words about this place of the program.
inline Words words_at(lang::Place place, Words words) {
  words.place = place;
  return words;
}

}  // namespace rob::runtime
