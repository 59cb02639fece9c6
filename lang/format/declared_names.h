#pragma once

#include <map>
#include <string>
#include <string_view>

#include "lang/syntax/token.h"

namespace rob::lang {

/// How the names of a program are spelled where they are declared for the first time. It reads
/// tokens, not the syntax tree, and so knows the declarations of all versions of the language.
/// A name has one spelling in the whole file, whatever its scope.
class DeclaredNames {
 public:
  /// Goes over a text that has passed check_source(), which must outlive this.
  explicit DeclaredNames(std::string_view source);

  /// The name of a variable, constant, routine …; empty if the file does not declare it.
  std::string_view name(std::string_view word) const;
  /// The name of a record's field or a routine's parameter; empty if there is none or if they
  /// differ.
  std::string_view label(std::string_view word) const;

 private:
  /// Kinds of names that the next tokens declare.
  enum class Expected { Nothing, OneName, Names, Parameters, Fields, Enum };
  using Spellings = std::map<std::string, std::string_view, std::less<>>;

  void begin_statement(const Token& token);
  void read(const Token& token);
  void read_parameter(const Token& token);
  void read_list(const Token& token);
  void read_enum(const Token& token);
  void declare_label(std::string_view word);

  Spellings names_;
  Spellings labels_;  ///< an empty one: spelled in several ways
  Expected expected_ = Expected::Nothing;
  Token previous_;
  int depth_ = 0;  ///< of brackets
  bool in_record_ = false;
};

}  // namespace rob::lang
