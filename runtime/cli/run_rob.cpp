#include "runtime/cli/run_rob.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <new>
#include <system_error>
#include <variant>

#include "motion/robots/robot_file.h"
#include "motion/servo/servo_backend.h"
#include "runtime/cli/commands.h"
#include "runtime/cli/options.h"
#include "runtime/files/files.h"
#include "runtime/run/console.h"
#include "runtime/run/interruption.h"
#include "runtime/run/mesh_functions.h"

namespace rob::runtime {

namespace {

int fail(ExitCode code, const char* what) {
  put_error(what);
  return static_cast<int>(code);
}

/// A stream that the caller has closed stays one that cannot be written: no file that is opened
/// later takes its number.
void keep_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(stream, F_GETFD) < 0) static_cast<void>(::open("/dev/null", O_RDONLY));
  }
}

/// `code`, unless a result could not be written.
int ended(ExitCode code) {
  const bool fails = code != ExitCode::Done && code != ExitCode::InputOutput;
  if (fails || results_written()) return static_cast<int>(code);
  return fail(ExitCode::InputOutput,
              "the results could not all be written: the disk is full, or their reader has gone");
}

/// Commands that have begun before it is known whether they read a mesh; the others look by
/// themselves. A pipe can be read only once.
bool may_need_geometry(const Options& options) {
  return options.command == Options::Command::Prompt ||
         options.command == Options::Command::ImportRobot ||
         std::ranges::find(options.files, kStandardInput) != options.files.end();
}

int carried_out(int argc, char** argv, ImportCommand import) {
  const auto parsed = parse_command_line(argc, argv);
  if (const auto* end = std::get_if<CommandLineEnd>(&parsed)) {
    put_result(end->to_stdout);
    put_message(end->to_stderr);
    return ended(end->exit_code);
  }
  const auto& options = std::get<Options>(parsed);
  if (may_need_geometry(options)) go_on_with_geometry();
  return ended(carry_out(options, import));
}

}  // namespace

int run_rob(int argc, char** argv, ImportCommand import) {
  keep_standard_streams();
  keep_arguments(argv);
  std::signal(SIGPIPE, SIG_IGN);  // a reader that goes away must not kill a robot's control
  std::signal(SIGXFSZ, SIG_IGN);  // nor a file that may grow no more: its write fails
  try {
    return carried_out(argc, argv, import);
  } catch (const UsageError& error) {
    return fail(ExitCode::Usage, error.what());
  } catch (const FileError& error) {
    return fail(ExitCode::InputOutput, error.what());
  } catch (const motion::RobotFileError& error) {
    return fail(ExitCode::ProgramError, error.what());
  } catch (const motion::DriverError& error) {
    return fail(Interruption::requested() ? Interruption::exit_code() : ExitCode::InputOutput,
                error.what());
  } catch (const std::system_error& error) {
    return fail(ExitCode::Fault, fmt::format("a thread cannot be started ({}): the system permits "
                                             "no more of them, or has no memory; nothing has moved",
                                             error.code().message())
                                     .c_str());
  } catch (const std::bad_alloc&) {
    return fail(ExitCode::Fault, "out of memory");
  }
}

}  // namespace rob::runtime
