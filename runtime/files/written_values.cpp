#include "runtime/files/written_values.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "lang/syntax/written_value.h"
#include "lang/text/ascii.h"
#include "lang/text/source_text.h"
#include "lang/text/suggest.h"
#include "lang/values/pose_functions.h"
#include "lang/values/pose_slots.h"
#include "lang/values/units.h"
#include "runtime/files/line_reader.h"
#include "runtime/files/text_lines.h"
#include "runtime/words/codes.h"

namespace rob::runtime {

namespace {

using lang::SavedValue;
using lang::TokenKind;
using lang::Type;

class ValuesReader : LineReader {
 public:
  ValuesReader(WrittenValues& values, std::string_view text,
               const std::vector<KeptVariable>& variables)
      : LineReader(text, values.diagnostics, code::kValuesLine,
                   "mend the line, or take it out with rob vars FILE --reset NAME"),
        values_(values),
        variables_(variables) {}

  void read() {
    read_lines([&] {
      line();
      return true;
    });
  }

 private:
  void line();
  std::string name();
  void value(const Type& type, SavedValue& into);
  void enumerator(const lang::TypeDetail& detail, SavedValue& into);
  void number(const Type& type, SavedValue& into);
  void truth(SavedValue& into);
  void row(const Type& type, std::int64_t count, SavedValue& into);
  void list(const Type& element, SavedValue& into);
  void pose(SavedValue& into);
  void record(const lang::TypeDetail& detail, SavedValue& into);

  WrittenValues& values_;
  const std::vector<KeptVariable>& variables_;
};

/// "tools.count", or "count".
std::string ValuesReader::name() {
  std::string name;
  for (bool further = true; further;) {
    if (token_.kind != TokenKind::Word) expected("the name of a variable");
    name += token_.text;
    advance();
    further = token_.kind == TokenKind::Dot;
    if (further) name += ".";
    if (further) advance();
  }
  return name;
}

/// A value that no variable asks for may be anything, to the end of its line.
void ValuesReader::line() {
  const lang::Place place = token_.place;
  const std::string name = this->name();
  take(TokenKind::Assign, "'='");
  const std::string key = lang::to_upper(name);
  if (!values_.lines.try_emplace(key, WrittenValues::Line{name, "", place}).second)
    fail(code::kValuesLine, place,
         fmt::format("{} stands here a second time", lang::shortened(name)),
         "keep one of the two lines");
  const auto variable = std::ranges::find_if(
      variables_, [&](const KeptVariable& one) { return lang::same_word(one.name, name); });
  if (variable == variables_.end()) {
    while (!at_line_end()) advance();
    return;
  }
  SavedValue saved;
  value(variable->type, saved);
  end_of_line();
  values_.saved[static_cast<std::size_t>(variable - variables_.begin())] = std::move(saved);
}

void ValuesReader::value(const Type& type, SavedValue& into) {
  switch (type.kind) {
    case Type::Kind::Bool:
      return truth(into);
    case Type::Kind::Int:
    case Type::Kind::Real:
      return number(type, into);
    case Type::Kind::Enum:
      return enumerator(*type.detail, into);
    case Type::Kind::String:
      return into.texts.push_back(take_text("a text between quotes"));
    case Type::Kind::Vec:
      take(TokenKind::LeftParen, "'('");
      row(Type::real(type.dimension), 3, into);
      return take(TokenKind::RightParen, "')'");
    case Type::Kind::Pose:
      return pose(into);
    case Type::Kind::Array:
      take(TokenKind::LeftBracket, "'['");
      row(type.detail->element, type.detail->length, into);
      return take(TokenKind::RightBracket, "']' after so many elements as the variable has");
    case Type::Kind::List:
      return list(type.detail->element, into);
    default:
      return record(*type.detail, into);
  }
}

/// red
void ValuesReader::enumerator(const lang::TypeDetail& detail, SavedValue& into) {
  const bool word = token_.kind == TokenKind::Word || token_.kind == TokenKind::Reserved;
  const auto value = word ? lang::value_of(detail, token_.text) : std::nullopt;
  if (!value) expected(fmt::format("a name of {}, such as {},", detail.name, detail.names.front()));
  into.numbers.push_back({.integer = *value});
  advance();
}

void ValuesReader::number(const Type& type, SavedValue& into) {
  const bool negative = token_.kind == TokenKind::Minus;
  if (negative) advance();
  const auto slot = token_.kind == TokenKind::Number ? lang::slot_of(token_.number, negative, type)
                                                     : std::nullopt;
  if (!slot) expected(fmt::format("{}, such as {},", lang::in_words(type), lang::example_of(type)));
  into.numbers.push_back(*slot);
  advance();
}

void ValuesReader::truth(SavedValue& into) {
  const bool yes = at_word("TRUE");
  if (!yes && !at_word("FALSE")) expected("TRUE or FALSE");
  into.numbers.push_back({.integer = yes ? 1 : 0});
  advance();
}

void ValuesReader::row(const Type& type, std::int64_t count, SavedValue& into) {
  for (std::int64_t i = 0; i < count; ++i) {
    if (i > 0) take(TokenKind::Comma, "','");
    value(type, into);
  }
}

/// [1mm, 2mm], with any number of elements
void ValuesReader::list(const Type& element, SavedValue& into) {
  take(TokenKind::LeftBracket, "'['");
  for (; token_.kind != TokenKind::RightBracket; ++into.count) {
    if (into.count > 0) take(TokenKind::Comma, "',' or ']'");
    value(element, into);
  }
  advance();
}

/// POSE(x, y, z, a, b, c)
void ValuesReader::pose(SavedValue& into) {
  take_word("POSE");
  take(TokenKind::LeftParen, "'('");
  SavedValue parts;
  row(Type::real(lang::kLength), 3, parts);
  take(TokenKind::Comma, "','");
  row(Type::real(lang::kAngle), 3, parts);
  take(TokenKind::RightParen, "')'");
  std::vector<lang::Slot> pose(lang::kPoseSlots);
  lang::pose_functions::pose_of(parts.numbers, pose.front());
  into.numbers.insert(into.numbers.end(), pose.begin(), pose.end());
}

/// part(width: 20mm, name: "a"), with its fields in their order.
void ValuesReader::record(const lang::TypeDetail& detail, SavedValue& into) {
  take_word(detail.name);
  take(TokenKind::LeftParen, "'('");
  for (const lang::TypeDetail::Field& field : detail.fields) {
    if (&field != &detail.fields.front()) take(TokenKind::Comma, "','");
    take_word(field.name);
    take(TokenKind::Colon, "':'");
    value(field.type, into);
  }
  take(TokenKind::RightParen, "')'");
}

/// The text of each line after its '='.
void take_texts(WrittenValues& values, std::string_view text) {
  std::map<std::uint32_t, WrittenValues::Line*> by_line;
  for (auto& [key, line] : values.lines) by_line[line.place.line] = &line;
  for (std::uint32_t number = 1; !text.empty(); ++number) {
    std::string_view line = take_line(text);
    const auto found = by_line.find(number);
    if (found == by_line.end()) continue;
    line.remove_prefix(line.find('=') + 1);
    while (line.starts_with(' ')) line.remove_prefix(1);
    while (line.ends_with('\r') || line.ends_with(' ')) line.remove_suffix(1);
    found->second->text = line;
  }
}

}  // namespace

WrittenValues read_values(std::string_view text, const std::vector<KeptVariable>& variables) {
  WrittenValues values;
  values.saved.resize(variables.size());
  if (!lang::check_source(text, values.diagnostics)) return values;
  ValuesReader(values, text, variables).read();
  if (!values.diagnostics.has_errors()) take_texts(values, text);
  return values;
}

std::string text_of_values(const std::map<std::string, WrittenValues::Line>& lines) {
  std::string text;
  for (const auto& [key, line] : lines) text += fmt::format("{} = {}\n", line.name, line.text);
  return text;
}

}  // namespace rob::runtime
