#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <iterator>
#include <utility>
#include <vector>

namespace rob::runtime {

/// The first and the last kEach of any number of things, and how many there were: a report shows
/// these of a run that may go on for days.
template <typename T>
class KeptEnds {
 public:
  static constexpr std::size_t kEach = 5000;

  void push_back(T one) {
    ++count_;
    if (first_.size() < kEach) {
      first_.push_back(std::move(one));
      return;
    }
    if (last_.size() == kEach) last_.pop_front();
    last_.push_back(std::move(one));
  }
  std::int64_t count() const { return count_; }
  /// The one that came as number `index`, from 0; null if it is no longer kept.
  T* find(std::int64_t index) {
    const auto at = static_cast<std::size_t>(index);
    if (at < first_.size()) return &first_[at];
    const std::size_t left_out = static_cast<std::size_t>(count_) - first_.size() - last_.size();
    if (at < first_.size() + left_out || index >= count_) return nullptr;
    return &last_[at - first_.size() - left_out];
  }
  /// All that are kept, in their order.
  std::vector<T> take() {
    std::vector<T> all = std::move(first_);
    all.insert(all.end(), std::make_move_iterator(last_.begin()),
               std::make_move_iterator(last_.end()));
    return all;
  }

 private:
  std::vector<T> first_;
  std::deque<T> last_;
  std::int64_t count_ = 0;
};

}  // namespace rob::runtime
