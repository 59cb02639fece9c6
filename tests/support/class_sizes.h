#pragma once

#include <string>
#include <vector>

#include "tests/support/cpp_tokens.h"

namespace rob::test {

/// How large a class, struct or union is.
struct ClassSize {
  std::string name;  ///< "Outer::Inner"; a class without a name is "(unnamed)"
  int line = 0;      ///< where it begins
  /// Functions that its body declares, static ones, constructors, the destructor, operators and
  /// each overload too. Not those that are `= default` or `= delete`: nobody has to read them. Not
  /// friends: they belong to somebody else.
  int methods = 0;
  /// Each name that its body declares for a value that an object holds; so not static ones. What an
  /// unnamed union or struct in it holds belongs to it, too.
  int members = 0;
};

/// Every class with a body among the tokens, in their order, an outer one before its inner ones.
/// Throws std::runtime_error where brackets do not match.
std::vector<ClassSize> class_sizes(const std::vector<CppToken>& tokens);

}  // namespace rob::test
