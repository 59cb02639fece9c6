#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "drivers/link/wire_link.h"
#include "drivers/protocol/grbl_line.h"

namespace rob::drivers {

/// Turns references into moves of the same duration:  G91 G21 G93 G1 X… F(60/s).  Targets are whole
/// steps, and the next move makes up for the rounding of the last. At the beginning of a motion the
/// stream collects kAhead moves and keeps that many in grbl's planner, which would otherwise brake
/// at the end of each. It counts characters: unacknowledged lines never exceed grbl's buffer.
class GrblStream {
 public:
  static constexpr double kPeriod = 0.02;  ///< s a move: 50 Hz, of which 115200 baud bears twice
  /// [choice] 80 ms in moves of 20 ms: a computer that is late by less does no harm.
  static constexpr int kAhead = 4;
  static constexpr int kBuffer = 127;  ///< bytes, of 128

  /// `steps`: per mm, of each axis; `letters`: X = 0; `speeds`: the limits of each axis, mm/s,
  /// which hold for moves that make up for missing references, too (empty: none).
  void begin(const std::vector<int>& letters, const std::vector<double>& steps, double period,
             const std::vector<double>& speeds = {});
  /// Takes over the position, mm, at which grbl stands without moves.
  void stand_at(const WireVector& position) noexcept;

  /// The next reference.
  void push(const WireCommand& command);
  /// Forgets the lines that have not been sent. The caller must call stand_at() next.
  void drop_waiting() noexcept { lines_.clear(); }
  /// Stops collecting: sends the moves it has, although no more have come.
  void flush() noexcept { collecting_ = false; }
  /// The last kAhead references contained no step, and grbl has acknowledged all lines.
  bool standing() const noexcept {
    return idle_ >= kAhead && lines_.empty() && unacknowledged_ == 0;
  }

  /// The next line, with its end, as far as grbl's buffer has room; empty: none.
  std::string next_line(double now);
  /// A line waits, and grbl's buffer has no room for it.
  bool full() const noexcept;
  /// False: all lines had been acknowledged before.
  bool acknowledged() noexcept;
  /// Lines that grbl has not acknowledged, and since when there has always been one. After a lost
  /// acknowledgement there always is: those of later lines do not make up for it.
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
