#include "runtime/program/console.h"

#include <poll.h>
#include <unistd.h>

#include <cstdio>

namespace rob::runtime {

void put_result(std::string_view text) {
  // A failure sticks to the stream: results_written() asks it.
  std::fwrite(text.data(), 1, text.size(), stdout);
  std::fflush(stdout);
}

void put_message(std::string_view text) { std::fwrite(text.data(), 1, text.size(), stderr); }

/// The system reports that of a pipe and a socket without being asked for events.
bool reader_has_gone() {
  pollfd out{STDOUT_FILENO, 0, 0};
  return ::poll(&out, 1, 0) > 0 && (out.revents & (POLLERR | POLLHUP)) != 0;
}

bool results_written() { return std::fflush(stdout) == 0 && std::ferror(stdout) == 0; }

}  // namespace rob::runtime
