#include "lang/vm/errors.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "lang/text/codes.h"

namespace rob::lang {

void TryBlocks::drop(std::size_t kept) {
  blocks_.erase(blocks_.begin() + static_cast<std::ptrdiff_t>(kept), blocks_.end());
}

void TryBlocks::fail(RuntimeError error) {
  error_ = std::move(error);
  rescuing_ = catches(0);
}

void TryBlocks::fail_again() {
  fail(std::find_if(blocks_.rbegin(), blocks_.rend(), [](const TryBlock& block) {
         return block.caught;
       })->error);
}

bool TryBlocks::catches(std::size_t first) const {
  return std::any_of(blocks_.begin() + static_cast<std::ptrdiff_t>(first), blocks_.end(),
                     [](const TryBlock& block) { return !block.caught; });
}

const TryBlock& TryBlocks::rescuer() {
  while (blocks_.back().caught) blocks_.pop_back();
  return blocks_.back();
}

void TryBlocks::rescue() {
  TryBlock& block = blocks_.back();
  block.caught = true;
  block.error = error_;
  rescuing_ = false;
}

std::string TryBlocks::reason() const {
  if (error_.code == code::kRaised) return error_.message;
  return fmt::format("{}: {}", error_.code, error_.message);
}

Refusal tries_too_deep() {
  return {.code = std::string(code::kTriesTooDeep),
          .message = fmt::format("the TRY blocks are nested too deep: at most {}", kMostTries),
          .help = "a routine that calls itself needs a way that does not"};
}

Refusal text_too_long() {
  return {.code = std::string(code::kTextTooLong),
          .message = fmt::format("a text of more than {} bytes", kMostText),
          .help = ""};
}

Refusal refusal_of(ArithmeticError error) {
  const ArithmeticErrorText text = describe(error);
  return {.code = std::string(text.code),
          .message = std::string(text.message),
          .help = std::string(text.help)};
}

}  // namespace rob::lang
