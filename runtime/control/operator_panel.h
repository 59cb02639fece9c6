#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

#include "motion/space/spsc_ring.h"

namespace rob::runtime {

/// What a signal script or SIMULATE does in the operator's place: lets a HALT go on (GO), answers
/// an ASK (ANSWER). Each GO is for one HALT and each ANSWER for one ASK, the one that waits or the
/// next. Motion gives them, the program takes them; go() and answer() may be used in the tick.
class OperatorPanel {
 public:
  /// The texts of the script's ANSWERs; before the run only.
  void prepare(std::vector<std::string> answers, bool gives_go) {
    texts_ = std::move(answers);
    gives_go_ = gives_go;
  }

  void go() noexcept { given_.fetch_add(1, std::memory_order_release); }
  /// What finds the ring full is lost: nobody asks so many questions ahead.
  void answer(std::uint32_t text) noexcept { answers_.push(text); }

  /// Whether anybody but a person at the terminal will ever act.
  bool gives_go() const noexcept { return gives_go_; }
  bool gives_answers() const noexcept { return !texts_.empty(); }
  /// True once for each GO.
  bool take_go() noexcept {
    if (given_.load(std::memory_order_acquire) == taken_) return false;
    ++taken_;
    return true;
  }
  /// The next ANSWER; null if none has been given.
  const std::string* take_answer() noexcept {
    std::uint32_t text = 0;
    return answers_.take(text) ? &texts_[text] : nullptr;
  }

 private:
  std::vector<std::string> texts_;
  bool gives_go_ = false;
  std::atomic<std::int64_t> given_{0};
  std::int64_t taken_ = 0;
  motion::SpscRing<std::uint32_t> answers_{64};  // [choice] see answer()
};

}  // namespace rob::runtime
