#include "runtime/prompt/typed_answers.h"

#include <utility>

namespace rob::runtime {

void TypedAnswers::give(const std::string& text) {
  wanted_ = false;
  const std::lock_guard lock(mutex_);
  lines_.push_back(text);
}

void TypedAnswers::listen() {
  const std::lock_guard lock(mutex_);
  lines_.clear();
}

std::optional<std::string> TypedAnswers::line() {
  const std::lock_guard lock(mutex_);
  if (lines_.empty()) return std::nullopt;
  std::string text = std::move(lines_.front());
  lines_.pop_front();
  return text;
}

}  // namespace rob::runtime
