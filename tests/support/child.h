#pragma once

#include <sys/types.h>

#include <chrono>
#include <optional>

namespace rob::test {

/// How long a program that a test starts may take: [choice] the longest takes 20 s, and a sanitizer
/// on a busy computer makes ten times that of it.
constexpr std::chrono::seconds kLongestRun{300};

/// In a child between fork() and exec(): the kernel kills it when the thread that started it ends,
/// however that ends. So nothing that a test starts outlives the test.
void die_with_parent() noexcept;

/// In a child between fork() and exec(): it leads a process group of its own, which kill_group()
/// kills as a whole.
void lead_group() noexcept;

/// The child's exit code, or 128 + the signal that ended it; nothing if it still runs after
/// `patience`. Throws std::system_error if there is no such child.
std::optional<int> wait_for(pid_t child, std::chrono::milliseconds patience);

/// Kills the group that the child leads, and waits for the child.
void kill_group(pid_t child) noexcept;

}  // namespace rob::test
