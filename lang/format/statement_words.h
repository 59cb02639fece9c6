#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "lang/syntax/token.h"

namespace rob::lang {

/// The role of a token within its statement, as far as its writing depends on it.
enum class WordUse : std::uint8_t {
  Name,
  Label,      ///< before a ':' in brackets: a component, a parameter
  Member,     ///< after a '.'
  Kept,       ///< a name that has to stay as it is written: of a file, of a record and its fields
  Clause,     ///< a word that is not reserved but a keyword where it stands
  Shape,      ///< BOX, SPHERE, CAPSULE and MESH, where a shape stands
  TypeName,   ///< after the ':' of a declaration
  Unit,       ///< part of a unit between brackets or after UNITS
  UnarySign,  ///< the sign of one value
  Other
};

struct WrittenWord {
  WordUse use = WordUse::Other;
  bool blank_before = false;
};

/// Goes along the tokens of one statement and says what each is and whether a blank stands before
/// it. It knows the clause words of all versions of the language.
class StatementWords {
 public:
  /// `fields`: the statement is a line of a RECORD.
  void begin(bool fields);

  /// `rest`: the tokens of the line from the current one on.
  WrittenWord next(std::span<const Token> rest);

  /// Brackets that are open after the last token.
  int depth() const { return depth_; }

 private:
  WordUse use_of(std::span<const Token> rest);
  WordUse use_of_word(const Token& word, TokenKind behind);
  bool begins_as_keyword(const Token& word, TokenKind behind) const;
  bool is_choice(const Token& word, TokenKind behind) const;
  bool is_clause(const Token& word, TokenKind behind) const;
  bool is_unary(const Token& token) const;
  bool blank_before(const Token& token, WordUse use) const;
  void go_on(const Token& token, WordUse use);
  bool follows(Keyword keyword) const;
  bool follows_clause(std::string_view word) const;

  Token previous_;
  WordUse previous_use_ = WordUse::Other;
  bool at_begin_ = true;  ///< of a statement, also of one after THEN, ELSE or a trigger's ':'
  bool behind_value_ = false;
  bool fields_ = false;
  bool trigger_ = false;     ///< WHEN, AFTER, BEFORE: a ':' stands before the action
  bool all_units_ = false;   ///< UNITS
  bool with_block_ = false;  ///< its last WITH begins a block
  bool enum_ = false;        ///< ENUM: what follows are names
  bool obstacle_ = false;    ///< OBSTACLE: after the '=' stands a shape
  bool shape_ = false;       ///< SHAPE: what follows are shapes
  bool file_ = false;        ///< WRITE: the colon is followed by values
  int depth_ = 0;
  std::size_t unit_words_ = 0;  ///< tokens that still belong to a unit between brackets
};

}  // namespace rob::lang
