#include "runtime/prompt/wizard_commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "lang/text/ascii.h"
#include "runtime/prompt/session.h"
#include "runtime/words/pose_values.h"

namespace rob::runtime::command {

namespace {

bool can_be_named(const std::string& word) {
  return !word.empty() && lang::begins_word(word.front()) &&
         std::ranges::all_of(word, lang::in_word);
}

void ask(Session& session) {
  session.screen().message(session.workshop().wizard->question() + "\n");
}

void begin(Session& session, PointWizard wizard) {
  session.workshop().wizard = std::move(wizard);
  ask(session);
}

/// Into the program in memory, before what may use it: after the lines that must come first.
void write_into_program(Session& session, const std::string& declaration) {
  ProgramText& program = session.workshop().program;
  if (program.empty() && !session.workshop().records) return;
  const std::string begins = declaration.substr(0, declaration.find('=') + 1);
  std::size_t after = 0;
  for (std::size_t i = 1; i <= program.size(); ++i) {
    const std::string& line = program.line(i);
    if (line.starts_with(begins))
      return session.screen().message(program.replace(i, declaration) + "\n");
    const bool header = std::ranges::any_of(
        std::array{"ROBOT", "UNITS", "USE", "LAW"},
        [&](const char* word) { return find_word(line, word) == line.find_first_not_of(" \t"); });
    if (header) after = i;
  }
  session.screen().message(program.insert(after + 1, declaration) + "\n");
}

void write(Session& session) {
  auto& wizard = session.workshop().wizard;
  if (!session.stands(wizard->command())) return;
  const std::string declaration = wizard->declaration();
  const std::size_t errors = session.errors();
  session.declare(declaration);
  if (session.errors() != errors) {
    wizard->begin_again();
    return ask(session);
  }
  write_into_program(session, declaration);
  session.screen().result(declaration + "\n");
  wizard.reset();
}

}  // namespace

void frame(Session& session, const Words& words) {
  const bool tipped = words.size() == 2;
  if (words.empty() || words.size() > 2 || !std::ranges::all_of(words, can_be_named))
    return session.fail(":frame takes the name of a frame, and of the tool that touches it",
                        ":frame table, or :frame table pen", ExitCode::Usage);
  if (tipped && !session.text().find(words[1]))
    return session.fail(fmt::format("there is no tool {}", words[1]),
                        fmt::format(":tool {} finds its tip", words[1]));
  begin(session, {PointWizard::Makes::Frame, words[0], tipped ? words[1] : ""});
}

void tool(Session& session, const Words& words) {
  if (words.size() != 1 || !can_be_named(words[0]))
    return session.fail(":tool takes the name of a tool", ":tool pen", ExitCode::Usage);
  begin(session, {PointWizard::Makes::Tool, words[0], ""});
}

void done(Session& session, const Words&) {
  const auto& wizard = session.workshop().wizard;
  if (!wizard)
    return session.fail("there is nothing to be done", ":frame and :tool ask for positions",
                        ExitCode::Usage);
  if (!wizard->enough())
    return session.fail(fmt::format("{} needs more positions", wizard->name()),
                        "Enter takes the next, :stop leaves", ExitCode::Usage);
  write(session);
}

/// A hand may hold the arm there.
void take_position(Session& session) {
  PointWizard& wizard = *session.workshop().wizard;
  if (!wizard.full()) {
    if (!session.robot().guided() && !session.stands(wizard.command())) return;
    const motion::RobotModel& robot = session.robot().robot();
    const auto& last = session.robot().reports().last();
    wizard.take(to_lang(robot.kinematics->forward(last ? last->measured : robot.start)));
  }
  if (wizard.full()) return write(session);
  ask(session);
}

bool leave_wizard(Session& session) {
  auto& wizard = session.workshop().wizard;
  if (!wizard) return false;
  session.screen().message(fmt::format("{} is left as it was\n", wizard->name()));
  wizard.reset();
  return true;
}

}  // namespace rob::runtime::command
