#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tests/support/cpp_tokens.h"

namespace rob::test {

/// A function that the body of a class declares.
struct CppMethod {
  std::string name;       ///< "f"; of an operator "operator"
  std::size_t begin = 0;  ///< the token that opens its parameters
  std::size_t end = 0;    ///< the token after it, and after its body where it has one
};

/// A name that the body of a class declares for a value that an object holds.
struct CppMember {
  std::string name;
  std::string
      type;  ///< its tokens without spaces between them, from the first on: "std::atomic<int>"
};

/// A class, struct or union with a body.
struct CppClass {
  std::string name;  ///< "Outer::Inner"; a class without a name is "(unnamed)"
  int line = 0;      ///< where it begins
  /// Static functions, constructors, the destructor, operators and each overload, too. Not those
  /// that are `= default` or `= delete`: nobody has to read them. Not friends: they belong to
  /// somebody else.
  std::vector<CppMethod> methods{};
  /// Not static ones. What an unnamed union or struct in it holds belongs to it, too.
  std::vector<CppMember> members{};
};

/// All classes among the tokens, in their order, an outer one before its inner ones. Throws
/// std::runtime_error where brackets do not match.
std::vector<CppClass> classes_in(const std::vector<CppToken>& tokens);

/// For each opening bracket, brace or parenthesis the token that closes it, and the other way
/// round; 0 for all other tokens. Throws std::runtime_error where they do not match.
std::vector<std::size_t> partners_of(const std::vector<CppToken>& tokens);

}  // namespace rob::test
