#include "motion/generate/drive_relief.h"

#include <doctest/doctest.h>

#include <cmath>

#include "tests/support/no_allocation.h"
#include "tests/support/relative.h"

namespace rob::motion {
namespace {

constexpr double kReliefPeriod = 0.010;

}  // namespace

TEST_CASE("drives that suffice slow nothing down") {
  DriveRelief relief(kReliefPeriod);
  for (const double kappa : {0.0, 0.5, 1.0}) CHECK(relief.update(kappa, 1) == 1);
  CHECK(relief.update(std::nan(""), 1) == 1);
}

TEST_CASE("four times what drives have is half the rate, however far the rate has come by then") {
  DriveRelief relief(kReliefPeriod);
  // Forces go with the square of the rate: κ = 4·r².
  for (const double rate : {1.0, 0.9, 0.75, 0.6})
    CHECK(relief.update(4 * rate * rate, rate) == test::relative(0.5));
}

TEST_CASE("what is asked for by an override counts, not the programmed rate") {
  DriveRelief relief(kReliefPeriod);
  CHECK(relief.update(1.44, 0.6) == test::relative(0.5));
}

TEST_CASE("the rate recovers within half a second") {
  DriveRelief relief(kReliefPeriod);
  relief.update(4, 1);
  // From 0.5 in 0.25 s, 25 periods.
  for (int k = 0; k < 24; ++k) CHECK(relief.update(0.9, 0.5) < 1);
  CHECK(relief.update(0.9, 0.5) == test::relative(1));
}

TEST_CASE("no demand stops the path by itself, nor does one at rest") {
  DriveRelief relief(kReliefPeriod);
  CHECK(relief.update(5, 0) == 1);
  CHECK(relief.update(1e6, 1) == DriveRelief::kLeast);
  // It does not rise while too much is asked for.
  CHECK(relief.update(1.01, 1) == DriveRelief::kLeast);
}

TEST_CASE("the relief of drives takes no memory") {
  DriveRelief relief(kReliefPeriod);
  test::NoAllocation guard;
  relief.update(2, 1);
  CHECK(guard.count() == 0);
}

}  // namespace rob::motion
