#include "lang/syntax/text_names.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "lang/syntax/keywords.h"
#include "lang/syntax/syntax_limits.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"

namespace rob::lang {

TextNames::TextNames(TokenReader& tokens, const SourceContext& context)
    : tokens_(tokens),
      outline_(*context.outline),
      imports_(context.imports),
      types_(*context.types),
      file_(context.file),
      names_(context.names) {}

Declaration::Declared TextNames::declared(std::string_view kind) {
  if (tokens_.at(TokenKind::Reserved)) tokens_.fail_reserved();
  if (!tokens_.at(TokenKind::Word)) {
    tokens_.fail_here(code::kNameExpected, fmt::format("a name expected after {}, not {}", kind,
                                                       described(tokens_.current())));
  }
  if (outline_.names_file(tokens_.text())) {
    tokens_.report(
        code::kNameOfUsedFile, tokens_.place(),
        fmt::format("{} is the name of a file that is USEd here", described(tokens_.current())),
        "choose another name");
  }
  count_name();
  Declaration::Declared declared{std::string(tokens_.text()), tokens_.place()};
  tokens_.advance();
  return declared;
}

void TextNames::count_name() {
  if (++names_ <= kMaxNames) return;
  tokens_.report(code::kProgramTooLarge, tokens_.place(),
                 fmt::format("the program is too large: it declares more than {} names", kMaxNames),
                 "keep many values of one kind in an ARRAY");
  throw GiveUp{};
}

bool TextNames::at_foreign() const {
  return tokens_.at(TokenKind::Word) && tokens_.next().kind == TokenKind::Dot &&
         outline_.names_file(tokens_.text());
}

std::string TextNames::foreign() {
  std::string name(tokens_.text());
  tokens_.advance();
  tokens_.advance();
  if (!tokens_.at(TokenKind::Word)) {
    tokens_.fail_here(code::kNameExpected,
                      fmt::format("a name of {} expected after '.', not {}", shortened(name),
                                  described(tokens_.current())));
  }
  name += '.';
  name += tokens_.text();
  tokens_.advance();
  return name;
}

void TextNames::resolve(Use& use) const {
  const auto import = std::ranges::find_if(
      imports_, [&](const Import& each) { return same_word(each.name, use.name); });
  if (import == imports_.end()) return;
  use.file = import->file;
  use.declarations = std::exchange(import->program->statements, {});
}

const TypeDetail* TextNames::record(const Token& name) {
  if (const TypeDetail* const record = imported(name, types_.records)) return record;
  const std::string key = to_upper(name.text);
  if (defined().enums.contains(key)) return &own_enum(name.text);
  const bool own = defined().records.contains(key) || types_.records.contains({file_, key});
  return own ? &own_record(name.text) : nullptr;
}

TypeDetail& TextNames::own_enum(std::string_view name) {
  TypeDetail& detail = own_record(name);
  detail.enumeration = true;
  return detail;
}

const TypeDetail* TextNames::frame(const Token& name) {
  const TypeDetail* const frame = imported(name, types_.frames);
  return frame != nullptr ? frame : &own_frame(name.text);
}

/// The detail of a type that one of the USEd files declares; null if none does, or this text.
const TypeDetail* TextNames::imported(const Token& name, const TypeTable::Named& types) {
  const std::string key = to_upper(name.text);
  if (outline_.types.contains(key)) return nullptr;
  const Import* found = nullptr;
  for (const Import& import : imports_) {
    if (!types.contains({import.file, key})) continue;
    if (found != nullptr) {
      tokens_.report(code::kAmbiguousName, name.place,
                     fmt::format("{} is a type of {} and of {}", shortened(name.text),
                                 shortened(found->name), shortened(import.name)),
                     "rename one of them");
      break;
    }
    found = &import;
  }
  return found == nullptr ? nullptr : types.at({found->file, key});
}

const TextNames::Defined& TextNames::defined() {
  if (defined_) return *defined_;
  defined_.emplace();
  Lexer lexer = tokens_.from_beginning();
  std::set<std::string>* names = nullptr;
  bool at_begin = true;  // of a line
  for (Token token = lexer.next(); token.kind != TokenKind::EndOfFile; token = lexer.next()) {
    if (names != nullptr && token.kind == TokenKind::Word) names->insert(to_upper(token.text));
    names = nullptr;
    const bool first = std::exchange(at_begin, token.kind == TokenKind::EndOfLine);
    if (first && token.kind == TokenKind::Word && same_word(token.text, "ENUM")) {
      names = &defined_->enums;
    }
    // That of another language has its message; its calls are none of their own.
    if (token.first_on_line && token.kind == TokenKind::Word && same_word(token.text, "SUB"))
      names = &defined_->routines;
    if (token.kind != TokenKind::Reserved) continue;
    const bool routine = token.keyword == Keyword::Proc || token.keyword == Keyword::Func ||
                         token.keyword == Keyword::Task;
    if (routine) names = &defined_->routines;
    if (token.keyword == Keyword::Record) names = &defined_->records;
  }
  return *defined_;
}

bool TextNames::names_routine(std::string_view name) {
  const auto named = [&](const Routine& routine) { return same_word(routine.name, name); };
  // Where the files that are USEd are not read, as by the formatter, it may be one of theirs.
  if (imports_.empty() && !outline_.uses.empty()) return true;
  return defined().routines.contains(to_upper(name)) ||
         std::ranges::any_of(imports_, [&](const Import& import) {
           return std::ranges::any_of(import.program->routines, named);
         });
}

std::string device_name(TokenReader& tokens, TextNames& names, std::string_view word) {
  if (!tokens.at(TokenKind::Word)) {
    tokens.fail_here(code::kNameExpected,
                     fmt::format("the name of a DEVICE expected after {}, not {}", word,
                                 described(tokens.current())),
                     "DEVICE scale = \"tcp://192.168.1.30:4001\" declares one");
  }
  if (tokens.next().kind == TokenKind::Dot) return names.foreign();
  std::string name(tokens.text());
  tokens.advance();
  return name;
}

}  // namespace rob::lang
