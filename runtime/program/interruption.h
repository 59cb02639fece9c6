#pragma once

#include <atomic>
#include <cstdint>

#include "runtime/program/run_result.h"

namespace rob::runtime {

/// Ctrl-C, SIGTERM and SIGHUP, taken as requests while an object of this class lives: the run
/// stops on its path first and the process ends afterwards. One object at a time.
///
/// The handler itself sets `hold`: the robot stops even while the thread that reports waits for
/// somebody to read what it wrote.
class Interruption {
 public:
  enum class CtrlC : std::uint8_t {
    Ends,   ///< as the others do
    IsTold  ///< by ctrl_c_pressed(), and changes nothing else
  };
  explicit Interruption(std::atomic<bool>& hold, CtrlC ctrl_c = CtrlC::Ends);
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  /// Since the object was made.
  static bool requested();
  /// Since the last call.
  static bool ctrl_c_pressed();
  /// Of the first request: 130, 143 or 129.
  static ExitCode exit_code();
};

}  // namespace rob::runtime
