#include "runtime/prompt/prompt.h"

#include <unistd.h>

#include <atomic>
#include <iostream>
#include <string>
#include <utility>

#include "runtime/program/console.h"
#include "runtime/program/interruption.h"
#include "runtime/prompt/session.h"
#include "runtime/prompt/terminal_prompt.h"

namespace rob::runtime {

namespace {

/// Entries that may be typed ahead of the robot by a pipe. [choice]
constexpr std::size_t kAhead = 100;

class PlainScreen final : public Screen {
 public:
  void result(std::string_view text) override { put_result(text); }
  void message(std::string_view text) override { put_message(text); }
};

/// Lines from a pipe or a file: no prompt, no colours, and the exit code of the first error.
ExitCode filter(Session& session, bool fast) {
  std::string entry;
  std::string line;
  while (!session.over() && !Interruption::requested() && std::getline(std::cin, line)) {
    entry += entry.empty() ? line : "\n" + line;
    if (session.enter(entry) == Session::Taken::Incomplete) continue;
    entry.clear();
    if (session.take_pendant()) session.fail("the pendant needs a terminal", "", ExitCode::Usage);
    session.carry_out_entries(fast ? 0 : kAhead);
  }
  if (!entry.empty()) session.enter(entry, true);
  session.finish();
  return Interruption::requested() ? Interruption::exit_code() : session.worst();
}

ExitCode filter(SessionOptions options) {
  std::atomic<bool> ended{false};
  const Interruption interruption(ended);
  PlainScreen screen;
  const bool fast = options.fast;
  options.ended = &ended;
  options.waits = true;
  Session session(std::move(options), screen);
  return filter(session, fast);
}

}  // namespace

ExitCode run_prompt(const Options& options) {
  SessionOptions session;
  session.robot = options.robot;
  session.law = options.law;
  session.fast = options.fast;
  session.override_share = options.override_share;
  session.seed = options.seed;
  session.trace = options.trace;
  const bool person = isatty(STDIN_FILENO) != 0 && isatty(STDOUT_FILENO) != 0;
  return person ? talk(std::move(session)) : filter(std::move(session));
}

}  // namespace rob::runtime
