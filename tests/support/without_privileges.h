#pragma once

#include <linux/capability.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <exception>

namespace rob::test {

/// In a child process: gives up the capabilities by which root ignores the permissions of files.
/// Anybody else has none. Returns false if the kernel refuses.
inline bool give_up_capabilities() noexcept {
  __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
  const __user_cap_data_struct none[_LINUX_CAPABILITY_U32S_3] = {};
  return ::syscall(SYS_capset, &header, none) == 0;
}

/// Whether `call()` returns true in a child process that the permissions of files bind, even if
/// root runs the tests. An exception, or a death by a signal, counts as false.
template <typename Call>
bool true_without_privileges(Call&& call) {
  const pid_t child = ::fork();
  if (child == 0) {
    bool holds = false;
    try {
      holds = give_up_capabilities() && call();
    } catch (const std::exception&) {
      holds = false;
    }
    ::_exit(holds ? 0 : 1);
  }
  int status = 0;
  return child > 0 && ::waitpid(child, &status, 0) == child && WIFEXITED(status) &&
         WEXITSTATUS(status) == 0;
}

}  // namespace rob::test
