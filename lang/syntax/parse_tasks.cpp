#include <utility>

#include <fmt/format.h>

#include "lang/syntax/parser_impl.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"

/// The parser's rules for TASK and START.
namespace rob::lang {

// routine = "TASK" IDENT eol block "ENDTASK" eol .
void Parser::task() {
  const OpenBlock open{Keyword::Task, Keyword::Endtask, current_.place};
  if (!open_blocks_.empty()) {
    report(code::kMisplaced, current_.place,
           "TASK can only stand at the top level, outside of all blocks",
           fmt::format("move it behind the end of the {} of line {}",
                       spelling(open_blocks_.front().opener), open_blocks_.front().place.line));
  }
  Routine task;
  task.place = open.place;
  task.task = true;
  advance();
  try {
    Declaration::Declared name = declared_name("TASK");
    task.name = std::move(name.name);
    task.name_place = name.place;
    if (at(TokenKind::LeftParen)) {
      fail_here(code::kLineEndExpected, "a TASK has no parameters",
                "it sees the variables of the program's top level");
    }
    header_end("TASK");
  } catch (const SyntaxError&) {
    task.sound = false;
    skip_header();
  }
  task.body = block_of(open);
  task.end = current_.place;
  close(open);
  if (task.name.empty()) return;
  count_node(task.place);
  task.index = routines_.size();
  routines_.push_back(std::move(task));
}

// control = "START" foreign .
void Parser::start_statement(Block& block) {
  const Place place = current_.place;
  advance();
  if (!at(TokenKind::Word)) {
    fail_here(code::kNameExpected,
              fmt::format("the name of a TASK expected after START, not {}", described(current_)));
  }
  Start start;
  start.task_place = current_.place;
  if (next_.kind == TokenKind::Dot) {  // the checker knows whether a file is called so
    start.task.text = foreign_name();
  } else {
    start.task.text = current_.text;
    advance();
  }
  add(block, place, std::move(start));
}

}  // namespace rob::lang
