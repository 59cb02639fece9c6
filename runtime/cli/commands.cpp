#include "runtime/cli/commands.h"

#include <utility>

#include "runtime/cli/check_files.h"
#include "runtime/cli/compile_files.h"
#include "runtime/cli/explain.h"
#include "runtime/cli/format_files.h"
#include "runtime/cli/list_machines.h"
#include "runtime/cli/replay.h"
#include "runtime/cli/run_files.h"
#include "runtime/cli/test_files.h"
#include "runtime/cli/vars.h"
#include "runtime/files/files.h"
#include "runtime/prompt/prompt.h"
#include "runtime/run/console.h"
#include "runtime/run/mesh_functions.h"

namespace rob::runtime {

namespace {

SessionOptions prompt_options(const Options& options) {
  SessionOptions session;
  session.robot = options.robot;
  session.law = options.law;
  session.fast = options.fast;
  session.override_share = options.override_share;
  session.seed = options.seed;
  session.date = options.date;
  session.cell = options.cell;
  session.cell_file = options.cell_file;
  session.trace = options.trace;
  session.backend = *backend_of(options.backend);
  session.home = options.home;
  session.keep_going = options.keep_going;
  return session;
}

}  // namespace

ExitCode carry_out(const Options& options, ImportCommand import) {
  switch (options.command) {
    case Options::Command::Prompt:
      return run_prompt(prompt_options(options));
    case Options::Command::Run:
      return options.replay.empty() ? run_files(options) : replay_record(options);
    case Options::Command::Check:
      return check_files(options);
    case Options::Command::Test:
      return test_files(options);
    case Options::Command::Compile:
      return compile_files(options);
    case Options::Command::Format:
      return format_files(options);
    case Options::Command::Explain:
      return explain(options.word);
    case Options::Command::Robots:
      return list_robots(options.files);
    case Options::Command::ImportRobot:
      if (import == nullptr) throw FileError(kNoGeometry);
      return import(options.importing);
    case Options::Command::Ports:
      return list_ports();
    case Options::Command::Vars:
      return show_vars(options);
    case Options::Command::Help:
      put_result(options.help_text);
      return ExitCode::Done;
  }
  return ExitCode::Usage;
}

}  // namespace rob::runtime
