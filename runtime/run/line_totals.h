#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string_view>

namespace rob::runtime {

/// One source line's share of a run. Times in s, misses in mm. `line` is a lang::line_tag().
struct LineResult {
  int line = 0;
  std::int64_t count = 0;  ///< how often it ran
  double starts = 0;       ///< when it ran first
  double planned = 0;      ///< how long it takes, the sum over all times
  bool foretold = true;    ///< `planned` is known
  double measured = 0;
  double way = 0;                 ///< of the tool's reference in it, mm, the sum over all times
  std::optional<double> decides;  ///< when what follows must be known, the first time
  std::optional<double> miss_planned;  ///< the greatest of all times; none for a STOP
  std::optional<double> miss_measured;
  bool exact = false;  ///< its last motion was made exact by a STOP or the end
  std::string_view ended = "reached";
};

/// A number that may be missing, in half the memory of a std::optional.
class MaybeReal {
 public:
  MaybeReal& operator=(double value) {
    value_ = value;
    return *this;
  }
  bool has_value() const { return !std::isnan(value_); }
  double& operator*() { return value_; }
  void reset() { *this = MaybeReal{}; }
  void raise_to(double value) { value_ = has_value() ? std::max(value_, value) : value; }
  std::optional<double> optional() const {
    return has_value() ? std::optional(value_) : std::nullopt;
  }

 private:
  double value_ = std::numeric_limits<double>::quiet_NaN();
};

/// A LineResult as it is kept: a program may have a million lines.
struct LineTotal {
  enum class Ended : std::uint8_t { Reached, Hit, Brake, Fault };

  double starts = 0;
  double planned = 0;
  double measured = 0;
  double way = 0;
  MaybeReal decides;
  MaybeReal miss_planned;
  MaybeReal miss_measured;
  std::uint64_t count : 36 = 0;     ///< at 1 kHz enough for two years
  std::uint64_t expected : 22 = 0;  ///< how often it was foretold to run; see kManyExpected
  bool known : 1 = false;           ///< the line is one of the run
  bool foretold : 1 = true;
  bool exact : 1 = false;
  Ended ended : 2 = Ended::Reached;

  /// `expected` goes no further: an hour's runs at 1 kHz are fewer.
  static constexpr std::uint64_t kManyExpected = (1U << 22U) - 1;
};
static_assert(sizeof(LineTotal) == 64);

/// The totals of all lines of a run, by their tags. They are kept in pages of neighbouring lines.
class LineTotals {
 public:
  /// The total of a line, which is one of the run from here on.
  LineTotal& of(int tag) {
    LineTotal& total = pages_[tag / kPage][static_cast<std::size_t>(tag % kPage)];
    if (!total.known) ++size_;
    total.known = true;
    return total;
  }
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }

  /// change(total) for each line, in the order of their tags.
  template <typename Change>
  void change(Change&& change) {
    for (auto& [number, page] : pages_)
      for (LineTotal& total : page)
        if (total.known) change(total);
  }
  /// The planned values of each line stay, as foretold for a run that comes later; no line is one
  /// of that run yet.
  void expect();

 private:
  static constexpr int kPage = 64;  // [choice] 4 KB
  using Page = std::array<LineTotal, kPage>;
  using Pages = std::map<int, Page>;

 public:
  /// Over the lines in the order of their tags.
  class Iterator {
   public:
    Iterator(Pages::const_iterator page, Pages::const_iterator end) : page_(page), end_(end) {
      skip_unknown();
    }
    LineResult operator*() const;
    Iterator& operator++() {
      ++at_;
      skip_unknown();
      return *this;
    }
    bool operator==(const Iterator& other) const {
      return page_ == other.page_ && at_ == other.at_;
    }

   private:
    void skip_unknown() {
      for (; page_ != end_; ++page_, at_ = 0)
        for (; at_ < kPage; ++at_)
          if (page_->second[static_cast<std::size_t>(at_)].known) return;
    }

    Pages::const_iterator page_;
    Pages::const_iterator end_;
    int at_ = 0;
  };
  Iterator begin() const { return {pages_.begin(), pages_.end()}; }
  Iterator end() const { return {pages_.end(), pages_.end()}; }
  /// The line that is `index`-th in their order, from 0.
  LineResult operator[](std::size_t index) const;

 private:
  Pages pages_;
  std::size_t size_ = 0;
};

}  // namespace rob::runtime
