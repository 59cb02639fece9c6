#include "lang/syntax/robot_name.h"

#include "lang/syntax/lexer.h"
#include "lang/text/ascii.h"
#include "lang/text/source_text.h"

namespace rob::lang {

std::optional<RobotName> declared_robot(std::string_view source) {
  Diagnostics unheard;
  if (!check_source(source, unheard)) return std::nullopt;
  const Lexer beginning(source, unheard);
  Lexer lexer = beginning.quiet_copy();
  Token before;
  for (Token token = lexer.next(); token.kind != TokenKind::EndOfFile; token = lexer.next()) {
    const bool named = token.kind == TokenKind::String && before.kind == TokenKind::Word;
    if (named && before.first_on_line && same_word(before.text, "ROBOT")) {
      return RobotName{token.string, token.place};
    }
    const bool motion = token.kind == TokenKind::Reserved &&
                        (token.keyword == Keyword::Move || token.keyword == Keyword::Movel);
    if (motion && token.first_on_line) break;  // after a statement ROBOT cannot stand
    before = std::move(token);
  }
  return std::nullopt;
}

}  // namespace rob::lang
