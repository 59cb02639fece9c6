#pragma once

#include <string>

namespace rob::runtime {

/// SCHED_FIFO priorities: the generator stands above the servo, so that a busy servo never
/// starves it (S1).
inline constexpr int kMotionPriority = 80;
inline constexpr int kServoPriority = 70;
inline constexpr int kPathPriority = 40;

/// Tries once for the process what the system permits for running in real time: locked memory and
/// fixed priorities. Returns an empty text if all is permitted, else one line for the user that
/// says what is not and how to permit it.
std::string prepare_real_time();

/// Gives the calling thread its priority where that is permitted and touches its stack, so that no
/// page must be fetched later.
void enter_real_time(int priority) noexcept;

}  // namespace rob::runtime
