#include "runtime/time/wall_time.h"

#include <doctest/doctest.h>

#include <cmath>
#include <ctime>

using namespace rob::runtime;

TEST_CASE("a date is read with its offset, as s since 1970") {
  CHECK(wall_time_of("1970-01-01T00:00:00Z") == WallTime{0, 0});
  CHECK(wall_time_of("2000-01-01T00:00:00+00:00") == WallTime{});
  // date -u -d '2026-03-01T07:30:00Z' +%s
  CHECK(wall_time_of("2026-03-01T08:30:00+01:00") == WallTime{1772350200, 3600});
  CHECK(wall_time_of("2026-03-01T03:00:00-04:30") == WallTime{1772350200, -16200});
  CHECK(wall_time_of("2024-02-29T23:59:59Z") == WallTime{1709251199, 0});
}

TEST_CASE("what is no date is refused") {
  for (const char* text :
       {"", "2026-03-01", "2026-03-01T08:30:00", "2026-02-29T00:00:00Z", "2026-13-01T00:00:00Z",
        "2026-03-01T24:00:00Z", "2026-03-01T08:30:00+1:00", "2026-03-01T08:30:00Z ",
        "2026-03-01 08:30:00Z", "-026-03-01T08:30:00Z", "2026-03-01T08:30:00+24:00"}) {
    CAPTURE(text);
    CHECK_FALSE(wall_time_of(text));
  }
}

TEST_CASE("now is what the computer's clock says") {
  const WallTime now = wall_time_now();
  CHECK(std::abs(now.unix - static_cast<double>(std::time(nullptr))) < 60);
  CHECK(std::abs(now.offset) < 24 * 3600);
}
