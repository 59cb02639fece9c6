#include "runtime/prompt/prompt.h"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <optional>
#include <string>
#include <utility>

#include "runtime/files/files.h"
#include "runtime/files/run_mark.h"
#include "runtime/prompt/commands.h"
#include "runtime/prompt/entry_lines.h"
#include "runtime/prompt/session.h"
#include "runtime/prompt/terminal_prompt.h"
#include "runtime/run/console.h"
#include "runtime/run/interruption.h"
#include "runtime/run/output_file.h"

namespace rob::runtime {

namespace {

/// Entries that may be typed ahead of the robot by a pipe. [choice]
constexpr std::size_t kAhead = 100;

class PlainScreen final : public Screen {
 public:
  void result(std::string_view text) override { put_result(text); }
  void message(std::string_view text) override { put_message(text); }
};

/// A line longer than that is no statement of a person, nor of a program that writes them. [choice]
constexpr std::size_t kMostLine = std::size_t{1} << 20U;

/// The lines of standard input, as they come.
class InputLines {
 public:
  /// None behind the last, where it cannot be read, and where the process shall end.
  std::optional<std::string> next() {
    std::size_t end = bytes_.find('\n', begin_);
    while (end == std::string::npos) {
      bytes_.erase(0, std::exchange(begin_, 0));
      if (bytes_.size() > kMostLine) {
        trouble_ = fmt::format("a line of more than {} bytes", kMostLine);
        return std::nullopt;
      }
      const std::size_t before = bytes_.size();
      if (!read_more()) {
        if (bytes_.empty() || !trouble_.empty() || Interruption::requested()) return std::nullopt;
        return std::exchange(bytes_, "");
      }
      end = bytes_.find('\n', before);
    }
    std::string line = bytes_.substr(begin_, end - begin_);
    begin_ = end + 1;
    return line;
  }
  /// Why there is no further one; empty at the end of the input.
  const std::string& trouble() const { return trouble_; }

 private:
  bool read_more() {
    std::array<char, 65536> bytes;
    for (;;) {
      const ssize_t count = ::read(STDIN_FILENO, bytes.data(), bytes.size());
      if (Interruption::requested() || count == 0) return false;
      if (count > 0) {
        bytes_.append(bytes.data(), static_cast<std::size_t>(count));
        return true;
      }
      if (errno == EINTR) continue;
      trouble_ = fmt::format("standard input cannot be read: {}", std::strerror(errno));
      return false;
    }
  }

  std::string bytes_;
  std::size_t begin_ = 0;  ///< of those that have not been handed out
  std::string trouble_;
};

/// Lines from a pipe or a file: no prompt, no colours, and the exit code of the first error.
ExitCode filter(Session& session, bool fast) {
  InputLines lines;
  EntryLines entry;
  while (!session.over() && !Interruption::requested()) {
    const auto line = lines.next();
    if (!line) break;
    if (is_command(*line)) {
      enter(session, *line);
    } else {
      entry.add(*line);
      const bool last = entry.text().size() > kMostLine;
      if (!last && !session.asks() && entry.surely_goes_on()) continue;
      if (enter(session, entry.text(), last) == Session::Taken::Incomplete) {
        entry.note_open_block();
        continue;
      }
      entry.clear();
    }
    if (session.take_pendant()) session.fail("the pendant needs a terminal", "", ExitCode::Usage);
    session.carry_out_entries(fast ? 0 : kAhead);
  }
  if (!entry.empty()) enter(session, entry.text(), true);
  if (!lines.trouble().empty()) session.fail(lines.trouble(), "", ExitCode::InputOutput);
  session.finish();
  if (session.asks() && !Interruption::requested())
    session.fail("the input has ended, and nobody answers any more", "", ExitCode::Fault);
  if (session.robot().held() && !session.robot().idle())
    session.fail("the input has ended, and the robot is held", "let :resume or :stop come behind",
                 ExitCode::Fault);
  return Interruption::requested() ? Interruption::exit_code() : session.worst();
}

ExitCode filter(SessionOptions options) {
  StopRequests requests;
  const Interruption interruption(requests);
  PlainScreen screen;
  const bool fast = options.fast;
  options.requests = &requests;
  options.waits = true;
  Session session(std::move(options), screen);
  return filter(session, fast);
}

}  // namespace

ExitCode run_prompt(SessionOptions options) {
  std::optional<RunMark> running;
  if (!options.fast) {
    for (const std::string& end : unclean_ends()) put_message(end);
    try {
      running.emplace("the prompt", options.robot.empty() ? "gantry" : options.robot);
    } catch (const FileError& error) {
      put_error(fmt::format("warning: {}", error.what()));
    }
  }
  if (!options.trace.empty()) {
    std::vector<InputFile> inputs{{options.points_file, "where the prompt keeps points"}};
    if (options.robot.ends_with(".toml")) inputs.push_back({options.robot, "the robot file"});
    refuse_overwriting("--trace", options.trace, inputs);
  }
  const bool person = isatty(STDIN_FILENO) != 0 && isatty(STDOUT_FILENO) != 0;
  return person ? talk(std::move(options)) : filter(std::move(options));
}

}  // namespace rob::runtime
