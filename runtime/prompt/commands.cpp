#include "runtime/prompt/commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "lang/text/suggest.h"
#include "motion/robots/robot_file.h"
#include "motion/servo/servo_backend.h"
#include "runtime/explain.h"
#include "runtime/program/files.h"
#include "runtime/prompt/session.h"

namespace rob::runtime {

namespace {

void help(Session& session, const Command::Words& words);
void quit(Session& session, const Command::Words&) { session.quit(); }

constexpr std::array kCommands = {
    Command{"jog", "", "the terminal as a pendant", command::jog},
    Command{"where", "", "the robot's place: axes, pose, state", command::where},
    Command{"signals", "", "all inputs and outputs", command::signals},
    Command{"override", "[SHARE%]", "share of the programmed speed, at once",
            command::override_speed},
    Command{"hold", "", "stand still on the path", command::hold},
    Command{"resume", "", "go on: behind :hold, HALT or a breakpoint", command::resume},
    Command{"stop", "", "brake on the path, and drop all that was commanded", command::stop},
    Command{"reset", "", "after a fault: take the robot under control again", command::reset},
    Command{"robot", "[NAME|FILE.toml]", "the robot, or another one", command::robot},
    Command{"law", "paul|lookahead", "the law of transitions", command::law},
    Command{"help", "[WORD]", "these commands, or a word of the language", help},
    Command{"quit", "", "leave; a moving robot comes to rest first", quit},
};

void help(Session& session, const Command::Words& words) {
  if (!words.empty()) {
    const std::string text = explanation_of(words.front());
    if (!text.empty()) return session.screen().result(text);
    return session.fail(fmt::format("there is no help on '{}'", words.front()),
                        ":help lists the commands");
  }
  for (const Command& one : commands()) {
    const std::string call = fmt::format(":{} {}", one.name, one.takes);
    session.screen().result(fmt::format("  {:<28} {}\n", call, one.does));
  }
}

Command::Words words_of(std::string_view line) {
  Command::Words words;
  for (std::size_t begin = line.find_first_not_of(" \t"); begin != std::string_view::npos;
       begin = line.find_first_not_of(" \t")) {
    line.remove_prefix(begin);
    const std::size_t end = std::min(line.find_first_of(" \t"), line.size());
    words.emplace_back(line.substr(0, end));
    line.remove_prefix(end);
  }
  return words;
}

/// What cannot be read, opened or known is an error of the command, not the end of the prompt.
void carry_out(Session& session, const Command& command, const Command::Words& words) {
  try {
    command.carry_out(session, words);
  } catch (const FileError& error) {
    session.fail(error.what(), "", ExitCode::InputOutput);
  } catch (const motion::RobotFileError& error) {
    session.fail(error.what());
  } catch (const motion::DriverError& error) {
    session.fail(error.what(), "", ExitCode::InputOutput);
  }
}

}  // namespace

std::span<const Command> commands() { return kCommands; }

void carry_out_command(Session& session, std::string_view line) {
  Command::Words words = words_of(line);
  const std::string name = words.empty() ? "help" : words.front();
  if (!words.empty()) words.erase(words.begin());
  const auto command = std::ranges::find(kCommands, name, &Command::name);
  if (command != kCommands.end()) return carry_out(session, *command, words);
  std::vector<std::string_view> names;
  for (const Command& one : kCommands) names.push_back(one.name);
  const std::string_view meant = lang::suggest(name, names);
  session.fail(fmt::format("there is no command :{}", name),
               meant.empty() ? ":help lists the commands" : fmt::format("did you mean :{}?", meant),
               ExitCode::Usage);
}

}  // namespace rob::runtime
