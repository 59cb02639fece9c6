#include "runtime/time/wall_time.h"

#include <array>
#include <charconv>
#include <chrono>
#include <cstddef>
#include <ctime>

namespace rob::runtime {
namespace {

/// Reads a text of fixed columns from its beginning on.
class Columns {
 public:
  explicit Columns(std::string_view text) : text_(text) {}

  bool sign(char wanted) {
    if (!text_.starts_with(wanted)) return false;
    text_.remove_prefix(1);
    return true;
  }
  /// Exactly so many digits.
  bool number(std::size_t digits, int& value) {
    if (text_.size() < digits) return false;
    const char* const end = text_.data() + digits;
    const auto [stop, error] = std::from_chars(text_.data(), end, value);
    if (error != std::errc{} || stop != end || value < 0 || text_.front() == '-') return false;
    text_.remove_prefix(digits);
    return true;
  }
  bool empty() const { return text_.empty(); }

 private:
  std::string_view text_;
};

/// "+01:00" or "Z".
std::optional<int> offset_of(Columns& columns) {
  if (columns.sign('Z')) return 0;
  const bool behind = columns.sign('-');
  int hours = 0;
  int minutes = 0;
  if (!behind && !columns.sign('+')) return std::nullopt;
  if (!columns.number(2, hours) || !columns.sign(':') || !columns.number(2, minutes) ||
      hours > 23 || minutes > 59) {
    return std::nullopt;
  }
  const int offset = (hours * 60 + minutes) * 60;
  return behind ? -offset : offset;
}

}  // namespace

WallTime wall_time_now() {
  const auto now = std::chrono::system_clock::now();
  const std::time_t seconds = std::chrono::system_clock::to_time_t(now);
  std::tm local{};
  localtime_r(&seconds, &local);
  return {std::chrono::duration<double>(now.time_since_epoch()).count(),
          static_cast<int>(local.tm_gmtoff)};
}

std::optional<WallTime> wall_time_of(std::string_view text) {
  using namespace std::chrono;
  Columns columns(text);
  int year = 0;
  int month = 0;
  int day = 0;
  std::array<int, 3> clock{};
  const bool read = columns.number(4, year) && columns.sign('-') && columns.number(2, month) &&
                    columns.sign('-') && columns.number(2, day) && columns.sign('T') &&
                    columns.number(2, clock[0]) && columns.sign(':') &&
                    columns.number(2, clock[1]) && columns.sign(':') && columns.number(2, clock[2]);
  if (!read) return std::nullopt;
  const auto offset = offset_of(columns);
  const year_month_day date{std::chrono::year(year),
                            std::chrono::month(static_cast<unsigned>(month)),
                            std::chrono::day(static_cast<unsigned>(day))};
  if (!offset || !columns.empty() || !date.ok() || clock[0] > 23 || clock[1] > 59 ||
      clock[2] > 59) {
    return std::nullopt;
  }
  const auto seconds_of_day = hours(clock[0]) + minutes(clock[1]) + seconds(clock[2]);
  const auto local = sys_days(date).time_since_epoch() + seconds_of_day;
  return WallTime{static_cast<double>(duration_cast<seconds>(local).count() - *offset), *offset};
}

}  // namespace rob::runtime
