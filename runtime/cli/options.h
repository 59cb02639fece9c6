#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "lang/values/random.h"
#include "motion/robots/robot_model.h"
#include "runtime/import/import_robot.h"
#include "runtime/run/run_result.h"
#include "runtime/time/wall_time.h"

namespace rob::runtime {

/// The command line of `rob`, understood (docs/cli.md).
struct Options {
  enum class Command {
    Prompt,
    Run,
    Check,
    Test,
    Compile,
    Format,
    Robots,
    ImportRobot,
    Ports,
    Vars,
    Help,
    Explain
  };

  Command command = Command::Prompt;
  std::vector<std::string> files;
  std::string robot;  ///< a name, or a file that ends in .toml; empty: the program's own
  std::optional<motion::Law> law;  ///< without it the program's or the robot's own
  std::string trace;
  std::string path;             ///< of Check: what the planned path is written to
  std::string report;           ///< of Run and Check: the page that tells of the program
  std::string mcap;             ///< of Run: the record
  std::string replay;           ///< of Run: the record that is repeated and compared
  std::string svg;              ///< of Check: the picture of its way; "-": standard output
  bool plot = false;            ///< of Check: the same on the terminal
  std::string signals;          ///< a signal script
  std::string data;             ///< the folder of the programs' files; empty: their own
  std::string reset;            ///< of Vars: the variable that loses its value
  std::string backend = "sim";  ///< as backend_of() reads it
  bool home = false;            ///< the machine homes itself first
  double override_share = 1;
  double longest = 3600;  ///< of Check: s of a program's time for which it is followed
  std::uint64_t seed = lang::Random::kDefaultSeed;  ///< of RANDOM
  /// Which of its simulated cells the robot stands in; without it that of its file.
  std::optional<std::uint64_t> cell;
  std::string cell_file{};       ///< of what stands around the robot; empty: none
  std::optional<WallTime> date;  ///< of NOW() and UNIX() at the start
  bool fast = false;
  bool keep_going = false;  ///< of the prompt: a pipe goes on after an error
  bool json = false;
  bool listing = false;
  bool check_only = false;  ///< of Format: write nothing
  std::string word;         ///< of Explain
  std::string help_text;    ///< of Help
  ImportRequest importing;  ///< of ImportRobot
};

/// The end of a command line that could not be understood, or that was answered already (--help,
/// --version).
struct CommandLineEnd {
  ExitCode exit_code = ExitCode::Done;
  std::string to_stdout;
  std::string to_stderr;
};

std::variant<Options, CommandLineEnd> parse_command_line(int argc, const char* const* argv);

}  // namespace rob::runtime
