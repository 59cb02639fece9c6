#include "runtime/prompt/prompt.h"

#include <atomic>
#include <iostream>
#include <string>
#include <utility>

#include "runtime/program/console.h"
#include "runtime/program/interruption.h"
#include "runtime/prompt/session.h"

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

}  // namespace

ExitCode run_prompt(const Options& options) {
  std::atomic<bool> ended{false};
  const Interruption interruption(ended);
  PlainScreen screen;
  SessionOptions session_options;
  session_options.robot = options.robot;
  session_options.law = options.law;
  session_options.fast = options.fast;
  session_options.override_share = options.override_share;
  session_options.seed = options.seed;
  session_options.trace = options.trace;
  session_options.waits = true;
  session_options.ended = &ended;
  Session session(std::move(session_options), screen);
  return filter(session, options.fast);
}

}  // namespace rob::runtime
