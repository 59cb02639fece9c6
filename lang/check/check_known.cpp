#include "lang/check/statement_checker.h"
#include "lang/text/ascii.h"

/// The part of StatementChecker that knows what entries of the prompt have declared.
namespace rob::lang {

void StatementChecker::know(const KeptName& kept) {
  Symbol copy = kept.symbol;
  copy.taught = copy.has_taught = nullptr;
  const Symbol& symbol = *scopes_.declare(std::move(copy));
  known_.push_back({&symbol, &kept});
  if (symbol.global) uses_.declared(symbol);
  if (symbol.frame != nullptr) scopes_.frame(symbol, symbol.frame);
  if (kept.safe) safe_lines_.try_emplace(symbol.signal, symbol.place);
  if (symbol.kind != Symbol::Kind::Point) return;
  points_declared_.try_emplace(to_upper(symbol.name), symbol.place);
  if (kept.hidden.size() != 2) return;
  const Symbol* const joints = know_hidden(kept.hidden[0]);
  scopes_.teach(symbol, *joints, *know_hidden(kept.hidden[1]), symbol.moved_to);
}

const Symbol* StatementChecker::know_hidden(const KeptName& kept) {
  const Symbol* const symbol = scopes_.hide(kept.symbol.type);
  known_.push_back({symbol, &kept});
  return symbol;
}

}  // namespace rob::lang
