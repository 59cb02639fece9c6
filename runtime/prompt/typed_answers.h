#pragma once

#include <atomic>
#include <deque>
#include <mutex>
#include <optional>
#include <string>

#include "runtime/tick/operator_panel.h"

namespace rob::runtime {

/// The answers that somebody at a prompt types while HALT or ASK waits. The prompt's thread gives
/// it, the program's thread takes it.
class TypedAnswers final : public Person {
 public:
  /// HALT or ASK waits: the next line is the answer.
  bool wanted() const { return wanted_; }
  void want(bool on) { wanted_ = on; }
  /// The line after this one is no answer.
  void give(const std::string& text);

  // Person
  bool present() override { return true; }
  void listen() override;
  std::optional<std::string> line() override;

 private:
  std::atomic<bool> wanted_{false};
  std::mutex mutex_;  ///< of lines_
  std::deque<std::string> lines_;
};

}  // namespace rob::runtime
