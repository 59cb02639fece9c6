#include "lang/format/declared_names.h"

#include "lang/syntax/lexer.h"
#include "lang/text/ascii.h"

namespace rob::lang {

namespace {

template <typename Spellings>
std::string_view find(const Spellings& spellings, std::string_view word) {
  const auto found = spellings.find(to_upper(word));
  return found == spellings.end() ? std::string_view() : found->second;
}

}  // namespace

DeclaredNames::DeclaredNames(std::string_view source) {
  Diagnostics unused;
  Lexer lexer = Lexer(source, unused).quiet_copy();
  bool at_begin = true;
  for (Token token = lexer.next(); token.kind != TokenKind::EndOfFile; token = lexer.next()) {
    if (token.kind == TokenKind::EndOfLine) {
      at_begin = depth_ == 0;
      continue;
    }
    if (at_begin) {
      begin_statement(token);
    } else {
      read(token);
    }
    at_begin = false;
    previous_ = token;
  }
}

std::string_view DeclaredNames::name(std::string_view word) const { return find(names_, word); }

std::string_view DeclaredNames::label(std::string_view word) const { return find(labels_, word); }

void DeclaredNames::begin_statement(const Token& token) {
  expected_ = Expected::Nothing;
  if (token.kind == TokenKind::Word) {
    const bool declares = same_word(token.text, "TOOL") || same_word(token.text, "FRAME") ||
                          same_word(token.text, "DEVICE") || same_word(token.text, "OBSTACLE");
    if (declares) expected_ = Expected::OneName;
    if (same_word(token.text, "ENUM")) expected_ = Expected::Enum;
    if (in_record_) {
      expected_ = Expected::Fields;
      declare_label(token.text);
    }
    return;
  }
  if (token.kind != TokenKind::Reserved) return;
  switch (token.keyword) {
    case Keyword::Var:
    case Keyword::Const:
    case Keyword::Point:
      expected_ = Expected::Names;
      return;
    case Keyword::Record:
      in_record_ = true;
      [[fallthrough]];
    case Keyword::For:
    case Keyword::Signal:
    case Keyword::Proc:
    case Keyword::Func:
    case Keyword::Task:
    case Keyword::Rescue:
      expected_ = Expected::OneName;
      return;
    case Keyword::Endrecord:
      in_record_ = false;
      return;
    default:
      return;
  }
}

void DeclaredNames::read(const Token& token) {
  const TokenKind kind = token.kind;
  if (kind == TokenKind::LeftParen || kind == TokenKind::LeftBracket) ++depth_;
  if (kind == TokenKind::RightParen || kind == TokenKind::RightBracket) depth_ -= depth_ > 0;
  switch (expected_) {
    case Expected::Nothing:
      return;
    case Expected::OneName: {
      if (kind == TokenKind::Word) names_.emplace(to_upper(token.text), token.text);
      const bool routine =
          previous_.kind == TokenKind::Reserved &&
          (previous_.keyword == Keyword::Proc || previous_.keyword == Keyword::Func);
      expected_ = routine ? Expected::Parameters : Expected::Nothing;
      return;
    }
    case Expected::Parameters:
      return read_parameter(token);
    case Expected::Names:
    case Expected::Fields:
      return read_list(token);
    case Expected::Enum:
      return read_enum(token);
  }
}

/// A parameter's name stands after the bracket, a comma, or REF; deeper brackets are defaults.
void DeclaredNames::read_parameter(const Token& token) {
  if (depth_ == 0) expected_ = Expected::Nothing;
  if (depth_ != 1 || token.kind != TokenKind::Word) return;
  const bool begins = previous_.kind == TokenKind::LeftParen || previous_.kind == TokenKind::Comma;
  const bool behind_ref = previous_.kind == TokenKind::Word && same_word(previous_.text, "REF");
  if ((!begins && !behind_ref) || same_word(token.text, "REF")) return;
  names_.emplace(to_upper(token.text), token.text);
  declare_label(token.text);
}

/// name, name, … up to the sign that ends the list.
void DeclaredNames::read_list(const Token& token) {
  if (token.kind == TokenKind::Comma) return;
  if (token.kind != TokenKind::Word) {
    expected_ = Expected::Nothing;
  } else if (expected_ == Expected::Fields) {
    declare_label(token.text);
  } else {
    names_.emplace(to_upper(token.text), token.text);
  }
}

/// name: name, name, …; reserved words, too, after the colon.
void DeclaredNames::read_enum(const Token& token) {
  const bool list = previous_.kind == TokenKind::Colon || previous_.kind == TokenKind::Comma;
  if (list && (token.kind == TokenKind::Word || token.kind == TokenKind::Reserved)) {
    declare_label(token.text);
  } else if (token.kind == TokenKind::Word) {
    names_.emplace(to_upper(token.text), token.text);
  } else if (token.kind != TokenKind::Colon && token.kind != TokenKind::Comma) {
    expected_ = Expected::Nothing;
  }
}

void DeclaredNames::declare_label(std::string_view word) {
  const auto [entry, is_new] = labels_.emplace(to_upper(word), word);
  if (!is_new && entry->second != word) entry->second = {};
}

}  // namespace rob::lang
