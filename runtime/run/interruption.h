#pragma once

#include <cstdint>

#include "runtime/run/run_result.h"
#include "runtime/tick/stop_requests.h"

namespace rob::runtime {

/// Every signal of the system that would end the process, except crashes and SIGKILL, is taken as a
/// request while an object of this class lives: Ctrl-C, SIGTERM, SIGHUP, SIGQUIT and the others.
/// The robot stops on its path first, and the process ends afterwards.
///
/// The handler itself writes `requests`: the robot stops even while the thread that reports waits
/// for somebody to read what it wrote. A second Ctrl-C asks for the hardest brake.
///
/// Objects may be nested; the innermost one's requests are written. An inner one begins with what
/// has been requested before.
class Interruption {
 public:
  enum class CtrlC : std::uint8_t {
    Ends,   ///< as the others do
    IsTold  ///< by ctrl_c_pressed(), as Ctrl-\ is, and changes nothing else
  };
  explicit Interruption(StopRequests& requests, CtrlC ctrl_c = CtrlC::Ends);
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  /// Since the outermost living object was made, or the last of the former ones.
  static bool requested();
  /// Since the last call.
  static bool ctrl_c_pressed();
  /// For the first request: 128 + the number of its signal, such as 130, 143, 129 or 131.
  static ExitCode exit_code();

 private:
  StopRequests* outer_;
  bool outer_tells_;
};

}  // namespace rob::runtime
