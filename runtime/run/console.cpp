#include "runtime/run/console.h"

#include <poll.h>
#include <unistd.h>

#include <cstdio>
#include <string>

#include "lang/text/visible.h"
#include "runtime/run/colours.h"
#include "runtime/run/terminal_kind.h"

namespace rob::runtime {

namespace {

void write(std::FILE* stream, std::string_view text) {
  std::fwrite(text.data(), 1, text.size(), stream);
}

std::string on_terminal(std::string_view text) {
  const std::string visible = lang::visible_lines(text);
  return locale_is_utf8() ? visible : lang::in_ascii(visible);
}

bool is_terminal(std::FILE* stream) { return ::isatty(::fileno(stream)) != 0; }

}  // namespace

void put_result(std::string_view text) {
  // A failure sticks to the stream: results_written() asks it.
  write(stdout, is_terminal(stdout) ? on_terminal(text) : std::string(text));
  std::fflush(stdout);
}

void put_message(std::string_view text) {
  if (!is_terminal(stderr)) return write(stderr, text);
  const std::string shown = on_terminal(text);
  write(stderr, shows_colours(STDERR_FILENO) ? coloured(shown) : shown);
}

void put_error(std::string_view what) {
  const std::string line = lang::on_one_line(what) + "\n";
  write(stderr, shows_colours(STDERR_FILENO) ? in_colour("rob:", Colour::Red) : "rob:");
  put_message(" " + line);
}

void put_note(std::string_view what) { put_message("rob: " + lang::on_one_line(what) + "\n"); }

void clear_message_line() {
  if (draws(STDERR_FILENO)) write(stderr, "\r\033[K");
}

/// The system reports that of a pipe and a socket without being asked for events.
bool reader_has_gone() {
  pollfd out{STDOUT_FILENO, 0, 0};
  return ::poll(&out, 1, 0) > 0 && (out.revents & (POLLERR | POLLHUP)) != 0;
}

bool results_written() { return std::fflush(stdout) == 0 && std::ferror(stdout) == 0; }

}  // namespace rob::runtime
