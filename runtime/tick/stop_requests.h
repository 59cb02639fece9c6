#pragma once

#include <atomic>

namespace rob::runtime {

/// Asks a robot to come to rest for good. Signal handlers write it, any thread may.
struct StopRequests {
  std::atomic<bool> hold{false};   ///< on its path, within all limits
  std::atomic<bool> brake{false};  ///< as fast as its axes can; then without force
};

}  // namespace rob::runtime
