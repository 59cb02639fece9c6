#include "runtime/prompt/prompt.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
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
  /// None after the last, where it cannot be read, and where the process shall end.
  std::optional<std::string> next() {
    std::size_t end = bytes_.find('\n', begin_);
    while (end == std::string::npos) {
      bytes_.erase(0, std::exchange(begin_, 0));
      if (bytes_.size() > kMostLine) {
        refuse_line();
        return std::nullopt;
      }
      const std::size_t before = bytes_.size();
      if (!read_more()) {
        if (bytes_.empty() || !trouble_.empty() || Interruption::requested()) return std::nullopt;
        return std::exchange(bytes_, "");
      }
      end = bytes_.find('\n', before);
    }
    if (end - begin_ > kMostLine) {
      refuse_line();
      return std::nullopt;
    }
    std::string line = bytes_.substr(begin_, end - begin_);
    begin_ = end + 1;
    return line;
  }
  /// Whether more is here already.
  bool more_here() const { return begin_ < bytes_.size(); }
  /// Why there is no further one; empty at the end of the input.
  const std::string& trouble() const { return trouble_; }

 private:
  /// With its length, as far as that is worth reading.
  void refuse_line() {
    constexpr std::size_t kMostCounted = std::size_t{64} << 20U;  // [choice]
    std::size_t length = 0;
    std::size_t end = bytes_.find('\n', begin_);
    while (end == std::string::npos && length + bytes_.size() - begin_ < kMostCounted) {
      length += bytes_.size() - std::exchange(begin_, 0);
      bytes_.clear();
      if (!read_more()) break;
      end = bytes_.find('\n');
    }
    length += std::min(end, bytes_.size()) - begin_;
    trouble_ = fmt::format("a line of {}{} bytes; at most {} are read",
                           length < kMostCounted ? "" : "more than ", length, kMostLine);
  }

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

/// Statements and commands from a pipe or a file: no prompt, no colours.
class Filter {
 public:
  Filter(Session& session, const SessionOptions& options)
      : session_(session),
        fast_(options.fast),
        keep_going_(options.keep_going),
        errors_(session.errors()) {}
  ExitCode run();

 private:
  bool goes_on() const { return keep_going_ || session_.errors() == errors_; }
  void take(const std::string& line);
  void end();
  ExitCode exit_code() const;

  Session& session_;
  bool fast_;
  bool keep_going_;
  std::size_t errors_;  ///< before the first line
  InputLines lines_;
  EntryLines entry_;
};

/// To the end of the input, or to its first error.
ExitCode Filter::run() {
  while (goes_on() && !session_.over() && !Interruption::requested()) {
    const auto line = lines_.next();
    if (!line) break;
    take(*line);
  }
  if (goes_on() && !entry_.empty()) enter(session_, entry_.text(), true);
  if (!lines_.trouble().empty()) session_.fail(lines_.trouble(), "", ExitCode::InputOutput);
  end();
  return Interruption::requested() ? Interruption::exit_code() : exit_code();
}

void Filter::take(const std::string& line) {
  if (is_command(line)) {
    enter(session_, line);
  } else {
    entry_.add(line);
    const bool last = entry_.text().size() > kMostLine;
    if (!last && !session_.asks() && entry_.surely_goes_on()) return;
    if (enter(session_, entry_.text(), last) == Session::Taken::Incomplete)
      return entry_.note_open_block();
    entry_.clear();
  }
  if (session_.take_pendant()) session_.fail("the pendant needs a terminal", "", ExitCode::Usage);
  session_.carry_out_entries(fast_ ? 0 : kAhead);
}

void Filter::end() {
  const bool whole = goes_on();
  session_.finish();
  if (!whole && lines_.trouble().empty() && lines_.more_here())
    put_message("what follows in the input is not executed; --keep-going executes it\n");
  if (session_.asks() && !Interruption::requested())
    session_.fail("the input has ended, and nobody answers any more", "", ExitCode::Fault);
  if (session_.robot().held() && !session_.robot().idle())
    session_.fail("the input has ended, and the robot is held", "let :resume or :stop follow",
                  ExitCode::Fault);
}

/// A pipe that ends at its first error is like a program that is wrong.
ExitCode Filter::exit_code() const {
  const ExitCode worst = session_.worst();
  return !keep_going_ && worst == ExitCode::Usage ? ExitCode::ProgramError : worst;
}

ExitCode filter(SessionOptions options) {
  StopRequests requests;
  const Interruption interruption(requests);
  PlainScreen screen;
  options.requests = &requests;
  options.waits = true;
  Session session(options, screen);
  return Filter(session, options).run();
}

}  // namespace

ExitCode run_prompt(SessionOptions options) {
  std::optional<RunMark> running;
  if (!options.fast) {
    for (const std::string& end : unclean_ends()) put_message(end);
    try {
      running.emplace("the prompt", options.robot.empty() ? "gantry" : options.robot);
    } catch (const FileError& error) {
      put_note(fmt::format("warning: {}", error.what()));
    }
  }
  if (!options.trace.empty()) {
    std::vector<InputFile> inputs{{options.points_file, "where the prompt keeps points"}};
    const std::string robot = load_robot(options.robot.empty() ? "gantry" : options.robot).name;
    inputs.push_back(
        {points_at_prompt(options.points_file, robot), "where the prompt keeps points"});
    if (options.robot.ends_with(".toml")) inputs.push_back({options.robot, "the robot file"});
    refuse_overwriting("--trace", options.trace, inputs);
  }
  const bool person = isatty(STDIN_FILENO) != 0 && isatty(STDOUT_FILENO) != 0;
  return person ? talk(std::move(options)) : filter(std::move(options));
}

}  // namespace rob::runtime
