#include <fmt/format.h>

#include <cstdio>
#include <new>
#include <variant>

#include "motion/robots/robot_file.h"
#include "motion/servo/servo_backend.h"
#include "runtime/commands.h"
#include "runtime/options.h"
#include "runtime/program/files.h"

using rob::runtime::CommandLineEnd;
using rob::runtime::ExitCode;
using rob::runtime::Options;

namespace {

int fail(ExitCode code, const char* what) {
  fmt::print(stderr, "rob: {}\n", what);
  return static_cast<int>(code);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const auto parsed = rob::runtime::parse_command_line(argc, argv);
    if (const auto* end = std::get_if<CommandLineEnd>(&parsed)) {
      fmt::print(stdout, "{}", end->to_stdout);
      fmt::print(stderr, "{}", end->to_stderr);
      return static_cast<int>(end->exit_code);
    }
    return static_cast<int>(rob::runtime::carry_out(std::get<Options>(parsed)));
  } catch (const rob::runtime::FileError& error) {
    return fail(ExitCode::InputOutput, error.what());
  } catch (const rob::motion::RobotFileError& error) {
    return fail(ExitCode::ProgramError, error.what());
  } catch (const rob::motion::DriverError& error) {
    return fail(ExitCode::InputOutput, error.what());
  } catch (const std::bad_alloc&) {
    return fail(ExitCode::Fault, "out of memory");
  }
}
