#include <utility>

#include <fmt/format.h>

#include "lang/syntax/parser_impl.h"
#include "lang/text/codes.h"

/// The parser's rules for what is looked at in every control cycle.
namespace rob::lang {

// until = "UNTIL" expr [ "ELSE" simple ] .
// motion [ until ] "DO" eol { trigger eol } "ENDMOVE" eol
void Parser::behind_motion(Block& block, bool may_open_block) {
  if (!at(Keyword::Until) && !at(Keyword::Do)) return;
  const Place place = block.back().place;
  WatchedMotion watched;
  watched.motion.push_back(std::move(block.back()));
  block.pop_back();
  if (at(Keyword::Until)) {
    advance();
    watched.until = expression();
    if (at(Keyword::Else) && !current_.first_on_line) {
      advance();
      watched.has_else = true;
      alternative(watched.otherwise);
    }
  }
  if (at(Keyword::Do)) {
    if (!may_open_block) {
      fail_here(code::kMisplaced, "a motion with DO cannot stand on the line of another statement",
                "begin a new line before it");
    }
    path_events(watched, place);
  }
  add(block, place, std::move(watched));
}

void Parser::path_events(WatchedMotion& motion, const Place& place) {
  constexpr std::size_t kMostEvents = 8;  // of one motion, as the machine takes them
  const OpenBlock open{Keyword::Move, Keyword::Endmove, place};
  advance();
  header_end("a motion with DO");
  open_blocks_.push_back(open);
  for (;;) {
    while (accept(TokenKind::EndOfLine)) {
    }
    if (at(TokenKind::EndOfFile) || at_block_end()) break;
    try {
      motion.events.push_back(path_event());
      end_of_line();
    } catch (const SyntaxError&) {
      recover();
    }
  }
  open_blocks_.pop_back();
  close(open);
  if (motion.events.size() <= kMostEvents) return;
  report(code::kTooManyEvents, motion.events[kMostEvents].place,
         fmt::format("a motion can have {} path events", kMostEvents),
         "divide the motion; it is blended into the next");
}

// trigger = ( "AFTER" | "BEFORE" ) expr [ ( "LEAD" | "LAG" ) expr ] ":" action .
WayPoint Parser::path_event() {
  WayPoint event;
  event.place = current_.place;
  event.before = at_word("BEFORE");
  if (!event.before && !at_word("AFTER")) {
    fail_here(
        code::kMisplaced,
        fmt::format("between DO and ENDMOVE stand AFTER and BEFORE, not {}", described(current_)),
        "for example AFTER 2mm : lift = ON");
  }
  advance();
  event.distance = expression();
  event.lag = at_word("LAG");
  if (event.lag || at_word("LEAD")) {
    advance();
    event.shift = expression();
  }
  action(event.action, event.before ? "the place of BEFORE" : "the place of AFTER");
  return event;
}

// "WHEN" expr ":" action eol | "WHEN" expr "DO" eol block "ENDWHEN" eol
void Parser::when_statement(Block& block) {
  const OpenBlock open{Keyword::When, Keyword::Endwhen, current_.place};
  When when;
  bool has_block = line_ends_with(Keyword::Do);
  advance();
  when.condition = has_block ? condition(Keyword::Do) : expression();
  if (!has_block && at(Keyword::Do)) {
    header_word(Keyword::Do, "the condition");
    header_end("WHEN … DO");
    has_block = true;
  }
  if (has_block) {
    when.action = block_of(open);
    add_handler(open.place, current_.place);
    close(open);
  } else {
    action(when.action, "WHEN");
    when.handled = stops_for(when.action);
    if (when.handled) add_handler(open.place, open.place);
  }
  when.handled = when.handled || has_block;
  add(block, open.place, std::move(when));
}

/// Whether the one action of a WHEN is none that a control cycle can do by itself: the axes have to
/// stand.
bool Parser::stops_for(const Block& action) {
  return !action.empty() && (std::holds_alternative<Brake>(action.front().node) ||
                             std::holds_alternative<Halt>(action.front().node));
}

void Parser::add_handler(const Place& place, const Place& end) {
  Routine routine;
  routine.place = place;
  routine.end = end;
  routine.handler = true;
  routine.name = "WHEN";
  routine.index = routines_.size();
  routines_.push_back(std::move(routine));
}

/// What stands behind the ':' of a WHEN: one statement on the same line.
void Parser::action(Block& block, std::string_view behind) {
  if (!accept(TokenKind::Colon)) {
    fail(code::kWordExpected, behind_previous(), fmt::format("':' expected behind {}", behind),
         remedy());
  }
  if (at_line_end()) {
    fail(code::kStatementExpected, behind_previous(), "a statement expected behind ':'",
         "for example lift = OFF");
  }
  const Level level(*this);
  simple(block);
}

}  // namespace rob::lang
