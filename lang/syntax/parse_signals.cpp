#include <utility>

#include <fmt/format.h>

#include "lang/syntax/keywords.h"
#include "lang/syntax/parser_impl.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"

/// The parser's rules for SIGNAL and for channels.
namespace rob::lang {

namespace {

constexpr std::string_view kExample = "SIGNAL part_here = DIN[1]";

}  // namespace

// "SIGNAL" IDENT [ ":" type ] "=" channel [ "SCALE" expr "TO" expr ] [ "SAFE" expr ]
void Parser::signal_declaration(Block& block) {
  const Place place = current_.place;
  if (!open_blocks_.empty()) {
    report(code::kOnlyTopLevel, place, "SIGNAL can stand only outside all blocks",
           fmt::format("write it before the {} of line {}", opener_of(open_blocks_.front().closer),
                       open_blocks_.front().place.line));
  }
  advance();
  Declaration::Declared name = declared_name("SIGNAL");
  SignalDeclaration signal;
  signal.name = name.name;
  signal.name_place = name.place;
  try {
    if (accept(TokenKind::Colon)) {
      signal.type_place = current_.place;
      signal.type = type();
    }
    if (!accept(TokenKind::Assign)) {
      fail_here(code::kAssignExpected, fmt::format("'=' expected after {}", shortened(signal.name)),
                std::string(kExample));
    }
    signal.channel_place = current_.place;
    signal.channel = channel("'='");
    if (at_word("SCALE")) scale(signal);
    if (at_word("SAFE")) {
      advance();
      signal.safe = expression();
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

void Parser::scale(SignalDeclaration& signal) {
  advance();
  signal.low = expression();
  if (!at_word("TO")) {
    fail_here(code::kWordExpected,
              fmt::format("TO expected after SCALE, not {}", described(current_)),
              "SIGNAL wire: SPEED = AOUT[1] SCALE 0mm/s TO 300mm/s");
  }
  advance();
  signal.high = expression();
}

// panel = "PULSE" ( foreign | channel ) expr .
void Parser::pulse(Block& block) {
  const Place place = current_.place;
  advance();
  Pulse pulse;
  pulse.target_place = current_.place;
  if (at_channel()) {
    pulse.target = channel("PULSE");
  } else if (at(TokenKind::Word) && next_.kind == TokenKind::Dot) {
    pulse.target.text = foreign_name();
  } else if (at(TokenKind::Word)) {
    pulse.target.text = current_.text;
    advance();
  } else {
    fail_here(
        code::kNameExpected,
        fmt::format("the name of an output expected after PULSE, not {}", described(current_)),
        "PULSE gripper 50ms");
  }
  if (at_line_end()) {
    fail(code::kValueExpected, behind_previous(), "a time expected: how long the output is ON",
         fmt::format("PULSE {} 50ms", shortened(pulse.target.text)));
  }
  pulse.time = expression();
  add(block, place, std::move(pulse));
}

bool Parser::at_channel() const {
  return at(TokenKind::Word) && is_channel_word(current_.text) &&
         next_.kind == TokenKind::LeftBracket;
}

// channel = ( "DIN" | "DOUT" | "AIN" | "AOUT" ) "[" expr "]" .
Name Parser::channel(std::string_view behind) {
  if (!at_channel()) {
    fail_here(code::kValueExpected,
              fmt::format("DIN[n], DOUT[n], AIN[n] or AOUT[n] expected after {}, not {}", behind,
                          described(current_)),
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
