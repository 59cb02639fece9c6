#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "lang/syntax/parser_impl.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"
#include "lang/text/suggest.h"
#include "lang/text/utf8.h"
#include "lang/values/units.h"

/// The parser's rules for VAR and CONST.
namespace rob::lang {

namespace {

struct NamedType {
  std::string_view name;
  Type type;
};

constexpr auto real(Dimension dimension) { return Type{Type::Kind::Real, dimension}; }

constexpr auto kTypes = std::to_array<NamedType>({
    {"BOOL", {Type::Kind::Bool, {}}},
    {"INT", {Type::Kind::Int, {}}},
    {"REAL", real(kNone)},
    {"STRING", {Type::Kind::String, {}}},
    {"LENGTH", real(kLength)},
    {"ANGLE", real(kAngle)},
    {"TIME", real(kTime)},
    {"SPEED", real(kSpeed)},
    {"ANGULAR_SPEED", real(kAngularSpeed)},
    {"ACCELERATION", real(kAcceleration)},
    {"FORCE", real(kForce)},
    {"TORQUE", real(kTorque)},
    {"MASS", real(kMass)},
    {"FREQUENCY", real(kFrequency)},
    {"VOLTAGE", real(kVoltage)},
    {"VEC", {Type::Kind::Vec, kLength}},
    {"POSE", {Type::Kind::Pose}},
    {"JOINTS", {Type::Kind::Joints}},
    {"WRENCH", {Type::Kind::Wrench}},
    {"FRAME", {Type::Kind::Frame}},
    {"TOOL", {Type::Kind::Tool}},
});

std::string type_help(std::string_view word, const std::set<std::string>& records) {
  if (same_word(word, "REF")) return "REF stands before the name, as in REF n: INT";
  std::vector<std::string_view> names(records.begin(), records.end());
  std::ranges::transform(kTypes, std::back_inserter(names), &NamedType::name);
  const std::string help = did_you_mean(suggest(word, names));
  if (!help.empty() || !find_unit(word)) return help;
  return fmt::format("a unit as a type stands in brackets: [{}]", word);
}

}  // namespace

std::optional<Type> named_type(std::string_view word) {
  const auto found = std::ranges::find_if(
      kTypes, [&](const NamedType& type) { return same_word(type.name, word); });
  return found == kTypes.end() ? std::nullopt : std::optional(found->type);
}

// decl = "CONST" IDENT [ ":" type ] "=" expr eol
//      | "VAR" names ( ":" type [ "=" expr ] | "=" expr ) eol .
void Parser::declaration(Block& block) {
  const Place place = current_.place;
  Declaration declaration;
  declaration.constant = at(Keyword::Const);
  advance();
  try {
    declared_names(declaration);
    declared_type_and_value(declaration);
  } catch (const SyntaxError&) {
    declaration.type = Type{};
    declaration.value = nullptr;
    if (!declaration.names.empty()) add(block, place, std::move(declaration));
    throw;
  }
  add(block, place, std::move(declaration));
}

// names = IDENT { "," IDENT } .
void Parser::declared_names(Declaration& declaration) {
  const std::string_view kind = declaration.constant ? "CONST" : "VAR";
  declaration.names.push_back(declared_name(kind));
  while (!declaration.constant && accept(TokenKind::Comma)) {
    declaration.names.push_back(declared_name(kind));
  }
}

void Parser::declared_type_and_value(Declaration& declaration) {
  if (accept(TokenKind::Colon)) declaration.type = type();
  if (at(TokenKind::Equal)) {
    report(code::kAssignExpected, current_.place, "'==' compares, it does not give a value",
           "write =");
    current_.kind = TokenKind::Assign;
  }
  if (accept(TokenKind::Assign)) {
    declaration.value = expression();
    return;
  }
  if (!at_line_end()) {
    fail_here(code::kAssignExpected, fmt::format("'=' expected, not {}", described(current_)));
  }
  const std::string& name = declaration.names.front().name;
  if (declaration.constant) {
    fail(code::kIncompleteDeclaration, behind_previous(), "a constant needs a value",
         fmt::format("CONST {} = 10mm", shortened(name)));
  }
  if (!declaration.type) {
    fail(code::kIncompleteDeclaration, behind_previous(), "a variable needs a type or a value",
         fmt::format("VAR {0} = 10mm, or VAR {0}: LENGTH", shortened(name)));
  }
}

Declaration::Declared Parser::declared_name(std::string_view kind) {
  if (at(TokenKind::Reserved)) {
    fail_here(code::kReservedName,
              fmt::format("{} is a reserved word and cannot be a name", described(current_)),
              "choose another name");
  }
  if (!at(TokenKind::Word)) {
    fail_here(code::kNameExpected,
              fmt::format("a name expected after {}, not {}", kind, described(current_)));
  }
  if (outline_.names_file(current_.text)) {
    report(code::kNameOfUsedFile, current_.place,
           fmt::format("{} is the name of a file that is USEd here", described(current_)),
           "choose another name");
  }
  count_name();
  Declaration::Declared declared{std::string(current_.text), current_.place};
  advance();
  return declared;
}

void Parser::count_name() {
  if (++names_ <= kMaxNames) return;
  report(code::kProgramTooLarge, current_.place,
         fmt::format("the program is too large: it declares more than {} names", kMaxNames),
         "keep many values of one kind in an ARRAY");
  throw GiveUp{};
}

// type = ( IDENT | "FRAME" | "TOOL" ) [ "IN" IDENT ] | "[" unit "]"
//      | "ARRAY" "[" expr "]" "OF" type .
Type Parser::type() {
  if (at(TokenKind::LeftBracket)) return unit_type();
  const Token word = current_;
  if (at(Keyword::Array)) return array_type();
  if (!at(TokenKind::Word)) {
    fail_here(code::kUnknownType, fmt::format("a type expected, not {}", described(word)),
              type_help(word.text, defined_names().records));
  }
  if (const auto known = named_type(word.text)) {
    advance();
    if (known->is(Type::Kind::Pose)) return pose_type();
    if (known->is(Type::Kind::Joints)) return Type::joints(types_->joints.get());
    return known->is(Type::Kind::Vec) && at_word("OF") ? vec_type() : *known;
  }
  const TypeDetail* record = imported_type(word.text, word.place, types_->records);
  if (record == nullptr && names_record(word.text)) record = &types_->record(file_, word.text);
  if (record != nullptr) {
    advance();
    return {Type::Kind::Record, {}, record};
  }
  fail_here(code::kUnknownType, fmt::format("{} is no type", described(word)),
            type_help(word.text, defined_names().records));
}

/// "OF" type behind VEC, which alone is one of LENGTH.
Type Parser::vec_type() {
  advance();
  const Token word = current_;
  const Type part = type();
  if (part.is(Type::Kind::Real)) return Type::vec(part.dimension);
  fail(code::kUnknownType, word.place,
       fmt::format("a VEC is made of numbers with a unit, or of REAL; this is {}", in_words(part)),
       "as in VEC OF FORCE");
}

// "[" unit "]": names are units here, reserved words or not, so the source itself is looked at.
Type Parser::unit_type() {
  advance();
  const Token first = current_;
  while (!at_line_end() && !at(TokenKind::RightBracket) && !at(TokenKind::Bad)) advance();
  if (!at(TokenKind::RightBracket) || current_.place.line != first.place.line) {
    fail(code::kBracketExpected, behind_previous(), "']' expected after the unit");
  }
  std::string unit_name(source_.substr(first.offset, current_.offset - first.offset));
  std::erase_if(unit_name, [](char c) { return c == ' ' || c == '\t'; });
  const auto unit = find_unit(unit_name);
  if (!unit) {
    Token written = first;
    written.text = unit_name;
    written.place.length = std::max(count_code_points(unit_name), 1U);
    fail(code::kUnknownUnit, written.place, fmt::format("{} is no unit", described(written)),
         did_you_mean(suggest(unit_name, unit_names())));
  }
  advance();
  return real(unit->dimension);
}

}  // namespace rob::lang
