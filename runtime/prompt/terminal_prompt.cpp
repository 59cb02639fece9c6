#include "runtime/prompt/terminal_prompt.h"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "lang/text/ascii.h"
#include "lang/text/visible.h"
#include "motion/robots/robot_library.h"
#include "runtime/files/state_folder.h"
#include "runtime/files/text_lines.h"
#include "runtime/prompt/commands.h"
#include "runtime/prompt/entry_lines.h"
#include "runtime/prompt/indentation.h"
#include "runtime/prompt/line_editor.h"
#include "runtime/prompt/pendant_terminal.h"
#include "runtime/prompt/terminal_guard.h"
#include "runtime/prompt/wizard_commands.h"
#include "runtime/run/colours.h"
#include "runtime/run/console.h"
#include "runtime/run/interruption.h"
#include "runtime/run/terminal_kind.h"
#include "runtime/words/signature.h"
#include "runtime/words/units.h"

namespace rob::runtime {

namespace {

using SteadyClock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr int kLookMs = 20;          // [choice] two reference periods between looks at the robot
constexpr auto kStateEvery = 200ms;  // [choice] figures that change faster cannot be read
/// Each line of a block is compiled with all before it. [choice] a tenth of a second at most
constexpr std::size_t kMostLookedAt = 500;

/// Output stands above the line that is being typed.
class TerminalScreen final : public Screen {
 public:
  explicit TerminalScreen(LineEditor& editor) : editor_(editor) {}
  void result(std::string_view text) override {
    editor_.hide();
    put_result(text);
  }
  void message(std::string_view text) override {
    editor_.hide();
    put_message(text);
  }

 private:
  LineEditor& editor_;
};

std::string history_file() {
  const std::filesystem::path folder = state_folder();
  return folder.empty() ? "" : (folder / "history").string();
}

/// Those that can be shown as they are: readline writes them to the terminal itself.
std::vector<std::string> files_in(const std::string& folder) {
  std::vector<std::string> names;
  std::error_code error;
  const std::filesystem::path path = folder.empty() ? "." : folder;
  for (const auto& entry : std::filesystem::directory_iterator(path, error)) {
    const std::string name = entry.path().filename().string();
    if (lang::visible(name) != name) continue;
    names.push_back(name + (entry.is_directory(error) ? "/" : ""));
  }
  return names;
}

class TerminalPrompt {
 public:
  explicit TerminalPrompt(SessionOptions options);
  ExitCode run();

 private:
  Vocabulary vocabulary() const;
  std::string state_prompt();
  std::string in_prompt(const std::string& text, Colour colour) const;
  std::string prompt_text();
  void begin_line();
  bool wait() const;
  void take_typed();
  void take_lines(std::string_view rest);
  void drop_paste(std::string_view rest);
  void tell_not_executed(std::string_view rest);
  void show_pendant();
  void take(const std::string& line);
  void drop_entry();
  void look_at_last_lines();
  void show_state();
  void stop_or_drop();
  void suspend();
  void come_to_rest();

  StopRequests requests_;
  Interruption interruption_{requests_, Interruption::CtrlC::IsTold};
  TerminalGuard guard_;
  LineEditor editor_;
  TerminalScreen screen_{editor_};
  bool fast_;
  Session session_;
  bool draws_ = draws(STDOUT_FILENO);
  bool colours_ = shows_colours(STDOUT_FILENO);
  EntryLines entry_;                 ///< lines of a block that is open
  EntryLines sound_;                 ///< those of them in which no mistake was found
  std::size_t width_ = 0;            ///< of the state in the prompt
  std::string prompt_;               ///< as it is shown
  SteadyClock::time_point shown_{};  ///< when
};

SessionOptions with(SessionOptions options, const StopRequests& requests) {
  options.requests = &requests;
  return options;
}

TerminalPrompt::TerminalPrompt(SessionOptions options)
    : editor_([this](std::string_view before) { return complete(before, vocabulary()); },
              history_file()),
      fast_(options.fast),
      session_(with(std::move(options), requests_), screen_) {}

void add_name(const lang::DeclaredName& declared, Vocabulary& known) {
  known.names.push_back(declared.name);
  if (declared.kind == lang::DeclaredName::Kind::Point) known.points.push_back(declared.name);
}

Vocabulary TerminalPrompt::vocabulary() const {
  Vocabulary known;
  for (const lang::DeclaredName& declared : session_.text().names()) add_name(declared, known);
  for (const auto& signal : signature_of(session_.robot().robot()).signals) {
    if (!signal.name.empty()) known.names.push_back(signal.name);
  }
  known.bodies = session_.text().bodies();
  for (const std::string_view name : motion::robot_names()) known.robots.emplace_back(name);
  known.files = files_in;
  return known;
}

/// It never gets narrower under a line that is being typed.
std::string TerminalPrompt::state_prompt() {
  std::string text = session_.state_text();
  constexpr int kLeast = 16;  // characters to type in [choice]
  if (static_cast<int>(text.size()) + kLeast > LineEditor::columns())
    text = text.substr(0, text.rfind(" ("));
  if (!editor_.empty() && text.size() < width_) text.append(width_ - text.size(), ' ');
  width_ = text.size();
  return in_prompt(text, session_.robot().over() ? Colour::Red : Colour::Green) + "> ";
}

/// \001 and \002 enclose for readline what takes no room.
std::string TerminalPrompt::in_prompt(const std::string& text, Colour colour) const {
  const std::string shown = locale_is_utf8() ? text : lang::in_ascii(text);
  return colours_ ? in_colour(shown, colour, "\001", "\002") : shown;
}

std::string TerminalPrompt::prompt_text() {
  if (session_.asks()) return in_prompt("?", Colour::Yellow) + " ";
  return entry_.empty() ? state_prompt() : in_prompt("\u2026", Colour::Green) + " ";
}

void TerminalPrompt::begin_line() {
  width_ = 0;
  prompt_ = prompt_text();
  shown_ = SteadyClock::now();
  editor_.begin(prompt_, entry_.empty() || session_.asks() ? "" : indent_after(entry_.text()),
                session_.take_proposed());
}

/// For a key, but not longer than until the robot may have something to report. False when the
/// terminal has gone.
bool TerminalPrompt::wait() const {
  const bool hurries = fast_ && !session_.robot().idle() && !session_.asks();
  pollfd input{STDIN_FILENO, POLLIN, 0};
  if (poll(&input, 1, hurries ? 0 : kLookMs) <= 0) return true;
  return (input.revents & (POLLHUP | POLLERR | POLLNVAL)) == 0;
}

/// A paste may be several lines.
void TerminalPrompt::take_typed() {
  const auto typed = editor_.take_line();
  if (editor_.ended()) {
    screen_.result("\n");
    session_.quit();
  }
  if (!typed) return;
  take_lines(*typed);
  if (session_.take_pendant()) show_pendant();
  if (!session_.over()) begin_line();
}

/// Up to the first error.
void TerminalPrompt::take_lines(std::string_view rest) {
  const std::size_t errors = session_.errors();
  while (!session_.over()) {
    const std::size_t end = rest.find('\n');
    take(std::string(rest.substr(0, end)));
    const bool last = end == std::string_view::npos;
    rest.remove_prefix(last ? rest.size() : end + 1);
    if (session_.errors() != errors && (!last || editor_.followed())) return drop_paste(rest);
    if (last) return;
  }
}

/// The rest of it, and what comes with it.
void TerminalPrompt::drop_paste(std::string_view rest) {
  std::string left = entry_.empty() ? "" : entry_.text() + "\n";
  left += rest;
  if (editor_.followed()) left += editor_.take_followers();
  drop_entry();
  tell_not_executed(left);
}

/// So many that the error stays in sight above them.
void TerminalPrompt::tell_not_executed(std::string_view rest) {
  if (rest.find_first_not_of(" \t\r\n") == std::string_view::npos) return;
  const std::vector<std::string> lines = split_lines(rest);
  constexpr std::size_t kMost = 10;  // [choice]
  screen_.message("not executed, of what was pasted:\n");
  for (std::size_t i = 0; i < std::min(lines.size(), kMost); ++i)
    screen_.message(fmt::format("  {}\n", lines[i]));
  if (lines.size() > kMost)
    screen_.message(fmt::format("  and {} lines more\n", lines.size() - kMost));
}

void TerminalPrompt::show_pendant() {
  if (draws_) return run_pendant(session_);
  session_.fail("the pendant needs a terminal that can move its cursor; TERM says there is none");
}

void TerminalPrompt::take(const std::string& line) {
  if (session_.asks() || is_command(line)) {
    editor_.keep(line);
    enter(session_, line);
    return;
  }
  entry_.add(line);
  if (entry_.brackets_open()) return;
  if (!entry_.surely_goes_on()) {
    if (enter(session_, entry_.text()) == Session::Taken::Done) return drop_entry();
    entry_.note_open_block();
  }
  look_at_last_lines();
}

/// The history has it as a whole.
void TerminalPrompt::drop_entry() {
  editor_.keep(entry_.text());
  entry_.clear();
  sound_.clear();
}

/// A mistake is reported at once, and only the lines with it have to be typed again.
void TerminalPrompt::look_at_last_lines() {
  const std::size_t before = sound_.size();
  if (entry_.size() > kMostLookedAt || session_.sound_so_far(entry_.text(), before)) {
    sound_ = entry_;
    return;
  }
  std::string_view last = entry_.text();
  for (std::size_t i = 0; i < before; ++i) take_line(last);
  editor_.keep(std::string(last));
  entry_ = sound_;
}

void TerminalPrompt::show_state() {
  if (!draws_ || SteadyClock::now() - shown_ < kStateEvery) return;
  shown_ = SteadyClock::now();
  std::string now = prompt_text();
  if (now == prompt_) return;
  prompt_ = std::move(now);
  editor_.change_prompt(prompt_);
}

/// Ctrl-C: the robot first, then the line and the block that it belongs to.
void TerminalPrompt::stop_or_drop() {
  if (session_.interrupt_again() || session_.interrupt()) return;
  const bool asked = editor_.empty() && entry_.empty() && command::leave_wizard(session_);
  const bool nothing = !asked && editor_.empty() && entry_.empty();
  editor_.drop();
  drop_entry();
  if (nothing) screen_.message("nothing moves; Ctrl-D or :quit leaves\n");
  begin_line();
}

/// Ctrl-Z
void TerminalPrompt::suspend() {
  const LiveRobot& robot = session_.robot();
  if (!robot.simulated())
    return screen_.message("Ctrl-Z does nothing: nobody would look after the robot\n");
  if (!robot.idle())
    return screen_.message("Ctrl-Z does nothing while the robot is under way; :stop it first\n");
  editor_.hide();
  TerminalGuard::suspend();
  editor_.show();
}

void TerminalPrompt::come_to_rest() {
  const bool moves = session_.robot().reports().moves();
  if (!session_.interrupt()) return;
  if (moves) screen_.message("the robot comes to rest first\n");
  session_.finish();
}

ExitCode TerminalPrompt::run() {
  screen_.message(
      "Statements act at once. :help lists the commands, Ctrl-C stops, Ctrl-D leaves.\n");
  while (!session_.robot().reports().last() && !session_.robot().over()) {  // a cycle or two
    session_.let_pass();
    std::this_thread::sleep_for(1ms);
  }
  begin_line();
  while (!session_.over()) {
    if (Interruption::requested()) break;
    if (Interruption::ctrl_c_pressed()) stop_or_drop();
    if (TerminalGuard::take_suspension()) suspend();
    if (!wait()) {
      requests_.hold = true;
      return Interruption::requested() ? Interruption::exit_code() : ExitCode::HungUp;
    }
    editor_.read();
    session_.let_pass();
    take_typed();
    show_state();
    editor_.show();
  }
  if (!Interruption::requested()) come_to_rest();
  if (!Interruption::requested()) return ExitCode::Done;
  screen_.message("the robot stops on its path\n");
  return Interruption::exit_code();
}

}  // namespace

ExitCode talk(SessionOptions options) { return TerminalPrompt(std::move(options)).run(); }

}  // namespace rob::runtime
