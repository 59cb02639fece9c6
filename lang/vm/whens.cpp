#include "lang/vm/whens.h"

#include <algorithm>

#include <fmt/core.h>

#include "lang/text/codes.h"

namespace rob::lang {

const ArmedWhen& ArmedWhens::find(int id) const {
  return *std::ranges::find(armed_, id, &ArmedWhen::id);
}

std::size_t ArmedWhens::below(std::size_t depth, std::size_t level) const {
  std::size_t below = 0;
  while (below < count_ && (armed_[below].depth < depth ||
                            (armed_[below].depth == depth && armed_[below].level < level))) {
    ++below;
  }
  return below;
}

Reply ArmedWhens::disarm(Machine& machine, int line, std::size_t kept) {
  while (count_ > kept) {
    const Reply reply = machine.disarm(line, last().id);
    if (reply != Reply::Done) return reply;
    --count_;
  }
  return Reply::Done;
}

Refusal too_many_whens() {
  return {.code = std::string(code::kTooManyWhens),
          .message = fmt::format("more than {} WHENs are armed at once", kMostWhens),
          .help = "a WHEN is armed until its block ends; is this routine calling itself?"};
}

}  // namespace rob::lang
