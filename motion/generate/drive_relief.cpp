#include "motion/generate/drive_relief.h"

#include <algorithm>
#include <cmath>

namespace rob::motion {

double DriveRelief::update(double kappa, double rate) noexcept {
  if (!(kappa > 1)) {
    share_ = std::min(1.0, share_ + step_);
  } else if (rate > 0) {
    share_ = std::clamp(rate / std::sqrt(kappa), kLeast, share_);
  }
  return share_;
}

}  // namespace rob::motion
