#include <utility>

#include <fmt/format.h>

#include "lang/syntax/parser_impl.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"

/// The parser's rules for FRAME and TOOL, and for poses in a frame.
namespace rob::lang {

// decl = "TOOL" IDENT "=" expr [ "MASS" expr [ "COG" expr ] ] eol
//      | "FRAME" IDENT "=" expr eol .
void Parser::frame_declaration(Block& block) {
  const Place place = current_.place;
  const bool tool = at_word("TOOL");
  const std::string_view word = tool ? "TOOL" : "FRAME";
  if (!open_blocks_.empty()) {
    report(code::kOnlyTopLevel, place, fmt::format("{} can stand only outside all blocks", word),
           fmt::format("write it before the {} of line {}", opener_of(open_blocks_.front().closer),
                       open_blocks_.front().place.line));
  }
  advance();
  Declaration declaration;
  declaration.constant = true;
  declaration.names.push_back(declared_name(word));
  const std::string name = declaration.names.front().name;
  try {
    if (!accept(TokenKind::Assign)) {
      fail_here(code::kAssignExpected, fmt::format("'=' expected after {}", shortened(name)),
                fmt::format("{} {} = POSE(0mm, 0mm, 120mm)", word, shortened(name)));
    }
    declaration.value = expression();
    declaration.type = Type{tool ? Type::Kind::Tool : Type::Kind::Frame};
    if (tool && at_word("MASS")) {
      advance();
      declaration.mass = expression();
      if (at_word("COG")) {
        advance();
        declaration.cog = expression();
      }
    }
    declaration.frame = tool ? nullptr : &types_->frame(file_, name);
  } catch (const SyntaxError&) {
    declaration.type = Type{};
    declaration.value = nullptr;
    add(block, place, std::move(declaration));
    throw;
  }
  add(block, place, std::move(declaration));
}

/// [ "IN" IDENT ] behind POSE.
Type Parser::pose_type() {
  if (!at(Keyword::In)) return Type::pose();
  advance();
  if (!at(TokenKind::Word)) {
    fail_here(code::kNameExpected,
              fmt::format("the name of a FRAME expected after IN, not {}", described(current_)));
  }
  const Token name = current_;
  advance();
  if (same_word(name.text, "world")) return Type::pose();
  const TypeDetail* frame = imported_type(name.text, name.place, types_->frames);
  if (frame == nullptr) frame = &types_->frame(file_, name.text);
  frame_uses_.push_back({frame, name.place});
  return Type::pose(frame);
}

}  // namespace rob::lang
