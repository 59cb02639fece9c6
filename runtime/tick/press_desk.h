#pragma once

#include <atomic>
#include <cstdint>

#include "motion/force/press.h"

namespace rob::runtime {

/// A PRESS of the program, between it and motion. It begins and ends while the axes stand on their
/// path.
struct PressDesk {
  enum class State : std::uint8_t {
    Off,
    Seeking,  ///< on the way to the force
    Keeping,  ///< it has been reached
    Lost,     ///< it goes no further: nothing was met, or what was pressed on is gone
    AtEnd     ///< the same, since an axis or the arm ends there
  };

  motion::PressOrder order;              ///< the program's, before `asked`
  std::atomic<bool> asked{false};        ///< program → motion; once each
  std::atomic<bool> over{false};         ///< program → motion: it shall end, until it has
  std::atomic<State> state{State::Off};  ///< motion → program
};

}  // namespace rob::runtime
