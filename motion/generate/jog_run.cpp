#include "motion/generate/jog_run.h"

#include <cstdint>
#include <utility>

#include "motion/generate/limit_numbers.h"

namespace rob::motion {

namespace {

std::uint8_t number_of(const JogLimit& limit) noexcept {
  using namespace limit_number;
  switch (limit.kind) {
    case JogLimit::Kind::None:
      return kNone;
    case JogLimit::Kind::Share:
      return kPace;
    case JogLimit::Kind::Speed:
      return of_axis(kSpeed, limit.axis);
    case JogLimit::Kind::Acceleration:
      return of_axis(kAcceleration, limit.axis);
    case JogLimit::Kind::Reach:
      return kReach;
    case JogLimit::Kind::Body:
      return kBody;
    case JogLimit::Kind::End:
      break;
  }
  return of_axis(kEndOfAxis, limit.axis);
}

}  // namespace

void JogRun::begin(const JogRates& rates, const JointVector& from) noexcept {
  mode_.stand_at(from);
  join(rates);
}

void JogRun::join(const JogRates& rates) noexcept {
  mode_.aim(rates);
  lasts_ = rates.lasts;
  done_ = 0;
  stopped_ = false;
}

/// One without a time is over, too, where it can go no further: else it would never end.
bool JogRun::step(double share) noexcept {
  mode_.step(share);
  done_ += period_ * share;
  const bool before = std::exchange(stopped_, mode_.stopped());
  if (stopped_ && mode_.stands() && lasts_ == JogRates::kAny) done_ = JogRates::kAny;
  return stopped_ && !before;
}

int JogRun::axis_at_end() const noexcept {
  return mode_.limit().kind == JogLimit::Kind::End ? mode_.limit().axis : -1;
}

void JogRun::sample(double share, bool slowed, GeneratorSample& sample) const noexcept {
  const double time = sample.reference.time;
  sample.reference = mode_.reference();
  sample.reference.time = time;
  sample.sigma = done_;
  sample.rate = mode_.granted() * share;
  sample.limit = number_of(mode_.limit());
  if (sample.limit == 0 && slowed) sample.limit = limit_number::kOverride;
}

}  // namespace rob::motion
