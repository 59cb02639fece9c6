#include <utility>

#include <fmt/format.h>

#include "lang/ascii.h"
#include "lang/codes.h"
#include "lang/parser_impl.h"

/// The parser's rules for SIGNAL and for channels.
namespace rob::lang {

namespace {

constexpr std::string_view kExample = "SIGNAL part_here = DIN[1]";

}  // namespace

// "SIGNAL" NAME "=" channel
void Parser::signal_declaration(Block& block) {
  const Place place = current_.place;
  if (!open_blocks_.empty()) {
    report(code::kOnlyTopLevel, place, "SIGNAL can stand only outside all blocks",
           fmt::format("write it before the {} of line {}", spelling(open_blocks_.front().opener),
                       open_blocks_.front().place.line));
  }
  advance();
  Declaration::Declared name = declared_name("SIGNAL");
  SignalDeclaration signal;
  signal.name = name.name;
  signal.name_place = name.place;
  try {
    if (at(TokenKind::Colon)) fail_not_yet(current_.place, "an analog signal");
    if (!accept(TokenKind::Assign)) {
      fail_here(code::kAssignExpected, fmt::format("'=' expected after {}", shortened(signal.name)),
                std::string(kExample));
    }
    signal.channel_place = current_.place;
    signal.channel = channel("'='");
    if (at_word("SAFE") || at_word("SCALE")) {
      fail_not_yet(current_.place, fmt::format("{} behind a signal", to_upper(current_.text)));
    }
  } catch (const SyntaxError&) {
    Declaration unknown;
    unknown.type = Type{};
    unknown.names.push_back(std::move(name));
    add(block, place, std::move(unknown));
    throw;
  }
  add(block, place, std::move(signal));
}

bool Parser::at_channel() const {
  return (at_word("DIN") || at_word("DOUT")) && next_.kind == TokenKind::LeftBracket;
}

// channel = ( "DIN" | "DOUT" ) "[" expr "]" .
Name Parser::channel(std::string_view behind) {
  if ((at_word("AIN") || at_word("AOUT")) && next_.kind == TokenKind::LeftBracket) {
    fail_not_yet(current_.place, "an analog signal");
  }
  if (!at_channel()) {
    fail_here(
        code::kValueExpected,
        fmt::format("DIN[n] or DOUT[n] expected after {}, not {}", behind, described(current_)),
        std::string(kExample));
  }
  const Level level(*this);
  Name name;
  name.text = to_upper(current_.text);
  advance();
  advance();
  name.index = expression();
  if (!accept(TokenKind::RightBracket)) {
    fail(code::kBracketExpected, behind_previous(),
         fmt::format("']' expected after the number of {}", name.text), remedy());
  }
  return name;
}

}  // namespace rob::lang
