// The words for where a path is slow.
#include <doctest/doctest.h>

#include "runtime/run/slow_places.h"

TEST_CASE("every singular place that slows a path has its words") {
  using rob::motion::SingularPlace;
  rob::runtime::SlowPlace place;
  place.axis = "wrist2";
  const auto words = [&](SingularPlace near) {
    place.near = near;
    return rob::runtime::cause_of(place);
  };
  CHECK(words(SingularPlace::None) == "axis wrist2 speed");
  CHECK(words(SingularPlace::Wrist) == "axis wrist2 speed near the wrist singularity");
  CHECK(words(SingularPlace::Shoulder) == "axis wrist2 speed near the shoulder singularity");
  CHECK(words(SingularPlace::Elbow) == "axis wrist2 speed with the arm nearly stretched or folded");
  CHECK(words(SingularPlace::Chain) == "axis wrist2 speed near a singular posture");
}
