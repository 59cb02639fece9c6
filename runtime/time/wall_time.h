#pragma once

#include <optional>
#include <string_view>

namespace rob::runtime {

/// An instant by the calendar, for NOW() and UNIX().
struct WallTime {
  double unix = 946684800;  ///< s since 1970 began in UTC; 2000-01-01 for the virtual clock
  int offset = 0;           ///< s that the local time is ahead of UTC

  bool operator==(const WallTime&) const = default;
};

/// By the computer's clock, in its time zone.
WallTime wall_time_now();

/// ISO 8601 with offset: "2026-03-01T08:30:00+01:00", or Z for +00:00; nothing for any other text.
std::optional<WallTime> wall_time_of(std::string_view text);

}  // namespace rob::runtime
