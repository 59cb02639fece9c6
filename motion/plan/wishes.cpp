#include "motion/plan/wishes.h"

#include <cmath>

namespace rob::motion {

std::optional<Refusal> check_wishes(const MotionRequest& request) noexcept {
  using Kind = Refusal::Kind;
  const bool paced = request.pace != MotionRequest::Pace::Unspecified;
  if (paced && !(std::isfinite(request.pace_value) && request.pace_value > 0))
    return Refusal{Kind::BadPace, -1, request.pace_value, 0};
  if (!(std::isfinite(request.at_least) && request.at_least >= 0))
    return Refusal{Kind::BadDuration, -1, request.at_least, 0};
  const bool zoned = request.zone != MotionRequest::Zone::Unspecified;
  if (zoned && !(std::isfinite(request.zone_value) && request.zone_value > 0))
    return Refusal{Kind::BadZone, -1, request.zone_value, 0};
  if (!(std::isfinite(request.zone_angle) && request.zone_angle >= 0))
    return Refusal{Kind::BadZone, -1, request.zone_angle, 0};
  const auto bad = [](MotionRequest::Bound bound, double value) {
    return bound != MotionRequest::Bound::Unspecified && !(std::isfinite(value) && value > 0);
  };
  if (bad(request.accel, request.accel_value))
    return Refusal{Kind::BadBound, -1, request.accel_value, 0};
  if (bad(request.jerk, request.jerk_value))
    return Refusal{Kind::BadBound, -1, request.jerk_value, 0};
  return std::nullopt;
}

}  // namespace rob::motion
