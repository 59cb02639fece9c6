#pragma once

#include <atomic>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "motion/space/spsc_ring.h"

namespace rob::runtime {

/// A person who can be asked. All calls come from the program's thread.
class Person {
 public:
  virtual ~Person() = default;
  /// False once nobody can answer any more.
  virtual bool present() = 0;
  /// A HALT or an ASK begins: what was typed before is no answer to it.
  virtual void listen() = 0;
  /// The next line, without its end; none while there is none yet. May wait for it where no time
  /// passes meanwhile.
  virtual std::optional<std::string> line() = 0;
};

/// Who lets a HALT go on (GO) and answers an ASK (ANSWER): a signal script or SIMULATE in the
/// operator's place, or a person. Each GO is for one HALT and each ANSWER for one ASK, the one that
/// waits or the next. A person is asked only where nobody else will act any more. Motion gives
/// them, the program takes them; go() and answer() may be used in
/// the tick, all else belongs to the program's thread.
class OperatorPanel {
 public:
  /// The answers that will still be given by themselves.
  struct Promise {
    std::int64_t times = 0;
    bool whenever = false;  ///< and again whenever some condition comes true
  };

  /// Before the run: the texts of the script's ANSWERs, and what it promises.
  void prepare(const std::vector<std::string>& answers, Promise go, Promise answer) {
    texts_.assign(answers.begin(), answers.end());
    go_promise_ = go;
    answer_promise_ = answer;
  }
  /// Before the run: a person who outlives it; null for none.
  void seat(Person* person) { person_ = person; }
  Person* person() const { return person_; }

  void go() noexcept { given_.fetch_add(1, std::memory_order_release); }
  /// A GO that has ended a hold: no HALT gets it.
  void spend_go() noexcept { spent_.fetch_add(1, std::memory_order_release); }
  /// A question that finds the ring full is lost: nobody asks so many questions ahead.
  void answer(std::uint32_t text) noexcept {
    answers_.push(text);
    answered_.fetch_add(1, std::memory_order_release);
  }

  /// SIMULATE will give one in its time.
  void promise_go() { ++go_promise_.times; }
  /// Its text's number, for answer().
  std::uint32_t promise_answer(std::string text) {
    ++answer_promise_.times;
    texts_.push_back(std::move(text));
    return static_cast<std::uint32_t>(texts_.size()) - 1;
  }

  /// Whether anybody but a person will still act.
  bool go_may_come() const noexcept {
    return open(go_promise_,
                given_.load(std::memory_order_acquire) + spent_.load(std::memory_order_acquire));
  }
  bool answer_may_come() const noexcept {
    return open(answer_promise_, answered_.load(std::memory_order_acquire));
  }
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
  static bool open(const Promise& promise, std::int64_t given) noexcept {
    return promise.whenever || promise.times > given;
  }

  std::deque<std::string> texts_;
  Promise go_promise_;
  Promise answer_promise_;
  Person* person_ = nullptr;
  std::atomic<std::int64_t> given_{0};
  std::atomic<std::int64_t> spent_{0};
  std::int64_t taken_ = 0;
  std::atomic<std::int64_t> answered_{0};
  motion::SpscRing<std::uint32_t> answers_{64};  // [choice] see answer()
};

}  // namespace rob::runtime
