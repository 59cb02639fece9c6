#pragma once

#include <optional>

#include "motion/plan/feasibility.h"
#include "motion/plan/motion_request.h"

namespace rob::motion {

/// Whether the clauses of a request are numbers that mean something.
std::optional<Refusal> check_wishes(const MotionRequest& request) noexcept;

}  // namespace rob::motion
