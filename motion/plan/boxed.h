#pragma once

#include <memory>
#include <utility>

namespace rob::motion {

/// A value that few motions have. Copies share it, so that a motion without one takes the room of a
/// pointer. It is never changed, only replaced: threads may read it at once. Only replacing it
/// takes memory; a copy in the tick is free of that as long as it is not the last one: who sends
/// motions keeps one (SentBoxes).
template <typename T>
class Boxed {
 public:
  Boxed() noexcept = default;
  Boxed(const T& value) : value_(std::make_shared<const T>(value)) {}

  /// Without a value as T is made.
  const T& operator*() const noexcept { return value_ ? *value_ : none(); }
  const T* operator->() const noexcept { return &**this; }
  void clear() noexcept { value_.reset(); }
  /// Null: no value.
  std::shared_ptr<const void> box() const noexcept { return value_; }

 private:
  static const T& none() noexcept {
    static const T value{};
    return value;
  }

  std::shared_ptr<const T> value_;
};

}  // namespace rob::motion
