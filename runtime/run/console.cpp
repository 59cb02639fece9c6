#include "runtime/run/console.h"

#include <poll.h>
#include <unistd.h>

#include <cstdio>
#include <string>

#include "lang/text/visible.h"

namespace rob::runtime {

namespace {

void write(std::FILE* stream, std::string_view text) {
  std::fwrite(text.data(), 1, text.size(), stream);
}

void show(std::FILE* stream, std::string_view text) {
  if (::isatty(::fileno(stream)) == 0) return write(stream, text);
  write(stream, lang::visible_lines(text));
}

}  // namespace

void put_result(std::string_view text) {
  // A failure sticks to the stream: results_written() asks it.
  show(stdout, text);
  std::fflush(stdout);
}

void put_message(std::string_view text) { show(stderr, text); }

void put_error(std::string_view what) { put_message("rob: " + lang::on_one_line(what) + "\n"); }

void clear_message_line() { write(stderr, "\r\033[K"); }

/// The system reports that of a pipe and a socket without being asked for events.
bool reader_has_gone() {
  pollfd out{STDOUT_FILENO, 0, 0};
  return ::poll(&out, 1, 0) > 0 && (out.revents & (POLLERR | POLLHUP)) != 0;
}

bool results_written() { return std::fflush(stdout) == 0 && std::ferror(stdout) == 0; }

}  // namespace rob::runtime
