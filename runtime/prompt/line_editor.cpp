#include "runtime/prompt/line_editor.h"

#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdio>  // readline's header needs it

#include <readline/history.h>
#include <readline/readline.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <clocale>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <utility>
#include <vector>

#include "runtime/files/text_lines.h"
#include "runtime/prompt/indentation.h"
#include "runtime/run/console.h"

namespace rob::runtime {

namespace {

constexpr int kMostLines = 1000;  // [choice] of the history: months of work

LineEditor* living = nullptr;                 // readline calls functions without an object
std::vector<std::string>* offered = nullptr;  // what complete() has found
volatile std::sig_atomic_t window_changed = 0;

void note_window(int) { window_changed = 1; }

/// Readline frees what it is given.
char* next_offered(const char*, int number) {
  const auto index = static_cast<std::size_t>(number);
  return index < offered->size() ? strdup((*offered)[index].c_str()) : nullptr;
}

/// Each candidate as readline sees it: from `begin`, where its own word begins.
std::vector<std::string> from(std::size_t begin, std::string_view before,
                              const Completions& found) {
  std::vector<std::string> words;
  for (const std::string& word : found.words) {
    const std::string whole = std::string(before.substr(0, found.begin)) + word;
    if (whole.size() >= begin) words.push_back(whole.substr(begin));
  }
  return words;
}

/// Nothing in readline may wait for a key of its own: the robot goes on.
void set_up_readline() {
  rl_catch_signals = 0;
  rl_catch_sigwinch = 0;
  rl_change_environment = 0;
  rl_completion_query_items = -1;
  rl_variable_bind("page-completions", "off");
  rl_variable_bind("completion-ignore-case", "on");
  rl_variable_bind("show-all-if-ambiguous", "on");
  rl_variable_bind("blink-matching-paren", "on");
  rl_completer_word_break_characters = " \t\n\"(),=:;[]";
  rl_readline_name = "rob";  // for the user's .inputrc
}

/// Within that time, ms.
bool key_waits(int time) {
  pollfd input{STDIN_FILENO, POLLIN, 0};
  return poll(&input, 1, time) > 0 && (input.revents & POLLIN) != 0;
}

constexpr const char* kPasteBegins = "\033[200~";
constexpr std::string_view kPasteEnds = "\033[201~";

/// In place of readline's own, which it has set up by the first line.
void bind(rl_command_func_t* enter, rl_command_func_t* paste) {
  for (const Keymap map : {emacs_standard_keymap, vi_insertion_keymap, vi_movement_keymap}) {
    for (const int key : {'\r', '\n'}) rl_bind_key_in_map(key, enter, map);
    rl_bind_keyseq_in_map(kPasteBegins, paste, map);
  }
}

/// Text that the terminal has marked as pasted; it comes without a pause.
std::string read_paste() {
  std::string text;
  for (int key = rl_read_key(); key >= 0; key = rl_read_key()) {
    text += key == '\r' ? '\n' : static_cast<char>(key);
    if (text.ends_with(kPasteEnds)) return text.substr(0, text.size() - kPasteEnds.size());
  }
  return text;
}

/// Whether a text can be edited on the screen, with some lines to spare.
bool fits(std::string_view text) {
  constexpr std::size_t kSpare = 4;  // [choice]
  int rows = 0;
  int columns = 0;
  rl_get_screen_size(&rows, &columns);
  std::size_t needed = kSpare;
  for (const std::string& line : split_lines(text))
    needed += 1 + line.size() / static_cast<std::size_t>(std::max(columns, 1));
  return needed <= static_cast<std::size_t>(rows);
}

/// A line of the history file is an entry: within it this stands for the end of a line.
constexpr char kLineEnd = '\x1f';

void read_entries(const std::string& file) {
  read_history(file.c_str());
  HIST_ENTRY** const list = history_list();
  for (int i = 0; list != nullptr && list[i] != nullptr; ++i)
    std::replace(list[i]->line, list[i]->line + std::strlen(list[i]->line), kLineEnd, '\n');
}

void append_entry(const std::string& file, std::string entry) {
  std::ranges::replace(entry, '\n', kLineEnd);
  std::ofstream(file, std::ios::app) << entry << '\n';
}

}  // namespace

LineEditor::LineEditor(Completer completer, std::string history)
    : completer_(std::move(completer)), history_(std::move(history)) {
  std::setlocale(LC_CTYPE, "");  // of what is typed
  living = this;
  set_up_readline();
  rl_attempted_completion_function = &LineEditor::complete;
  rl_startup_hook = &LineEditor::put_in;
  // The terminal stays as it is from line to line: what is typed ahead is not echoed twice.
  rl_deprep_term_function = [] {};
  struct sigaction action {};
  action.sa_handler = note_window;
  sigaction(SIGWINCH, &action, nullptr);
  using_history();
  stifle_history(kMostLines);
  if (history_.empty()) return;
  std::error_code error;
  std::filesystem::create_directories(std::filesystem::path(history_).parent_path(), error);
  read_entries(history_);
}

LineEditor::~LineEditor() {
  if (editing_) rl_callback_handler_remove();
  rl_deprep_terminal();
  std::signal(SIGWINCH, SIG_DFL);
  if (!history_.empty()) history_truncate_file(history_.c_str(), kMostLines);
  living = nullptr;
}

void LineEditor::begin(const std::string& prompt, const std::string& indent,
                       const std::string& text) {
  indent_ = indent;
  text_ = indent + text;
  line_.reset();
  editing_ = true;
  hidden_ = false;
  rl_callback_handler_install(prompt.c_str(), &LineEditor::accept);
  bind(&LineEditor::enter, &LineEditor::paste);
}

/// The line is laid out before the cursor leaves it.
int LineEditor::enter(int count, int key) {
  const std::string typed(rl_line_buffer, static_cast<std::size_t>(rl_end));
  const std::string line = !living->pasted_.empty() ? typed : laid_out(typed, living->indent_);
  if (line != typed) {
    rl_replace_line(line.c_str(), 0);
    rl_point = rl_end;
    rl_redisplay();
  }
  return rl_newline(count, key);
}

int LineEditor::put_in() {
  if (!living->text_.empty()) rl_insert_text(living->text_.c_str());
  return 0;
}

int LineEditor::paste(int, int) {
  const std::string text = read_paste();
  if (text.find('\n') == std::string::npos || fits(text)) {
    rl_insert_text(text.c_str());
  } else {
    living->hold(text);
  }
  return 0;
}

/// It is shown once, and does not have to be drawn anew with each key.
void LineEditor::hold(const std::string& text) {
  const std::string line(rl_line_buffer, static_cast<std::size_t>(rl_end));
  const auto point = static_cast<std::size_t>(rl_point);
  std::string whole = line.substr(0, point) + text + line.substr(point);
  if (whole.ends_with('\n')) whole.pop_back();
  rl_clear_visible_line();
  rl_replace_line("", 1);
  put_message(fmt::format("{}\n{} lines are pasted: Enter executes them, Ctrl-C drops them\n",
                          whole, split_lines(whole).size()));
  pasted_ += (pasted_.empty() ? "" : "\n") + whole;
  rl_on_new_line();
  rl_redisplay();
}

void LineEditor::change_prompt(const std::string& prompt) {
  if (!editing_ || RL_ISSTATE(RL_STATE_ISEARCH | RL_STATE_NSEARCH)) return;
  // As a whole: the prompt's length changes, and part of it may take no room.
  if (!hidden_) rl_clear_visible_line();
  rl_set_prompt(prompt.c_str());
  if (hidden_) return;
  rl_on_new_line();
  rl_redisplay();
}

void LineEditor::read() {
  if (editing_ && std::exchange(window_changed, 0) != 0) {
    show();
    rl_resize_terminal();
  }
  while (editing_ && key_waits(0)) {
    show();
    rl_callback_read_char();
  }
}

/// Leaves nothing of readline's behind, so that what is done with the line may fail in any way.
void LineEditor::accept(char* line) {
  rl_callback_handler_remove();
  living->editing_ = false;
  living->followed_ = key_waits(0);
  if (line == nullptr) {
    living->ended_ = true;
    return;
  }
  living->line_ = std::exchange(living->pasted_, "");
  if (!living->line_->empty() && *line != '\0') *living->line_ += '\n';
  *living->line_ += line;
  std::free(line);
}

std::optional<std::string> LineEditor::take_line() { return std::exchange(line_, std::nullopt); }

std::string LineEditor::take_followers() {
  constexpr int kPause = 50;  // ms [choice] between two packets of a paste over a slow line
  std::string text;
  std::array<char, 4096> bytes{};
  while (key_waits(kPause)) {
    const ssize_t count = ::read(STDIN_FILENO, bytes.data(), bytes.size());
    if (count <= 0) break;
    text.append(bytes.data(), static_cast<std::size_t>(count));
  }
  followed_ = false;
  std::ranges::replace(text, '\r', '\n');
  return text;
}

/// At once in the file too: it is there whatever ends the session.
void LineEditor::keep(const std::string& entry) {
  if (entry.find_first_not_of(" \t\n") == std::string::npos) return;
  const HIST_ENTRY* const last = history_get(history_base + history_length - 1);
  if (last != nullptr && entry == last->line) return;
  add_history(entry.c_str());
  if (!history_.empty()) append_entry(history_, entry);
}

void LineEditor::drop() {
  if (!editing_) return;
  show();
  rl_point = rl_end;  // ^C stands after the line
  rl_redisplay();
  rl_callback_sigcleanup();
  rl_free_line_state();
  rl_replace_line("", 1);
  rl_callback_handler_remove();
  editing_ = false;
  pasted_.clear();
  std::fputs("^C\n", rl_outstream);
  std::fflush(rl_outstream);
}

bool LineEditor::empty() const { return rl_end == 0 && pasted_.empty(); }

int LineEditor::columns() {
  winsize size{};
  const bool known = ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return known ? size.ws_col : 80;
}

void LineEditor::hide() {
  if (!editing_ || hidden_) return;
  rl_clear_visible_line();
  std::fflush(rl_outstream);
  hidden_ = true;
}

void LineEditor::show() {
  if (!editing_ || !hidden_) return;
  hidden_ = false;
  rl_on_new_line();
  rl_redisplay();
}

char** LineEditor::complete(const char* word, int begin, int end) {
  rl_attempted_completion_over = 1;  // never readline's own file names
  const std::string_view before(rl_line_buffer, static_cast<std::size_t>(end));
  const Completions found = living->completer_(before);
  std::vector<std::string> words = from(static_cast<std::size_t>(begin), before, found);
  rl_completion_append_character = found.whole ? ' ' : '\0';
  offered = &words;
  char** const matches = rl_completion_matches(word, next_offered);
  offered = nullptr;
  return matches;
}

}  // namespace rob::runtime
