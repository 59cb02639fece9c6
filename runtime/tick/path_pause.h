#pragma once

#include <atomic>
#include <cstdint>

namespace rob::runtime {

/// Whether the robot is to stand on its path until somebody lets it go on. At a prompt the operator
/// says so, and motion itself where it holds at a line or a script holds it; what was said last
/// counts. Each side writes a number of its own: twice a count, and one more where the robot is to
/// stand. The operator's counts what was asked for; motion's says how much of that it knows.
class PathPause {
 public:
  // The operator's side, of one thread.
  void ask(bool on) noexcept {
    asked_.store(said(turn_of(asked_.load(std::memory_order_relaxed)) + 1, on),
                 std::memory_order_relaxed);
  }
  /// The last word, even if the tick has not seen it.
  bool on() const noexcept {
    const std::uint32_t asked = asked_.load(std::memory_order_relaxed);
    const std::uint32_t known = known_.load(std::memory_order_relaxed);
    return stands(turn_of(known) == turn_of(asked) ? known : asked);
  }

  // The tick.
  void set(bool on) noexcept {
    known_.store(said(turn_of(asked_.load(std::memory_order_relaxed)), on),
                 std::memory_order_relaxed);
  }
  /// Takes what has been asked for since; returns what holds now.
  bool update() noexcept {
    const std::uint32_t asked = asked_.load(std::memory_order_relaxed);
    const std::uint32_t known = known_.load(std::memory_order_relaxed);
    if (turn_of(known) == turn_of(asked)) return stands(known);
    known_.store(asked, std::memory_order_relaxed);
    return stands(asked);
  }

 private:
  static std::uint32_t said(std::uint32_t turn, bool on) noexcept {
    return 2 * turn + (on ? 1U : 0U);
  }
  static std::uint32_t turn_of(std::uint32_t said) noexcept { return said / 2; }
  static bool stands(std::uint32_t said) noexcept { return said % 2 != 0; }

  std::atomic<std::uint32_t> asked_{0};  ///< operator → motion
  std::atomic<std::uint32_t> known_{0};  ///< motion → operator
};

}  // namespace rob::runtime
