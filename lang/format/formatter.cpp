#include "lang/format/formatter.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "lang/format/declared_names.h"
#include "lang/format/source_lines.h"
#include "lang/format/statement_words.h"
#include "lang/syntax/named_types.h"
#include "lang/syntax/parser.h"
#include "lang/syntax/token_reader.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"
#include "lang/text/source_text.h"
#include "lang/text/utf8.h"
#include "lang/values/builtins.h"

namespace rob::lang {

namespace {

constexpr std::size_t kIndent = 2;         // blanks a block, or a bracket left open
constexpr std::size_t kCommentBlanks = 2;  // between code and comment
/// Blocks are not nested deeper; in text that is skipped as "not yet" they may be, and must not
/// make the layout grow with the square of its length.
constexpr std::size_t kMostLevels = kMaxDepth;

/// Names that the language provides, as its manual writes them; those of the functions that have
/// a line in builtins.def are found there.
constexpr auto kProvided = std::to_array<std::string_view>(
    {"AIN",    "AOUT",  "CLOCK",   "CROSS",  "DIN",    "DIST",     "DOT",     "DOUT",
     "FIND",   "force", "FORWARD", "FRAME3", "HERE",   "HIT",      "HITPOSE", "INV",
     "JOINTS", "LEN",   "LOWER",   "MID",    "MIX",    "NORM",     "NUM",     "PI",
     "POSE",   "QUAT",  "RANDOM",  "TARGET", "torque", "TO_FRAME", "TRIM",    "TURN",
     "UNIT",   "UPPER", "VEC",     "world",  "WRENCH", "ZYZ"});

std::string_view provided(std::string_view word) {
  const Builtin* const builtin = find_builtin(word, 0);
  if (builtin != nullptr) return builtin->name;
  const auto found =
      std::ranges::find_if(kProvided, [&](std::string_view each) { return same_word(each, word); });
  return found == kProvided.end() ? std::string_view() : *found;
}

std::string_view type_name(std::string_view word) {
  const NamedType* const found = named_type(word);
  return found == nullptr ? std::string_view() : found->name;
}

/// How a line changes the indentation.
enum class BlockEdge { None, Opens, Closes, Branches, EndsProgram };

BlockEdge edge_of(const Token& first, const Token& last) {
  if (first.kind == TokenKind::Reserved) {
    switch (first.keyword) {
      case Keyword::End:
        return BlockEdge::EndsProgram;
      case Keyword::Else:
      case Keyword::Elsif:
      case Keyword::Case:
      case Keyword::Rescue:
        return BlockEdge::Branches;
      case Keyword::Func:
      case Keyword::Loop:
      case Keyword::Proc:
      case Keyword::Record:
      case Keyword::Select:
      case Keyword::Task:
      case Keyword::Test:
      case Keyword::Try:
        return BlockEdge::Opens;
      default:
        if (role(first.keyword) == KeywordRole::Closer) return BlockEdge::Closes;
    }
  }
  const bool open = last.kind == TokenKind::Reserved &&
                    (last.keyword == Keyword::Do || last.keyword == Keyword::Then);
  return open ? BlockEdge::Opens : BlockEdge::None;
}

/// Writes the lines, with their comments where they belong.
class Layout {
 public:
  explicit Layout(std::string_view source) : names_(source) { text_.reserve(source.size()); }

  void add(const SourceLine& line);
  std::string finish() {
    end_run();
    return std::move(text_);
  }

 private:
  /// A line with a comment after its code.
  struct Commented {
    std::string code;
    std::string_view comment;
  };

  void add_code(const SourceLine& line, std::string& code);
  void begin_statement(const SourceLine& line);
  void end_statement(const Token& last);
  std::size_t indent(const SourceLine& line) const;
  std::string spelled(const Token& token, WordUse use) const;
  void put(std::string code);
  void end_run();

  DeclaredNames names_;
  StatementWords words_;
  Token first_;  ///< of the current statement
  std::size_t level_ = 0;
  std::size_t own_level_ = 0;  ///< that of the current statement
  bool continues_ = false;     ///< brackets were open at the end of the last line
  bool in_record_ = false;
  bool empty_line_due_ = false;
  std::vector<Commented> run_;  ///< lines whose comments stood below each other
  std::uint32_t run_column_ = 0;
  std::string text_;
};

void Layout::add(const SourceLine& line) {
  if (line.empty()) {
    end_run();
    empty_line_due_ = !text_.empty();
    return;
  }
  std::string code;
  if (!line.tokens.empty()) {
    add_code(line, code);
  } else {
    const std::size_t levels = continues_ ? indent(line) : level_;
    code.assign(std::min(levels, kMostLevels) * kIndent, ' ');
    code += line.comment;
    return put(std::move(code));
  }
  if (line.comment.empty()) return put(std::move(code));
  if (line.comment_column != run_column_) end_run();
  if (empty_line_due_) text_ += '\n';
  empty_line_due_ = false;
  run_column_ = line.comment_column;
  run_.push_back({std::move(code), line.comment});
}

void Layout::put(std::string code) {
  end_run();
  if (empty_line_due_) text_ += '\n';
  empty_line_due_ = false;
  text_ += code;
  text_ += '\n';
}

/// Comments that stood below each other do so again, after the longest of their lines.
void Layout::end_run() {
  std::uint32_t widest = 0;
  for (const Commented& line : run_) widest = std::max(widest, count_code_points(line.code));
  for (const Commented& line : run_) {
    text_ += line.code;
    text_.append(widest - count_code_points(line.code) + kCommentBlanks, ' ');
    text_ += line.comment;
    text_ += '\n';
  }
  run_.clear();
  run_column_ = 0;
}

void Layout::add_code(const SourceLine& line, std::string& code) {
  // A bracket left open does not reach over a new statement: the parser skips such text.
  if (continues_ && begins_statement(line.tokens.front())) continues_ = false;
  if (!continues_) begin_statement(line);
  code.assign(std::min(indent(line), kMostLevels) * kIndent, ' ');
  const std::span<const Token> tokens(line.tokens);
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const WrittenWord word = words_.next(tokens.subspan(i));
    if (word.blank_before && i > 0) code += ' ';
    code += spelled(tokens[i], word.use);
  }
  continues_ = words_.depth() > 0;
  if (!continues_) end_statement(tokens.back());
}

void Layout::begin_statement(const SourceLine& line) {
  first_ = line.tokens.front();
  if (line.tokens.size() == 1 && same_word(first_.text, spelling(Keyword::Endallow))) {
    first_.kind = TokenKind::Reserved;
    first_.keyword = Keyword::Endallow;
  }
  const bool end_of_record =
      first_.kind == TokenKind::Reserved && first_.keyword == Keyword::Endrecord;
  if (end_of_record) in_record_ = false;
  words_.begin(in_record_);
  const BlockEdge edge = edge_of(first_, first_);
  if (edge == BlockEdge::EndsProgram) level_ = 0;
  const bool outward = edge == BlockEdge::Closes || edge == BlockEdge::Branches;
  own_level_ = outward && level_ > 0 ? level_ - 1 : level_;
}

void Layout::end_statement(const Token& last) {
  const BlockEdge edge = edge_of(first_, last);
  const bool inward = edge == BlockEdge::Opens || edge == BlockEdge::Branches;
  level_ = inward ? own_level_ + 1 : own_level_;
  if (first_.kind == TokenKind::Reserved && first_.keyword == Keyword::Record) in_record_ = true;
}

/// In levels. A line within brackets stands deeper by one level for each; one that begins by
/// closing some, by fewer.
std::size_t Layout::indent(const SourceLine& line) const {
  if (!continues_) return own_level_;
  std::size_t open = static_cast<std::size_t>(words_.depth());
  for (const Token& token : line.tokens) {
    const bool closes =
        token.kind == TokenKind::RightParen || token.kind == TokenKind::RightBracket;
    if (!closes || open == 0) break;
    --open;
  }
  return own_level_ + open;
}

std::string Layout::spelled(const Token& token, WordUse use) const {
  const auto or_as_written = [&](std::string_view found) {
    return std::string(found.empty() ? token.text : found);
  };
  if (use == WordUse::Unit || use == WordUse::Kept) return std::string(token.text);
  const bool reserved = token.kind == TokenKind::Reserved;
  if (reserved && use != WordUse::Member) return std::string(spelling(token.keyword));
  if (!reserved && token.kind != TokenKind::Word) return std::string(token.text);
  if (use == WordUse::Clause || use == WordUse::Shape) return to_upper(token.text);
  if (use == WordUse::Label || use == WordUse::Member) {
    return or_as_written(names_.label(token.text));
  }
  const std::string_view declared = names_.name(token.text);
  if (!declared.empty()) return std::string(declared);
  const std::string_view type =
      use == WordUse::TypeName ? type_name(token.text) : std::string_view();
  return or_as_written(type.empty() ? provided(token.text) : type);
}

/// Errors forbid touching the text.
Diagnostics errors_of(std::string_view source) {
  Diagnostics found;
  if (check_source(source, found)) parse(source, found);
  Diagnostics errors;
  for (const Diagnostic& diagnostic : found.all()) {
    if (diagnostic.severity == Severity::Error) {
      errors.add(diagnostic);
    }
  }
  return errors;
}

bool same_token(const Token& a, const Token& b) {
  if (a.kind != b.kind || a.has_unit != b.has_unit) return false;
  const bool word = a.kind == TokenKind::Word || a.kind == TokenKind::Reserved;
  return word ? same_word(a.text, b.text) : a.kind == TokenKind::EndOfLine || a.text == b.text;
}

/// Whether two texts consist of the same words in the same lines; reports where they part.
bool same_words(std::string_view source, std::string_view text, Diagnostics& diagnostics) {
  if (!check_source(text, diagnostics)) return false;
  Lexer left(source, diagnostics);
  Lexer right = Lexer(text, diagnostics).quiet_copy();
  for (;;) {
    const Token a = left.next();
    const Token b = right.next();
    if (diagnostics.has_errors()) return false;
    if (!same_token(a, b)) {
      diagnostics.error(code::kLayoutChangesWords, a.place,
                        "the layout would change the program here; it is left as it was",
                        "this is a fault of Rob's own; please report it with the program");
      return false;
    }
    if (a.kind == TokenKind::EndOfFile) return true;
  }
}

}  // namespace

Formatting format(std::string_view source) {
  Formatting result{errors_of(source), std::nullopt};
  if (result.diagnostics.has_errors()) return result;
  Layout layout(source);
  SourceLines lines(source, result.diagnostics);
  for (SourceLine line; lines.next(line);) layout.add(line);
  std::string text = layout.finish();
  if (same_words(source, text, result.diagnostics)) result.text = std::move(text);
  return result;
}

}  // namespace rob::lang
