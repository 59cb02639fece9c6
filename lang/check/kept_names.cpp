#include "lang/check/kept_names.h"

#include <utility>

namespace rob::lang {

const Symbol& KeptNames::declare(const KeptName& kept) {
  Symbol copy = kept.symbol;
  copy.taught = copy.has_taught = nullptr;
  const Symbol& symbol = *scopes_.declare(std::move(copy));
  known_.push_back({&symbol, &kept});
  if (symbol.global) uses_.declared(symbol);
  if (symbol.frame != nullptr) scopes_.frame(symbol, symbol.frame);
  if (symbol.kind == Symbol::Kind::Point && kept.hidden.size() == 2) {
    const Symbol& joints = declare_hidden(kept.hidden[0]);
    scopes_.teach(symbol, joints, declare_hidden(kept.hidden[1]), symbol.moved_to);
  }
  return symbol;
}

const Symbol& KeptNames::declare_hidden(const KeptName& kept) {
  const Symbol& symbol = *scopes_.hide(kept.symbol.type);
  known_.push_back({&symbol, &kept});
  return symbol;
}

}  // namespace rob::lang
