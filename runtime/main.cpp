#include <fmt/format.h>

#include <csignal>
#include <new>
#include <variant>

#include "motion/robots/robot_file.h"
#include "motion/servo/servo_backend.h"
#include "runtime/commands.h"
#include "runtime/options.h"
#include "runtime/program/console.h"
#include "runtime/program/files.h"
#include "runtime/program/interruption.h"

using rob::runtime::CommandLineEnd;
using rob::runtime::ExitCode;
using rob::runtime::Interruption;
using rob::runtime::Options;

namespace {

int fail(ExitCode code, const char* what) {
  rob::runtime::put_message(fmt::format("rob: {}\n", what));
  return static_cast<int>(code);
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);  // a reader that goes away must not stop a robot anywhere
  try {
    const auto parsed = rob::runtime::parse_command_line(argc, argv);
    if (const auto* end = std::get_if<CommandLineEnd>(&parsed)) {
      rob::runtime::put_result(end->to_stdout);
      rob::runtime::put_message(end->to_stderr);
      return static_cast<int>(end->exit_code);
    }
    const ExitCode code = rob::runtime::carry_out(std::get<Options>(parsed));
    if (code == ExitCode::Done && !rob::runtime::results_written()) {
      return fail(
          ExitCode::InputOutput,
          "the results could not all be written: the disk is full, or their reader has gone");
    }
    return static_cast<int>(code);
  } catch (const rob::runtime::FileError& error) {
    return fail(ExitCode::InputOutput, error.what());
  } catch (const rob::motion::RobotFileError& error) {
    return fail(ExitCode::ProgramError, error.what());
  } catch (const rob::motion::DriverError& error) {
    return fail(Interruption::requested() ? Interruption::exit_code() : ExitCode::InputOutput,
                error.what());
  } catch (const std::bad_alloc&) {
    return fail(ExitCode::Fault, "out of memory");
  }
}
