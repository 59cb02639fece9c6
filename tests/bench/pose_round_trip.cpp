/// forward(inverse(p)) = p over a million poses of each arm, singular and nearly singular ones
/// included (docs/motion.md). An argument is another number of poses.

#include <fmt/format.h>

#include <cstdlib>

#include "tests/motion/kinematics/round_trip.h"

int main(int argc, char** argv) {
  const int poses = argc > 1 ? std::atoi(argv[1]) : 1'000'000;
  fmt::print("{} poses an arm; worst errors over all solutions\n", poses);
  fmt::print(
      "arm         position m  rotation rad  away from singular places  solutions  none  joints "
      "lost\n");
  bool good = true;
  for (const std::string& name : rob::test::arm_names()) {
    const rob::test::RoundTrip trip = rob::test::round_trip(*rob::test::arm(name), poses, 20260101);
    fmt::print("{:<10} {:11.2e} {:13.2e} {:26.2e} {:10} {:5} {:12}\n", name, trip.position,
               trip.rotation, trip.regular_error, trip.solutions, trip.none, trip.lost);
    good = good && trip.position < 1e-9 && trip.rotation < 1e-9 && trip.none == 0 && trip.lost == 0;
  }
  return good ? 0 : 1;
}
