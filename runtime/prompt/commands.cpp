#include "runtime/prompt/commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "lang/text/ascii.h"
#include "lang/text/suggest.h"
#include "motion/robots/robot_file.h"
#include "runtime/prompt/file_commands.h"
#include "runtime/prompt/motion_commands.h"
#include "runtime/prompt/point_commands.h"
#include "runtime/prompt/program_commands.h"
#include "runtime/prompt/run_commands.h"
#include "runtime/prompt/wizard_commands.h"
#include "runtime/words/explanation.h"

namespace rob::runtime {

namespace {

void help(Session& session, const Command::Words& words);
void quit(Session& session, const Command::Words&) { session.quit(); }

constexpr std::array kCommands = {
    Command{"jog", "", "the terminal as a pendant", command::jog},
    Command{"where", "", "the robot's position: axes and pose", command::where},
    Command{"signals", "", "all inputs and outputs", command::signals},
    Command{"override", "[SHARE%]", "share of the programmed speed, at once",
            command::override_speed},
    Command{"hold", "", "stand still on the path", command::hold},
    Command{"resume", "", "go on after :hold, HALT or a breakpoint", command::resume},
    Command{"stop", "", "brake on the path; drop what was commanded", command::stop},
    Command{"reset", "", "after a fault: the robot under control again", command::reset},
    Command{"guide", "on|off", "drives without force, for a hand and :teach", command::guide},
    Command{"home", "", "the machine homes itself", command::home},
    Command{"robot", "[NAME|FILE.toml]", "the robot, or another one", command::robot},
    Command{"law", "[paul|lookahead]", "the law of transitions, or another one", command::law},
    Command{"record", "[on|off]", "keep what is executed as the program in memory",
            command::record},
    Command{"list", "[FROM [TO]]", "the program in memory", command::list},
    Command{"edit", "LINE [TEXT]", "another text for a line; alone: change the old", command::edit,
            1},
    Command{"insert", "LINE TEXT", "a line before this one", command::insert, 1},
    Command{"delete", "LINE [TO]", "take lines out", command::erase},
    Command{"undo", "", "take back the last edit of the program", command::undo},
    Command{"redo", "", "do again what :undo took back", command::redo},
    Command{"new", "", "begin another program", command::begin_new},
    Command{"run", "[from LINE]", "the program in memory, whole or from a line on", command::run},
    Command{"step", "", "run to where the next line's motion begins", command::step},
    Command{"back", "", "drive back to where the last motion began", command::back},
    Command{"break", "[LINE | off [LINE]]", "hold where this line's motion begins; the list",
            command::breakpoints},
    Command{"check", "", "foretell it from here: times and findings", command::check},
    Command{"time", "", "foretell it from here: times", command::time},
    Command{"save", "[FILE]", "the program and its points", command::save, 0},
    Command{"save!", "[FILE]", "the same, over a file that is there", command::save_over, 0},
    Command{"load", "FILE", "a program and its points", command::load, 0},
    Command{"archive", "", "the versions that saving has replaced", command::archive},
    Command{"compare", "VERSION", "what has changed since this version", command::compare},
    Command{"restore", "VERSION", "this version becomes the program in memory", command::restore},
    Command{"vars", "", "the variables declared at the prompt", command::variables},
    Command{"teach", "POINT", "the current position becomes this point", command::teach},
    Command{"points", "[undo]", "all points; take back the last change of them", command::points},
    Command{"frame", "NAME [TOOL]", "a FRAME of three positions, which it asks for",
            command::frame},
    Command{"tool", "NAME", "a TOOL of positions that touch one tip", command::tool},
    Command{"done", "", "there are positions enough: write the TOOL", command::done},
    Command{"rename", "POINT NAME", "another name for a point", command::rename},
    Command{"forget", "POINT", "take a point out of the points file", command::forget},
    Command{"help", "[WORD]", "these commands, or a word of the language", help},
    Command{"quit", "", "leave; a moving robot comes to rest first", quit},
};

std::string row_of(const Command& command) {
  const std::string call = fmt::format(":{} {}", command.name, command.takes);
  return fmt::format("  {:<28} {}\n", call, command.does);
}

/// A word of the language, or a command with its colon.
std::string explained(std::string_view word) {
  if (!word.starts_with(':')) return explanation_of(std::string(word));
  for (const Command& one : commands())
    if (lang::same_word(one.name, word.substr(1))) return row_of(one);
  return "";
}

void help(Session& session, const Command::Words& words) {
  if (!words.empty()) {
    const std::string text = explained(words.front());
    if (!text.empty()) return session.screen().result(text);
    return session.fail(fmt::format("there is no help on '{}'", words.front()),
                        ":help lists the commands");
  }
  for (const Command& one : commands()) session.screen().result(row_of(one));
}

/// Takes the first word from what is left of a line; empty if there is none.
std::string take_word(std::string_view& line) {
  line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
  const std::size_t end = std::min(line.find_first_of(" \t"), line.size());
  std::string word(line.substr(0, end));
  line.remove_prefix(end);
  return word;
}

/// The rest after the plain words begins after one blank.
Command::Words words_of(std::string_view line, std::size_t plain) {
  Command::Words words;
  while (words.size() < plain) {
    std::string word = take_word(line);
    if (word.empty()) return words;
    words.push_back(std::move(word));
  }
  if (!line.empty()) line.remove_prefix(1);
  if (!line.empty()) words.emplace_back(line);
  return words;
}

/// The word after the colon; for an unknown word the nearest name is proposed.
void carry_out_command(Session& session, std::string_view line) {
  std::string name = take_word(line);
  if (name.empty() || name == "?") name = "help";
  if (lang::same_word(name, "exit")) name = "quit";
  const auto command = std::ranges::find_if(
      kCommands, [&](const Command& one) { return lang::same_word(one.name, name); });
  if (command != kCommands.end())
    return command->carry_out(session, words_of(line, command->plain_words));
  std::vector<std::string_view> names;
  for (const Command& one : kCommands) names.push_back(one.name);
  const std::string_view meant = lang::suggest(name, names);
  session.fail(fmt::format("there is no command :{}", name),
               meant.empty() ? ":help lists the commands" : fmt::format("did you mean :{}?", meant),
               ExitCode::Usage);
}

/// `help`, `quit`, `exit` and `?` are commands without a colon, unless the name is declared. Empty
/// where it is none.
std::string_view plain_command(const Session& session, std::string_view text) {
  std::string_view rest = text;
  const std::string word = take_word(rest);
  const std::string topic = take_word(rest);
  if (!take_word(rest).empty() || session.text().find(word)) return {};
  const bool asks = word == "?" || lang::same_word(word, "help");
  if (asks && (topic.starts_with(':') || std::ranges::all_of(topic, lang::in_word))) return text;
  const bool leaves = lang::same_word(word, "quit") || lang::same_word(word, "exit");
  return leaves && topic.empty() ? text : std::string_view();
}

}  // namespace

std::span<const Command> commands() { return kCommands; }

bool is_command(std::string_view line) {
  const std::size_t first = line.find_first_not_of(" \t\n");
  return first != std::string_view::npos && line[first] == ':';
}

Session::Taken enter(Session& session, const std::string& text, bool last) try {
  using Taken = Session::Taken;
  const std::size_t first = text.find_first_not_of(" \t\n");
  if (is_command(text)) {
    carry_out_command(session, std::string_view(text).substr(first + 1));
    return Taken::Done;
  }
  if (session.asks()) {
    session.answer(text);
    return Taken::Done;
  }
  if (first == std::string::npos) {
    if (session.workshop().wizard) command::take_position(session);
    return Taken::Done;
  }
  const std::string_view plain = plain_command(session, text);
  if (plain.empty()) return session.take(text, last);
  carry_out_command(session, plain);
  return Taken::Done;
} catch (const FileError& error) {
  session.fail(error.what(), "", ExitCode::InputOutput);
  return Session::Taken::Done;
} catch (const motion::DriverError& error) {
  session.fail(error.what(), "", ExitCode::InputOutput);
  return Session::Taken::Done;
} catch (const motion::RobotFileError& error) {
  session.fail(error.what());
  return Session::Taken::Done;
}

}  // namespace rob::runtime
