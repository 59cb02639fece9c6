#include "lang/syntax/watch_parser.h"

#include <utility>

#include <fmt/format.h>

#include "lang/syntax/keywords.h"
#include "lang/text/codes.h"

namespace rob::lang {

namespace {

/// Whether the one action of a WHEN is none that a control cycle can do by itself: the axes have to
/// stand.
bool stops_for(const Block& action) {
  return !action.empty() && (std::holds_alternative<Brake>(action.front().node) ||
                             std::holds_alternative<Halt>(action.front().node));
}

}  // namespace

// wait = "WAIT" expr [ "TIMEOUT" expr [ "ELSE" simple ] ] .
void WatchParser::wait(Block& block) {
  const Place place = tokens_.place();
  Wait wait;
  tokens_.advance();
  wait.value = expressions_.expression();
  if (tokens_.at_word("TIMEOUT")) {
    tokens_.advance();
    wait.timeout = expressions_.expression();
  }
  if (tokens_.at(Keyword::Else) && !tokens_.current().first_on_line) {
    if (wait.timeout == nullptr) {
      tokens_.fail_here(code::kWordExpected, "ELSE of a WAIT needs a TIMEOUT before it",
                        "WAIT part_here TIMEOUT 3s ELSE lift = OFF");
    }
    wait.has_else = true;
    tokens_.advance();
    alternative(wait.otherwise);
  }
  tree_.add(block, place, std::move(wait));
}

// "RECEIVE" foreign "INTO" place "TIMEOUT" expr [ "ELSE" simple ]
void WatchParser::receive(Block& block) {
  const Place place = tokens_.place();
  tokens_.advance();
  Receive node;
  node.device_place = tokens_.place();
  node.device.text = device_name(tokens_, names_, "RECEIVE");
  const auto word = [&](std::string_view expected) {
    if (!tokens_.at_word(expected)) {
      tokens_.fail_here(code::kReceiveIncomplete,
                        fmt::format("{} expected, not {}", expected, described(tokens_.current())),
                        "for example RECEIVE scale INTO line TIMEOUT 2s");
    }
    tokens_.advance();
  };
  word("INTO");
  node.target = expressions_.postfix();
  word("TIMEOUT");
  node.timeout = expressions_.expression();
  if (tokens_.at(Keyword::Else) && !tokens_.current().first_on_line) {
    node.has_else = true;
    tokens_.advance();
    alternative(node.otherwise);
  }
  tree_.add(block, place, std::move(node));
}

/// The one statement after the ELSE of a WAIT.
void WatchParser::alternative(Block& block) {
  if (tokens_.at_line_end()) {
    tokens_.fail_behind(code::kStatementExpected, "a statement expected after ELSE");
  }
  const TreeBuilder::Level level(tree_);  // it may be a WAIT with an ELSE of its own
  statements_.simple(block);
}

// until = "UNTIL" expr [ "ELSE" simple ] .
// motion [ until ] "DO" eol { trigger eol } "ENDMOVE" eol
void WatchParser::behind_motion(Block& block, bool may_open_block) {
  if (!tokens_.at(Keyword::Until) && !tokens_.at(Keyword::Do)) return;
  const Place place = block.back().place;
  WatchedMotion watched;
  watched.motion.push_back(std::move(block.back()));
  block.pop_back();
  if (tokens_.at(Keyword::Until)) {
    tokens_.advance();
    watched.until = expressions_.expression();
    if (tokens_.at(Keyword::Else) && !tokens_.current().first_on_line) {
      tokens_.advance();
      watched.has_else = true;
      alternative(watched.otherwise);
    }
  }
  if (tokens_.at(Keyword::Do)) {
    if (!may_open_block) {
      tokens_.fail_here(code::kMisplaced,
                        "a motion with DO cannot stand on the line of another statement",
                        "begin a new line before it");
    }
    path_events(watched, place);
  }
  tree_.add(block, place, std::move(watched));
}

void WatchParser::path_events(WatchedMotion& motion, const Place& place) {
  constexpr std::size_t kMostEvents = 8;  // of one motion, as the machine takes them
  const OpenBlock open{Keyword::Endmove, place};
  tokens_.advance();
  blocks_.header_end("a motion with DO");
  blocks_.read_lines(open, [&] {
    try {
      motion.events.push_back(path_event());
      tokens_.end_of_line();
    } catch (const SyntaxError&) {
      tokens_.recover();
    }
  });
  blocks_.close(open);
  if (motion.events.size() <= kMostEvents) return;
  tokens_.report(code::kTooManyEvents, motion.events[kMostEvents].place,
                 fmt::format("a motion can have {} path events", kMostEvents),
                 "divide the motion; it is blended into the next");
}

// trigger = ( "AFTER" | "BEFORE" ) expr [ ( "LEAD" | "LAG" ) expr ] ":" action .
WayPoint WatchParser::path_event() {
  WayPoint event;
  event.place = tokens_.place();
  event.before = tokens_.at_word("BEFORE");
  if (!event.before && !tokens_.at_word("AFTER")) {
    tokens_.fail_here(code::kMisplaced,
                      fmt::format("between DO and ENDMOVE stand AFTER and BEFORE, not {}",
                                  described(tokens_.current())),
                      "for example AFTER 2mm : lift = ON");
  }
  tokens_.advance();
  event.distance = expressions_.expression();
  event.lag = tokens_.at_word("LAG");
  if (event.lag || tokens_.at_word("LEAD")) {
    tokens_.advance();
    event.shift = expressions_.expression();
  }
  action(event.action, event.before ? "the place of BEFORE" : "the place of AFTER");
  return event;
}

// "WHEN" expr ":" action eol | "WHEN" expr "DO" eol block "ENDWHEN" eol
void WatchParser::when(Block& block) {
  const OpenBlock open{Keyword::Endwhen, tokens_.place()};
  When when;
  bool has_block = tokens_.line_ends_with(Keyword::Do);
  tokens_.advance();
  when.condition = has_block ? blocks_.condition(Keyword::Do) : expressions_.expression();
  if (!has_block && tokens_.at(Keyword::Do)) {
    blocks_.header_word(Keyword::Do, "the condition");
    blocks_.header_end("WHEN … DO");
    has_block = true;
  }
  if (has_block) {
    when.action = blocks_.read(open);
    routines_.add_handler(open.place, tokens_.place());
    blocks_.close(open);
  } else {
    action(when.action, "WHEN");
    when.handled = stops_for(when.action);
    if (when.handled) routines_.add_handler(open.place, open.place);
  }
  when.handled = when.handled || has_block;
  tree_.add(block, open.place, std::move(when));
}

/// The action after the ':' of a WHEN: one statement on the same line.
void WatchParser::action(Block& block, std::string_view behind) {
  if (!tokens_.accept(TokenKind::Colon)) {
    tokens_.fail_behind(code::kWordExpected, fmt::format("':' expected after {}", behind),
                        tokens_.remedy());
  }
  if (tokens_.at_line_end()) {
    tokens_.fail_behind(code::kStatementExpected, "a statement expected after ':'",
                        "for example lift = OFF");
  }
  const TreeBuilder::Level level(tree_);
  statements_.simple(block);
}

}  // namespace rob::lang
