#pragma once

#include <atomic>

namespace rob::runtime {

/// A person at a prompt drives the axes back on the way that they have come: where they stand on
/// their path by a hold, or where nothing is commanded.
struct WayBack {
  std::atomic<bool> asked{false};       ///< main → motion: by one motion; once each
  std::atomic<bool> under_way{false};   ///< set by who asks for it, or to go on from there, until
                                        ///< the axes stand again
  std::atomic<bool> hold_asked{false};  ///< main → motion: stand there; once each
  std::atomic<bool> away{false};        ///< motion → main: elsewhere than where the path was left
  /// motion → program: nothing was commanded, and the axes stand elsewhere now; taken once.
  std::atomic<bool> moved{false};
};

}  // namespace rob::runtime
