#include "runtime/run/line_totals.h"

namespace rob::runtime {

namespace {

constexpr std::array<std::string_view, 4> kEnded{"reached", "hit", "brake", "fault"};

}  // namespace

void LineTotals::expect() {
  for (auto& [number, page] : pages_) {
    for (LineTotal& total : page) {
      LineTotal expected;
      expected.planned = total.planned;
      const auto count = std::min<std::uint64_t>(total.count, LineTotal::kManyExpected);
      expected.expected = count & LineTotal::kManyExpected;
      expected.foretold = total.known && expected.expected < LineTotal::kManyExpected;
      total = expected;
    }
  }
  size_ = 0;
}

LineResult LineTotals::Iterator::operator*() const {
  const LineTotal& total = page_->second[static_cast<std::size_t>(at_)];
  LineResult result;
  result.line = page_->first * kPage + at_;
  result.count = static_cast<std::int64_t>(total.count);
  result.starts = total.starts;
  result.planned = total.planned;
  result.foretold = total.foretold;
  result.measured = total.measured;
  result.way = total.way;
  result.decides = total.decides.optional();
  result.miss_planned = total.miss_planned.optional();
  result.miss_measured = total.miss_measured.optional();
  result.exact = total.exact;
  result.ended = kEnded[static_cast<std::size_t>(total.ended)];
  return result;
}

LineResult LineTotals::operator[](std::size_t index) const {
  Iterator at = begin();
  for (; index > 0; --index) ++at;
  return *at;
}

}  // namespace rob::runtime
