#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <string_view>

namespace rob::runtime {

/// Cuts what a device sends into lines, and keeps those that wait. All sizes are bounded, whatever
/// it sends.
class DeviceLines {
 public:
  explicit DeviceLines(std::string ending) : ending_(std::move(ending)) {}

  static constexpr std::size_t kLongest = 4096;  ///< bytes of a line; a longer one is dropped
  static constexpr std::size_t kMostWaiting =
      65536;  ///< bytes; beyond, the oldest lines are dropped

  /// Bytes as they come. Those that are not UTF-8 become U+FFFD.
  void add(std::string_view bytes);
  /// No more comes of the line that has begun: its connection is lost.
  void break_off();
  std::optional<std::string> take();
  /// Drops the lines that wait.
  void clear();
  /// How many were dropped since the last time: they were too long, or too many.
  std::size_t take_dropped();

 private:
  void end_line();
  void keep(std::string line);

  std::string ending_;
  std::string begun_;      ///< the line that has no end yet
  bool too_long_ = false;  ///< it is dropped
  std::deque<std::string> lines_;
  std::size_t waiting_ = 0;  ///< bytes of them
  std::size_t dropped_ = 0;
};

}  // namespace rob::runtime
