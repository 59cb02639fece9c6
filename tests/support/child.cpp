#include "tests/support/child.h"

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <system_error>
#include <thread>

namespace rob::test {

void die_with_parent() noexcept { ::prctl(PR_SET_PDEATHSIG, SIGKILL); }

void lead_group() noexcept { ::setpgid(0, 0); }

std::optional<int> wait_for(pid_t child, std::chrono::milliseconds patience) {
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::milliseconds kNap{1};
  const Clock::time_point until = Clock::now() + patience;
  for (;;) {
    int status = 0;
    const pid_t ended = ::waitpid(child, &status, WNOHANG);
    if (ended == child) {
      return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    }
    if (ended < 0 && errno != EINTR) {
      throw std::system_error(errno, std::generic_category(), "waitpid");
    }
    if (Clock::now() >= until) return std::nullopt;
    std::this_thread::sleep_for(kNap);
  }
}

void kill_group(pid_t child) noexcept {
  ::kill(-child, SIGKILL);
  ::kill(child, SIGKILL);  // it may not lead its group yet
  while (::waitpid(child, nullptr, 0) < 0 && errno == EINTR) continue;
}

}  // namespace rob::test
