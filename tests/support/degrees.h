#pragma once

#include "base/unit_factors.h"

namespace rob::test {

using rob::kDegree;

}  // namespace rob::test
