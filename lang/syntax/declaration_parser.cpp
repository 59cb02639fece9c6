#include "lang/syntax/declaration_parser.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "lang/syntax/keywords.h"
#include "lang/syntax/named_types.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"
#include "lang/text/suggest.h"

namespace rob::lang {
namespace {

constexpr std::size_t kMostEnumNames = 256;
constexpr std::string_view kObstacleExample =
    "OBSTACLE box = BOX(POSE(100mm, 0mm, 20mm), 80mm, 60mm, 40mm)";

}  // namespace

// decl = "CONST" IDENT [ ":" type ] "=" expr eol
//      | "VAR" names ( ":" type [ "=" expr ] | "=" expr ) eol .
void DeclarationParser::variables(Block& block, bool persist) {
  const Place place = tokens_.place();
  Declaration declaration;
  declaration.persist = persist;
  declaration.constant = tokens_.at(Keyword::Const);
  tokens_.advance();
  try {
    declared_names(declaration);
    declared_type_and_value(declaration);
  } catch (const SyntaxError&) {
    declaration.type = Type{};
    declaration.value = nullptr;
    if (!declaration.names.empty()) tree_.add(block, place, std::move(declaration));
    throw;
  }
  tree_.add(block, place, std::move(declaration));
}

// decl = "PERSIST" "VAR" names ( ":" type [ "=" expr ] | "=" expr ) eol .
void DeclarationParser::persist(Block& block) {
  blocks_.check_declaration("PERSIST");
  tokens_.advance();
  if (!tokens_.at(Keyword::Var)) {
    tokens_.fail_here(
        code::kPersistIncomplete,
        fmt::format("VAR expected after PERSIST, not {}", described(tokens_.current())),
        "PERSIST VAR count = 0");
  }
  variables(block, true);
}

// names = IDENT { "," IDENT } .
void DeclarationParser::declared_names(Declaration& declaration) {
  const std::string_view kind = declaration.constant ? "CONST" : "VAR";
  declaration.names.push_back(names_.declared(kind));
  while (!declaration.constant && tokens_.accept(TokenKind::Comma)) {
    declaration.names.push_back(names_.declared(kind));
  }
}

void DeclarationParser::declared_type_and_value(Declaration& declaration) {
  if (tokens_.accept(TokenKind::Colon)) declaration.type = types_.type();
  if (tokens_.at(TokenKind::Equal)) {
    tokens_.report(code::kAssignExpected, tokens_.place(),
                   "'==' compares, it does not give a value", "write =");
    tokens_.take_for(TokenKind::Assign);
  }
  if (tokens_.accept(TokenKind::Assign)) {
    declaration.value = expressions_.expression();
    return;
  }
  if (!tokens_.at_line_end()) {
    tokens_.fail_here(code::kAssignExpected,
                      fmt::format("'=' expected, not {}", described(tokens_.current())));
  }
  const std::string& name = declaration.names.front().name;
  if (declaration.constant) {
    tokens_.fail_behind(code::kIncompleteDeclaration, "a constant needs a value",
                        fmt::format("CONST {} = 10mm", shortened(name)));
  }
  if (!declaration.type) {
    tokens_.fail_behind(code::kIncompleteDeclaration, "a variable needs a type or a value",
                        fmt::format("VAR {0} = 10mm, or VAR {0}: LENGTH", shortened(name)));
  }
}

/// The names that a skipped statement declares, so that their uses are no further mistakes.
void DeclarationParser::unknown(Block& block) {
  Declaration declaration;
  declaration.type = Type{};
  while (tokens_.at(TokenKind::Word)) {
    declaration.names.push_back({std::string(tokens_.text()), tokens_.place()});
    tokens_.advance();
    if (!tokens_.accept(TokenKind::Comma)) break;
  }
  if (!declaration.names.empty()) tree_.add(block, tokens_.place(), std::move(declaration));
}

// "SIGNAL" IDENT [ ":" type ] "=" channel [ "SCALE" expr "TO" expr ] [ "SAFE" expr ]
void DeclarationParser::signal(Block& block) {
  const Place place = tokens_.place();
  blocks_.check_declaration("SIGNAL");
  tokens_.advance();
  Declaration::Declared name = names_.declared("SIGNAL");
  SignalDeclaration signal;
  signal.name = name.name;
  signal.name_place = name.place;
  try {
    if (tokens_.accept(TokenKind::Colon)) {
      signal.type_place = tokens_.place();
      signal.type = types_.type();
    }
    if (!tokens_.accept(TokenKind::Assign)) {
      tokens_.fail_here(code::kAssignExpected,
                        fmt::format("'=' expected after {}", shortened(signal.name)),
                        "SIGNAL part_here = DIN[1]");
    }
    signal.channel_place = tokens_.place();
    signal.channel = expressions_.channel("'='", &signal.last);
    if (tokens_.at_word("SCALE")) scale(signal);
    if (tokens_.at_word("SAFE")) {
      tokens_.advance();
      signal.safe = expressions_.expression();
    }
  } catch (const SyntaxError&) {
    Declaration unknown;
    unknown.type = Type{};
    unknown.names.push_back(std::move(name));
    tree_.add(block, place, std::move(unknown));
    throw;
  }
  tree_.add(block, place, std::move(signal));
}

void DeclarationParser::scale(SignalDeclaration& signal) {
  tokens_.advance();
  signal.low = expressions_.expression();
  if (!tokens_.at_word("TO")) {
    tokens_.fail_here(code::kWordExpected,
                      fmt::format("TO expected after SCALE, not {}", described(tokens_.current())),
                      "SIGNAL wire: SPEED = AOUT[1] SCALE 0mm/s TO 300mm/s");
  }
  tokens_.advance();
  signal.high = expressions_.expression();
}

// decl = "DEVICE" IDENT "=" expr [ "ENDING" expr ] eol .
void DeclarationParser::device(Block& block) {
  const Place place = tokens_.place();
  blocks_.check_declaration("DEVICE");
  tokens_.advance();
  DeviceDeclaration device;
  device.declared = names_.declared("DEVICE");
  try {
    if (!tokens_.accept(TokenKind::Assign)) {
      tokens_.fail_here(
          code::kAssignExpected,
          fmt::format("'=' and an address expected after {}", shortened(device.declared.name)),
          "DEVICE scale = \"tcp://192.168.1.30:4001\"");
    }
    device.address = expressions_.expression();
    if (tokens_.at_word("ENDING")) {
      tokens_.advance();
      device.ending = expressions_.expression();
    }
  } catch (const SyntaxError&) {
    device.address = nullptr;
    tree_.add(block, place, std::move(device));
    throw;
  }
  tree_.add(block, place, std::move(device));
}

// decl = "OBSTACLE" IDENT "=" ( "BOX" | "SPHERE" | "CAPSULE" | "MESH" ) "(" expr { "," expr } ")" .
void DeclarationParser::obstacle(Block& block) {
  const Place place = tokens_.place();
  blocks_.check_declaration("OBSTACLE");
  tokens_.advance();
  ObstacleDeclaration obstacle;
  obstacle.declared = names_.declared("OBSTACLE");
  try {
    if (!tokens_.accept(TokenKind::Assign)) {
      tokens_.fail_here(
          code::kAssignExpected,
          fmt::format("'=' and a shape expected after {}", shortened(obstacle.declared.name)),
          std::string(kObstacleExample));
    }
    obstacle_shape(obstacle);
  } catch (const SyntaxError&) {
    obstacle.values.clear();
    tree_.add(block, place, std::move(obstacle));
    throw;
  }
  tree_.add(block, place, std::move(obstacle));
}

void DeclarationParser::obstacle_shape(ObstacleDeclaration& obstacle) {
  constexpr std::array<std::string_view, 4> kShapes{"BOX", "SPHERE", "CAPSULE", "MESH"};
  const auto* const shape =
      std::ranges::find_if(kShapes, [&](std::string_view word) { return tokens_.at_word(word); });
  obstacle.shape_place = tokens_.place();
  if (shape == kShapes.end() || tokens_.next().kind != TokenKind::LeftParen) {
    const std::string meant =
        tokens_.at(TokenKind::Word) ? did_you_mean(suggest(tokens_.text(), kShapes)) : "";
    tokens_.fail_here(code::kNoObstacleShape,
                      fmt::format("an OBSTACLE is BOX(…), SPHERE(…), CAPSULE(…) or MESH(…), not {}",
                                  described(tokens_.current())),
                      meant.empty() ? std::string(kObstacleExample) : meant);
  }
  obstacle.kind = static_cast<Obstacle::Kind>(shape - kShapes.begin());
  tokens_.advance();
  obstacle.values = shape_values();
}

/// The brackets of a shape hold these.
std::vector<ExprPtr> DeclarationParser::shape_values() {
  if (!tokens_.accept(TokenKind::LeftParen)) {
    tokens_.fail_here(code::kWordExpected,
                      fmt::format("'(' expected, not {}", described(tokens_.current())));
  }
  std::vector<ExprPtr> values;
  do {
    values.push_back(expressions_.expression());
  } while (tokens_.accept(TokenKind::Comma));
  if (!tokens_.accept(TokenKind::RightParen)) {
    tokens_.fail_here(code::kWordExpected,
                      fmt::format("',' or ')' expected, not {}", described(tokens_.current())));
  }
  return values;
}

// "SHAPE" "CAPSULE" "(" expr "," expr "," expr ")" { "," "CAPSULE" "(" … ")" }
void DeclarationParser::tool_shape(Declaration& tool) {
  constexpr std::string_view kExample = "SHAPE CAPSULE((0mm, 0mm, 0mm), (0mm, 0mm, 90mm), 20mm)";
  tokens_.advance();
  do {
    const Place place = tokens_.place();
    if (!tokens_.at_word("CAPSULE")) {
      tokens_.fail_here(
          code::kNoObstacleShape,
          fmt::format("the SHAPE of a TOOL is CAPSULE(…), not {}", described(tokens_.current())),
          std::string(kExample));
    }
    tokens_.advance();
    std::vector<ExprPtr> values = shape_values();
    if (values.size() != 3) {
      tokens_.fail(
          code::kNoObstacleShape, place,
          fmt::format("a CAPSULE has two ends and a radius; these are {} values", values.size()),
          std::string(kExample));
    }
    if (tool.shape.size() == kMostToolCapsules) {
      tokens_.fail(code::kTooManyCapsules, place,
                   fmt::format("a SHAPE has at most {} capsules", kMostToolCapsules),
                   "one that is longer or thicker covers several");
    }
    tool.shape.push_back({std::move(values[0]), std::move(values[1]), std::move(values[2])});
  } while (tokens_.accept(TokenKind::Comma));
}

// decl = "POINT" names [ "=" expr ] eol .
void DeclarationParser::point(Block& block) {
  const Place place = tokens_.place();
  blocks_.check_declaration("POINT");
  tokens_.advance();
  PointDeclaration points;
  try {
    do {
      points.points.push_back({.declared = names_.declared("POINT")});
    } while (tokens_.accept(TokenKind::Comma));
    if (tokens_.accept(TokenKind::Assign)) {
      points.value = expressions_.expression();
    } else if (!tokens_.at_line_end()) {
      tokens_.fail_here(code::kAssignExpected,
                        fmt::format("'=' expected, not {}", described(tokens_.current())),
                        fmt::format("POINT {} = POSE(10mm, 20mm, 0mm), or the name alone",
                                    shortened(points.points.front().declared.name)));
    }
  } catch (const SyntaxError&) {
    points.sound = false;
    points.value = nullptr;
    tree_.add(block, place, std::move(points));
    throw;
  }
  tree_.add(block, place, std::move(points));
}

// decl = "TOOL" IDENT "=" expr [ "MASS" expr [ "COG" expr ] ] [ "SHAPE" capsule { "," capsule } ]
// eol
//      | "FRAME" IDENT "=" expr eol .
void DeclarationParser::frame_or_tool(Block& block) {
  const Place place = tokens_.place();
  const bool tool = tokens_.at_word("TOOL");
  const std::string_view word = tool ? "TOOL" : "FRAME";
  blocks_.check_declaration(word);
  tokens_.advance();
  Declaration declaration;
  declaration.constant = true;
  declaration.names.push_back(names_.declared(word));
  const std::string name = declaration.names.front().name;
  try {
    if (!tokens_.accept(TokenKind::Assign)) {
      tokens_.fail_here(code::kAssignExpected,
                        fmt::format("'=' expected after {}", shortened(name)),
                        fmt::format("{} {} = POSE(0mm, 0mm, 120mm)", word, shortened(name)));
    }
    declaration.value = expressions_.expression();
    declaration.type = Type{tool ? Type::Kind::Tool : Type::Kind::Frame};
    if (tool && tokens_.at_word("MASS")) {
      tokens_.advance();
      declaration.mass = expressions_.expression();
      if (tokens_.at_word("COG")) {
        tokens_.advance();
        declaration.cog = expressions_.expression();
      }
    }
    if (tool && tokens_.at_word("SHAPE")) tool_shape(declaration);
    declaration.frame = tool ? nullptr : &names_.own_frame(name);
  } catch (const SyntaxError&) {
    declaration.type = Type{};
    declaration.value = nullptr;
    tree_.add(block, place, std::move(declaration));
    throw;
  }
  tree_.add(block, place, std::move(declaration));
}

// decl = "RECORD" NAME eol { NAME { "," NAME } ":" type eol } "ENDRECORD" eol .
void DeclarationParser::record(Block& block) {
  const OpenBlock open{Keyword::Endrecord, tokens_.place()};
  blocks_.check_declaration("RECORD");
  RecordDeclaration record;
  tokens_.advance();
  try {
    record.declared = names_.declared("RECORD");
    if (named_type(record.declared.name) != nullptr) {
      tokens_.fail(code::kReservedName, record.declared.place,
                   fmt::format("{} is a type of the language", shortened(record.declared.name)),
                   "choose another name");
    }
    record.detail = &names_.own_record(record.declared.name);
    blocks_.header_end("RECORD");
  } catch (const SyntaxError&) {
    record.sound = false;
    tokens_.skip_line();
  }
  record_fields(record);
  // A statement that stands where a field should is left for what follows.
  const bool statement = tokens_.at(TokenKind::Reserved) && !tokens_.at(Keyword::End) &&
                         role(tokens_.current().keyword) != KeywordRole::Closer;
  statement ? blocks_.report_unclosed(open) : blocks_.close(open);
  if (record.detail != nullptr) tree_.add(block, open.place, std::move(record));
}

void DeclarationParser::record_fields(RecordDeclaration& record) {
  const auto at_end = [&] {
    return tokens_.at(TokenKind::EndOfFile) ||
           (tokens_.at(TokenKind::Reserved) &&
            role(tokens_.current().keyword) != KeywordRole::Value);
  };
  for (;;) {
    tokens_.skip_line_ends();
    if (at_end()) return;
    try {
      record.groups.push_back(record_group());
      tokens_.end_of_line();
    } catch (const SyntaxError&) {
      record.sound = false;
      tokens_.recover();
    }
  }
}

RecordDeclaration::Fields DeclarationParser::record_group() {
  RecordDeclaration::Fields group;
  do {
    tree_.count(tokens_.place());
    group.names.push_back(names_.declared("RECORD"));
  } while (tokens_.accept(TokenKind::Comma));
  if (!tokens_.accept(TokenKind::Colon)) {
    tokens_.fail_behind(code::kWordExpected, "':' and a type expected after the field",
                        fmt::format("for example {}: LENGTH", shortened(group.names.back().name)));
  }
  group.type = types_.type();
  return group;
}

// decl = "ENUM" NAME ":" WORD { "," WORD } eol .
void DeclarationParser::enumeration(Block& block) {
  const Place place = tokens_.place();
  blocks_.check_declaration("ENUM");
  EnumDeclaration node;
  tokens_.advance();
  node.declared = names_.declared("ENUM");
  if (named_type(node.declared.name) != nullptr) {
    tokens_.fail(code::kReservedName, node.declared.place,
                 fmt::format("{} is a type of the language", shortened(node.declared.name)),
                 "choose another name");
  }
  node.detail = &names_.own_enum(node.declared.name);
  try {
    enum_names(node);
  } catch (const SyntaxError&) {
    node.detail->faulty = true;
    tree_.add(block, place, std::move(node));
    throw;
  }
  tree_.add(block, place, std::move(node));
}

/// After ENUM and its point a reserved word is a name like any other.
void DeclarationParser::enum_names(EnumDeclaration& enumeration) {
  if (!tokens_.accept(TokenKind::Colon)) {
    tokens_.fail_behind(
        code::kWordExpected, "':' and the names of the ENUM expected",
        fmt::format("ENUM {}: red, green, blue", shortened(enumeration.declared.name)));
  }
  do {
    if (!tokens_.at(TokenKind::Word) && !tokens_.at(TokenKind::Reserved)) {
      tokens_.fail_here(code::kNameExpected, fmt::format("a name of the ENUM expected, not {}",
                                                         described(tokens_.current())));
    }
    if (enumeration.names.size() == kMostEnumNames) {
      tokens_.fail_here(code::kEnumTooLong,
                        fmt::format("an ENUM has at most {} names", kMostEnumNames),
                        "what is counted is an INT");
    }
    tree_.count(tokens_.place());
    enumeration.names.push_back({std::string(tokens_.text()), tokens_.place()});
    tokens_.advance();
  } while (tokens_.accept(TokenKind::Comma));
}

// decl = "USE" IDENT eol .
void DeclarationParser::use(Block& block) {
  const Place place = tokens_.place();
  blocks_.check_declaration("USE");
  tokens_.advance();
  if (!tokens_.at(TokenKind::Word)) {
    tokens_.fail_here(
        code::kNameExpected,
        fmt::format("the name of a file expected after USE, not {}", described(tokens_.current())),
        "USE tools brings in what tools.rob declares");
  }
  Use use;
  use.name = tokens_.text();
  tokens_.advance();
  if (tokens_.at(TokenKind::Dot)) {
    tokens_.fail_here(code::kLineEndExpected, "USE takes the name of a file without its ending",
                      fmt::format("USE {}", shortened(use.name)));
  }
  names_.resolve(use);
  tree_.add(block, place, std::move(use));
}

}  // namespace rob::lang
