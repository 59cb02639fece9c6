#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "drivers/link/wire_link.h"
#include "drivers/protocol/grbl_line.h"

namespace rob::drivers {

/// References as the lines that grbl carries out in the same time:  G91 G21 G93 G1 X… F(60/s).
/// Targets are whole steps, so that what is rounded once is made up by the next move. At the
/// beginning of a motion kAhead moves are collected: so many are always ahead in grbl's planner,
/// which else would brake at the end of each. Character counting: what is not acknowledged never is
/// more than grbl's buffer holds.
class GrblStream {
 public:
  /// [choice] 80 ms of 20 ms moves: a computer that is late by less is not noticed.
  static constexpr int kAhead = 4;
  static constexpr int kBuffer = 127;  ///< bytes, of 128

  /// `steps`: per mm, of each axis; `letters`: X = 0; `speeds`: mm/s that no move exceeds, to make
  /// up for references that were missing either (empty: any).
  void begin(const std::vector<int>& letters, const std::vector<double>& steps, double period,
             const std::vector<double>& speeds = {});
  /// Stands there, mm; nothing is under way.
  void stand_at(const WireVector& position) noexcept;

  /// The next reference.
  void push(const WireCommand& command);
  /// Forgets the lines that have not been sent; stand_at() has to follow.
  void drop_waiting() noexcept { lines_.clear(); }
  /// The end of what waits, though no more has come.
  void flush() noexcept { collecting_ = false; }
  /// Nothing was told to it for a while, and all lines are acknowledged.
  bool standing() const noexcept {
    return idle_ >= kAhead && lines_.empty() && unacknowledged_ == 0;
  }

  /// The next line, with its end, as far as grbl's buffer has room; empty: none.
  std::string next_line(double now);
  /// A line waits, and grbl's buffer has no room for it.
  bool full() const noexcept;
  /// False: all lines had been acknowledged before.
  bool acknowledged() noexcept;
  /// Lines that were sent and not acknowledged; since when there has been one without a break: an
  /// acknowledgement that is lost is never made good by those of the lines behind.
  int open_lines() const noexcept { return static_cast<int>(sent_.size()); }
  double open_since() const noexcept { return open_since_; }
  /// s from a reference to its execution.
  double lag() const noexcept { return kAhead * period_; }

 private:
  using Steps = std::array<std::int64_t, motion::kMaxJoints>;

  std::string line_of(const Steps& way, double seconds) const;
  double least_time(const Steps& way) const noexcept;

  std::vector<int> letters_;
  std::vector<double> steps_;
  std::vector<double> speeds_;
  double period_ = 0.02;
  Steps queued_{};
  double last_ = 0;     ///< time of the last reference
  double pending_ = 0;  ///< s since the last move
  int idle_ = kAhead;   ///< references in a row without a step
  bool collecting_ = true;
  std::deque<std::string> lines_;
  std::deque<int> sent_;    ///< bytes of each line
  int unacknowledged_ = 0;  ///< bytes
  double open_since_ = 0;
};

}  // namespace rob::drivers
