#pragma once

#include <string>
#include <string_view>

#include "lang/machine/machine.h"
#include "lang/values/arithmetic.h"
#include "lang/values/types.h"

namespace rob::lang {

/// An ASK. The operator's answer is read as a value of its type: a literal of the language with
/// its unit, perhaps with a sign, and nothing else; or, for a STRING, the line as it is. What
/// cannot be read is asked again, and said why.
class Question {
 public:
  /// The answer becomes numbers[index], or texts[index] if that is what the type needs. Both stay
  /// where the program is only foretold.
  Reply ask(Machine& machine, int line, std::string text, const Type& type, Slot* numbers,
            std::string* texts, std::size_t index);
  /// Another one comes next.
  void forget() { misread_.clear(); }

 private:
  std::string misread_;  ///< why the last answer could not be taken
};

}  // namespace rob::lang
