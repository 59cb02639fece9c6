#include "runtime/cli/options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <filesystem>
#include <iterator>
#include <sstream>
#include <string_view>
#include <utility>

#include "lang/text/suggest.h"
#include "lang/text/visible.h"
#include "runtime/files/files.h"
#include "runtime/run/machine.h"
#include "runtime/words/arguments.h"
#include "runtime/words/version.h"

namespace rob::runtime {

namespace {

std::string check_override(const std::string& text) {
  if (override_of(text)) return "";
  return fmt::format("takes a share from above 0% to {}%, not '{}'", kMostOverride, text);
}

std::string check_duration(const std::string& text) {
  if (duration_of(text)) return "";
  return fmt::format("takes a time above 0 with its unit, such as 90s, 20min or 8h, not '{}'",
                     text);
}

std::string check_date(const std::string& text) {
  if (wall_time_of(text)) return "";
  return fmt::format(
      "takes a date with time and offset, such as 2026-03-01T08:30:00+01:00, not '{}'", text);
}

/// A script whose variable is not set gives an empty name: it must not mean "none".
std::string check_name(const std::string& name) {
  return name.empty() ? "takes a name, which must not be empty" : "";
}

std::string check_robot_file(const std::string& name) {
  if (name.ends_with(".toml") && name.size() > 5) return "";
  return fmt::format("takes the name of a file that ends in .toml, not '{}'", name);
}

std::string check_law(const std::string& law) {
  if (law == "paul" || law == "lookahead") return "";
  return fmt::format("there is no law '{}'; there are paul and lookahead", law);
}

std::string check_backend(const std::string& backend) {
  if (backend_of(backend)) return "";
  return fmt::format(
      "there is no backend '{}'; there are {}, such as grbl:/dev/ttyUSB0 or grbl:tcp://host:23"
      " (rob ports lists the serial ports)",
      backend, backend_names());
}

/// CLI11's objects and the texts that they write into.
struct Parser {
  CLI::App app{"Rob: programs that move robots, exactly where and exactly when they say.", "rob"};
  Options options;
  std::string override_text = "100%";
  std::string duration_text = "1h";
  std::string law;
  std::optional<std::uint64_t> seed;
  std::string date;
  std::string topic;

  Parser();
  void add_files(CLI::App& command) {
    command.add_option("FILE", options.files, "programs (.rob); - is standard input")
        ->required()
        ->check(check_name);
  }
  void add_robot(CLI::App& command) {
    command.add_option("--robot", options.robot, "a robot's name (rob robots), or its file.toml")
        ->check(check_name);
    command.add_option("--law", law, "transition law: paul or lookahead")->check(check_law);
  }
  void add_cell(CLI::App& command) {
    command
        .add_option("--cell", options.cell_file,
                    "a file.toml of obstacles that stand around the robot")
        ->check(check_robot_file);
  }
  void add_seed(CLI::App& command) {
    command
        .add_option("--seed", seed,
                    "where RANDOM begins, and which simulated cell: a whole number from 0")
        ->check(CLI::NonNegativeNumber);
  }
  void add_date(CLI::App& command) {
    command
        .add_option("--date", date,
                    "when NOW() begins, such as 2026-03-01T08:30:00+01:00; else 2000-01-01, or now")
        ->check(check_date);
  }
  void add_signals(CLI::App& command) {
    command.add_option("--signals", options.signals, "a script that drives the simulated inputs")
        ->check(check_name);
  }
  void add_data(CLI::App& command) {
    command
        .add_option("--data", options.data,
                    "the folder of the files that the program reads and writes, if not its own")
        ->check(CLI::ExistingDirectory);
  }
  void add_backend(CLI::App& command) {
    command
        .add_option("--backend", options.backend,
                    "what moves: sim, or a machine, such as grbl:/dev/ttyUSB0")
        ->check(check_backend);
  }
  void add_motion(CLI::App& command) {
    add_backend(command);
    command.add_flag("--home", options.home, "the machine homes itself first");
    command.add_flag("--fast", options.fast, "on the virtual clock, as fast as possible");
    command
        .add_option("--trace", options.trace, "write a row for each reference period to this file")
        ->check(check_name);
    command.add_option("--override", override_text, "share of the programmed speed, such as 50%")
        ->check(check_override);
  }
  void add_report(CLI::App& command) {
    command
        .add_option("--report", options.report,
                    "write a page that shows it: way, curves, lines; of one program")
        ->check(check_name);
  }
  void add_json(CLI::App& command) {
    command.add_flag("--json", options.json, "print one JSON document, and nothing else");
  }
  void add_prompt();
  void add_run();
  void add_check();
  void add_test();
  void add_import();
  void add_others();
};

Parser::Parser() {
  app.set_version_flag("--version", kVersion);
  app.require_subcommand(0, 1);
  app.footer("Start with: rob run examples/01_triangle.rob");
  add_prompt();
  add_run();
  add_check();
  add_test();
  add_import();
  add_others();
}

/// Without a command: the prompt, or statements from a pipe.
void Parser::add_prompt() {
  add_robot(app);
  add_cell(app);
  add_seed(app);
  add_date(app);
  add_motion(app);
  app.add_flag("--keep-going", options.keep_going,
               "carry out all that comes through a pipe, whatever goes wrong in it");
}

void Parser::add_run() {
  CLI::App& run = *app.add_subcommand("run", "run a program");
  run.callback([this] { options.command = Options::Command::Run; });
  add_files(run);
  add_robot(run);
  add_cell(run);
  add_json(run);
  add_seed(run);
  add_date(run);
  add_signals(run);
  add_data(run);
  add_motion(run);
  add_report(run);
  run.get_option("FILE")->required(false);  // --replay has its own
  run.add_option("--mcap", options.mcap,
                 "record joints, signals, prints and the program in this file; of one program")
      ->check(check_name);
  run.add_option("--replay", options.replay,
                 "repeat the run of this record in virtual time, and compare (the statement REPLAY"
                 " is another thing: rob help REPLAY)")
      ->check(check_name);
}

void Parser::add_check() {
  CLI::App& check = *app.add_subcommand("check", "compile, and foretell each line; nothing moves");
  check.callback([this] { options.command = Options::Command::Check; });
  add_files(check);
  add_robot(check);
  add_cell(check);
  add_json(check);
  add_seed(check);
  add_date(check);
  add_signals(check);
  add_data(check);
  add_backend(check);
  add_report(check);
  check
      .add_option("--svg", options.svg,
                  "draw the way with its lines and corners to this file, or to - as the output")
      ->check(check_name);
  check.add_flag("--plot", options.plot, "draw the way on the terminal");
  check
      .add_option("--path", options.path,
                  "write the path that the look-ahead law plans to this file")
      ->check(check_name);
  check
      .add_option("--for", duration_text,
                  "how much of the program's time it is followed: 90s, 20min, 8h; else 1h")
      ->check(check_duration);
}

void Parser::add_test() {
  CLI::App& test = *app.add_subcommand("test", "run the TESTs of programs, in virtual time");
  test.callback([this] { options.command = Options::Command::Test; });
  add_files(test);
  add_robot(test);
  add_cell(test);
  add_seed(test);
  add_data(test);
  add_date(test);
  add_json(test);
}

void Parser::add_import() {
  CLI::App& robot = *app.add_subcommand("robot", "make the file of a robot: rob robot import");
  robot.require_subcommand(1);
  CLI::App& made = *robot.add_subcommand("import", "make a robot file from the URDF of an arm");
  made.callback([this] { options.command = Options::Command::ImportRobot; });
  ImportRequest& request = options.importing;
  made.add_option("FILE", request.urdf, "the URDF (run xacro first)")
      ->required()
      ->check(check_name);
  made.add_option("-o,--output", request.robot, "the robot file to write: ARM.toml")
      ->required()
      ->check(check_robot_file);
  made.add_option("--base", request.choice.base, "the link that stands; else the root")
      ->check(check_name);
  made.add_option("--tip", request.choice.tip, "the link that is the flange; else the only end")
      ->check(check_name);
  made.add_option("--gripper", request.choice.gripper, "a joint of the gripper: an axis, too")
      ->check(check_name);
  made.add_option("--package", request.packages, "the folder of package://, if not above the URDF")
      ->check(CLI::ExistingDirectory);
}

void Parser::add_others() {
  CLI::App& compile = *app.add_subcommand("compile", "compile a program");
  compile.callback([this] { options.command = Options::Command::Compile; });
  add_files(compile);
  add_robot(compile);
  add_cell(compile);
  compile.add_flag("--listing", options.listing, "print the bytecode");

  CLI::App& format = *app.add_subcommand("fmt", "give programs their canonical layout");
  format.callback([this] { options.command = Options::Command::Format; });
  add_files(format);
  add_robot(format);
  format.add_flag("--check", options.check_only, "write nothing; name the files that differ");

  CLI::App& vars = *app.add_subcommand("vars", "the values that a program keeps between runs");
  vars.callback([this] { options.command = Options::Command::Vars; });
  add_files(vars);
  add_robot(vars);
  vars.add_option("--reset", options.reset, "take the value of this variable out")
      ->check(check_name);

  CLI::App& robots = *app.add_subcommand("robots", "the robots known, and what each can do");
  robots.callback([this] { options.command = Options::Command::Robots; });
  robots.add_option("ROBOT", options.files, "robots' names or files: only these, and more of them")
      ->check(check_name);
  app.add_subcommand("ports", "the serial ports, and whether they are free")->callback([this] {
    options.command = Options::Command::Ports;
  });
  CLI::App& help = *app.add_subcommand("help", "explain a command or a word of the language");
  help.callback([this] { options.command = Options::Command::Help; });
  help.add_option("WORD", topic, "a command, a statement, a clause, a unit, a function, or a code");
}

/// `help`: the way out, where there is a better one than the list.
CommandLineEnd usage_error(const std::string& message, const std::string& help = "") {
  return {ExitCode::Usage, "",
          fmt::format("rob: {}{}\nrob --help lists the commands\n", lang::on_one_line(message),
                      help.empty() ? "" : "; " + lang::on_one_line(help))};
}

std::variant<Options, CommandLineEnd> help_on(Parser& parser) {
  if (parser.topic.empty()) {  // App::help() would be that of `rob help`
    parser.options.help_text =
        parser.app.get_formatter()->make_help(&parser.app, "rob", CLI::AppFormatMode::Normal);
    return parser.options;
  }
  for (const CLI::App* command : parser.app.get_subcommands([](CLI::App*) { return true; })) {
    if (!command->check_name(parser.topic)) continue;
    const auto inside = command->get_subcommands([](const CLI::App*) { return true; });
    parser.options.help_text =
        inside.empty() ? command->help("rob") : inside.front()->help("rob " + command->get_name());
    return parser.options;
  }
  parser.options.command = Options::Command::Explain;
  parser.options.word = parser.topic;
  return parser.options;
}

using Names = std::vector<std::string>;

Names command_names(const CLI::App& app) {
  Names names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  return names;
}

Names option_names(const CLI::App& app) {
  Names names;
  for (const CLI::Option* option : app.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

std::string meant(const std::string& word, const Names& names) {
  const std::vector<std::string_view> candidates(names.begin(), names.end());
  return lang::did_you_mean(lang::suggest(word, candidates));
}

bool takes_value(const CLI::App& command, const std::string& word) {
  const CLI::Option* const option = command.get_option_no_throw(word);
  return option != nullptr && option->get_items_expected() > 0;
}

/// `rob a.rob` is `rob run a.rob`: the first word that is no option says so.
bool names_program(const CLI::App& app, const Names& words) {
  const CLI::App& run = *app.get_subcommand("run");
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    if (word == kStandardInput || word.ends_with(".rob")) return true;
    if (!word.starts_with('-')) return false;
    if (takes_value(run, word)) ++i;
  }
  return false;
}

/// The command that was chosen, with those inside it: "robot import"; empty: none.
std::string chosen_name(const CLI::App& app) {
  const auto chosen = app.get_subcommands();
  if (chosen.empty()) return "";
  const std::string inside = chosen_name(*chosen.front());
  return chosen.front()->get_name() + (inside.empty() ? "" : " " + inside);
}

const CLI::App& chosen_command(const CLI::App& app) {
  const auto chosen = app.get_subcommands();
  return chosen.empty() ? app : chosen_command(*chosen.front());
}

/// The first word that fits nowhere.
CommandLineEnd unexpected(const CLI::App& app) {
  const std::string chosen = chosen_name(app);
  const CLI::App& command = chosen_command(app);
  const Names rest = app.remaining(true);
  const std::string word = rest.empty() ? "" : rest.front();
  if (word.starts_with('-')) {
    const std::string option = word.substr(0, word.find('='));
    const std::string of = chosen.empty() ? "" : " of rob " + chosen;
    return usage_error(fmt::format("there is no option {}{}", lang::shortened(option), of),
                       meant(option, option_names(command)));
  }
  if (!chosen.empty())
    return usage_error(fmt::format("rob {} takes no '{}'", chosen, lang::shortened(word)),
                       meant(word, command_names(command)));
  std::string help = meant(word, command_names(app));
  std::error_code none;
  if (help.empty() && std::filesystem::is_regular_file(word, none)) help = "rob run " + word;
  return usage_error(fmt::format("there is no command '{}'", lang::shortened(word)), help);
}

/// A command without what it needs: a file, or the command inside it.
CommandLineEnd incomplete(const CLI::App& app, const std::string& problem) {
  const Names inside = command_names(chosen_command(app));
  if (inside.empty()) return usage_error(problem);
  if (!app.remaining(true).empty()) return unexpected(app);
  const std::string command = chosen_name(app);
  return usage_error(fmt::format("rob {} takes a command", command),
                     fmt::format("rob {} {}", command, inside.front()));
}

}  // namespace

std::variant<Options, CommandLineEnd> parse_command_line(int argc, const char* const* argv) {
  Parser parser;
  Names words(argv + 1, argv + argc);
  if (names_program(parser.app, words)) words.insert(words.begin(), "run");
  try {
    std::ranges::reverse(words);  // as CLI11 wants them
    parser.app.parse(std::move(words));
  } catch (const CLI::ExtrasError&) {
    return unexpected(parser.app);
  } catch (const CLI::RequiredError& error) {
    return incomplete(parser.app, error.what());
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) return usage_error(error.what());
    std::ostringstream out;  // --help and --version end the parsing with what they print
    parser.app.exit(error, out, out);
    return CommandLineEnd{ExitCode::Done, out.str(), ""};
  }
  parser.options.override_share = *override_of(parser.override_text);
  parser.options.longest = *duration_of(parser.duration_text);
  parser.options.seed = parser.seed.value_or(lang::Random::kDefaultSeed);
  parser.options.cell = parser.seed;
  if (!parser.date.empty()) parser.options.date = wall_time_of(parser.date);
  if (!parser.law.empty())
    parser.options.law = parser.law == "paul" ? motion::Law::Paul : motion::Law::LookAhead;
  if (parser.options.command == Options::Command::Help) return help_on(parser);
  if (parser.options.command == Options::Command::Run) {
    const bool files = !parser.options.files.empty();
    if (!files && parser.options.replay.empty()) return usage_error("FILE is required");
    if (files && !parser.options.replay.empty())
      return usage_error("--replay takes the program out of the record; leave FILE out");
  }
  const bool simulated = backend_of(parser.options.backend)->simulated();
  if (parser.options.fast && !simulated)
    return usage_error("--fast is for the simulation; a machine moves in real time");
  if (parser.options.home && simulated)
    return usage_error("--home is for a machine; the simulation knows where it stands");
  if (!parser.options.trace.empty() && parser.options.files.size() > 1) {
    return usage_error("--trace records one program; run the others without it");
  }
  if (parser.options.command == Options::Command::Vars && parser.options.files.size() > 1)
    return usage_error("rob vars is of one program");
  if (!parser.options.path.empty() && parser.options.files.size() > 1) {
    return usage_error("--path is of one program; check the others without it");
  }
  if (!parser.options.report.empty() && parser.options.files.size() > 1)
    return usage_error("--report is of one program; the others need reports of their own");
  if (!parser.options.mcap.empty() && parser.options.files.size() > 1)
    return usage_error("--mcap records one program; run the others without it");
  if (!parser.options.svg.empty() && parser.options.files.size() > 1)
    return usage_error("--svg is of one program; draw the others one by one");
  if (parser.options.json && (parser.options.svg == kStandardInput || parser.options.plot))
    return usage_error("--json prints one document alone; write the picture with --svg FILE");
  return parser.options;
}

}  // namespace rob::runtime
