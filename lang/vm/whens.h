#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "lang/code/chunk.h"
#include "lang/machine/machine.h"

namespace rob::lang {

/// WHENs that can be armed at once, and are looked at in every cycle. [choice] more than needed.
inline constexpr std::size_t kMostWhens = 16;

/// Why no further one can be armed.
Refusal too_many_whens();

/// A WHEN that is armed.
struct ArmedWhen {
  std::size_t depth = 0;                 ///< calls that were open
  std::uint32_t level = 0;               ///< of its frame
  int id = 0;                            ///< the machine's
  const Chunk* chunk = nullptr;          ///< that the handler is of
  const Instruction* handler = nullptr;  ///< its `when_handle`; null: it has none
  const Slot* captured = nullptr;  ///< in the frame of the WHEN, which lives as long as it is armed
  std::size_t settings = 0;        ///< that were open
};

/// The WHENs that are armed, in the order of arming.
class ArmedWhens {
 public:
  bool full() const { return count_ == kMostWhens; }
  std::size_t count() const { return count_; }
  void arm(const ArmedWhen& when) { armed_[count_++] = when; }
  ArmedWhen& last() { return armed_[count_ - 1]; }
  /// By the number of the machine; it must be armed.
  const ArmedWhen& find(int id) const;
  /// How many were armed before the first of this frame with that level, or of an inner frame.
  std::size_t below(std::size_t depth, std::size_t level) const;
  /// Disarms all beyond the first `kept`.
  Reply disarm(Machine& machine, int line, std::size_t kept);
  /// The machine has disarmed them all.
  void forget() { count_ = kept_ = 0; }

  /// Those that are armed now stay so after their entry of the prompt.
  void keep() { kept_ = count_; }
  std::size_t kept() const { return kept_; }

 private:
  std::array<ArmedWhen, kMostWhens> armed_;
  std::size_t count_ = 0;
  std::size_t kept_ = 0;
};

}  // namespace rob::lang
