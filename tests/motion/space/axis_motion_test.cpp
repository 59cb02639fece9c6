#include "motion/space/axis_motion.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <utility>

#include "tests/motion/space/lattice.h"
#include "tests/support/no_allocation.h"
#include "tests/support/relative.h"

namespace rob::motion {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// motion.md: rest to rest over d.
double least_time(double d, const AxisLimits& limits) {
  const auto [v, a, j] = limits;
  if (std::isinf(j)) return d >= v * v / a ? d / v + v / a : 2 * std::sqrt(d / a);
  const double up = v >= a * a / j ? v / a + a / j : 2 * std::sqrt(v / j);
  if (d >= v * up) return d / v + up;
  if (d >= 2 * a * a * a / (j * j)) return a / j + std::sqrt(a / j * a / j + 4 * d / a);
  return std::cbrt(32 * d / j);
}

struct Case {
  AxisState from;
  double target;
  AxisLimits limits;
};

/// Speeds and accelerations up to `beyond` times their limits.
Case random_case(std::mt19937& random, double beyond) {
  std::uniform_real_distribution<double> share(-1, 1);
  const auto magnitude = [&] { return std::pow(10, share(random)); };
  const AxisLimits limits{magnitude(), magnitude(), 10 * magnitude()};
  return {{share(random), beyond * limits.v * share(random), beyond * limits.a * share(random)},
          3 * share(random),
          limits};
}

/// The greatest speed that a start leaves: v_max, or what is left while it is brought back.
double speed_left(const AxisState& from, const AxisLimits& limits, double side, double t) {
  AxisState state{0, side * from.v, side * from.a};
  for (const JerkPhase& phase : speed_change(state, limits.v, limits).phases) {
    if (t < phase.duration) return std::max(limits.v, phase.after(state, t).v);
    state = phase.after(state, phase.duration);
    t -= phase.duration;
  }
  return limits.v;
}

/// At 16 places of a phase that begins at `time`.
bool slow_enough(const AxisState& state, const JerkPhase& phase, const AxisState& from,
                 const AxisLimits& limits, double time) {
  for (int i = 1; i <= 16; ++i) {
    const double t = phase.duration * i / 16;
    const double v = phase.after(state, t).v;
    if (v > speed_left(from, limits, 1, time + t) + 1e-13) return false;
    if (-v > speed_left(from, limits, -1, time + t) + 1e-13) return false;
  }
  return true;
}

/// Limits, and that q and v are the integrals of v and a, at 400 places, and that it stays at rest.
void check_course(const AxisMotion& motion, const Case& c) {
  constexpr int kPlaces = 400;
  const auto& [from, target, limits] = c;
  const double h = motion.duration() / kPlaces;
  AxisState before = motion.at(0);
  REQUIRE(before.q == test::relative(from.q, 1e-12));
  REQUIRE(before.v == test::relative(from.v, 1e-12));
  REQUIRE(before.a == test::relative(from.a, 1e-12));
  for (int i = 1; i <= kPlaces + 4; ++i) {
    const double t = i * h;
    const AxisState now = motion.at(t);
    const double a_left = std::max(limits.a, std::abs(from.a) - limits.j * t);
    REQUIRE(now.v <= speed_left(from, limits, 1, t) + 1e-9 * limits.v);
    REQUIRE(-now.v <= speed_left(from, limits, -1, t) + 1e-9 * limits.v);
    REQUIRE(std::abs(now.a) <= a_left + 1e-9 * limits.a);
    REQUIRE(std::abs(now.a - before.a) <= limits.j * h * (1 + 1e-9) + 1e-9 * limits.a);
    // Where the jerk is constant nothing is left; a change of it in between leaves at most j·h²/4,
    // and of the way less than j·h³/12.
    const double v_left = now.v - before.v - (before.a + now.a) * h / 2;
    REQUIRE(std::abs(v_left) <= limits.j * h * h / 4 * (1 + 1e-9) + 1e-9 * limits.v);
    const double q_left = now.q - before.q - (before.v + now.v) * h / 2;
    REQUIRE(std::abs(q_left - (before.a - now.a) * h * h / 12) <=
            limits.j * h * h * h / 12 + 1e-9 * limits.v * h + 1e-12);
    before = now;
  }
}

/// To the target, or less than rounding beside it: beside the place where a stop at once ends the
/// time grows with the cube root of the distance.
double least_taken(const AxisState& from, double target, const AxisLimits& limits) {
  double least = kInfinity;
  for (const double beside : {-1e-10, -1e-13, 0.0, 1e-13, 1e-10}) {
    const double near = target + beside * (1 + std::abs(target));
    least = std::min(least, AxisMotion(from, near, limits).duration());
  }
  return least;
}

/// Just before its end it is there but for what the last instant changes.
void check_end(const AxisMotion& motion, const Case& c) {
  const double t = motion.duration();
  const AxisState last = motion.at(t * (1 - 1e-14));
  const double scale = std::abs(c.target - c.from.q) + std::abs(c.from.v) * t;
  CHECK(std::abs(last.q - c.target) <= 1e-12 * scale + 1e-15);
  CHECK(std::abs(last.v) <= 1e-12 * c.limits.a * t + 1e-12 * c.limits.v);
  CHECK(motion.at(t).q == c.target);
  CHECK(motion.at(t).v == 0);
  CHECK(motion.at(t).a == 0);
  CHECK(motion.at(2 * t).q == c.target);
}

}  // namespace

TEST_CASE("from rest to rest an axis takes the least time, in every regime") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(-1, 1);
  for (int i = 0; i < 3000; ++i) {
    const double d = std::pow(10, 3 * share(random));
    AxisLimits limits{std::pow(10, 2 * share(random)), std::pow(10, 2 * share(random)),
                      std::pow(10, 3 * share(random))};
    CHECK(AxisMotion({0, 0, 0}, d, limits).duration() ==
          test::relative(least_time(d, limits), 1e-14));
    CHECK(AxisMotion({d, 0, 0}, 0, limits).duration() ==
          test::relative(least_time(d, limits), 1e-14));
    limits.j = kInfinity;
    CHECK(AxisMotion({0, 0, 0}, d, limits).duration() ==
          test::relative(least_time(d, limits), 1e-14));
  }
}

TEST_CASE("1 m at 1 m/s, 2 m/s² and 20 m/s³ takes 1.6 s") {
  // d/v + v/a + a/j = 1 + 0.5 + 0.1; in the middle it has gone half the way at full speed
  const AxisMotion motion({0, 0, 0}, 1, {1, 2, 20});
  CHECK(motion.duration() == test::relative(1.6, 1e-15));
  CHECK(motion.at(0.8).q == test::relative(0.5, 1e-15));
  CHECK(motion.at(0.8).v == test::relative(1, 1e-15));
  CHECK(motion.at(0.1).a == test::relative(2, 1e-14));
}

TEST_CASE("from any state the end is exact and no limit is exceeded but by the start") {
  std::mt19937 random(4);
  for (int i = 0; i < 1500; ++i) {
    const Case c = random_case(random, i % 2 == 0 ? 1 : 2);
    const AxisMotion motion(c.from, c.target, c.limits);
    check_course(motion, c);
    check_end(motion, c);
  }
}

TEST_CASE("a motion takes any longer time, too, within the same limits") {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> share(-1, 1);
  for (int i = 0; i < 1500; ++i) {
    const Case c = random_case(random, i % 2 == 0 ? 1 : 2);
    AxisMotion motion(c.from, c.target, c.limits);
    const double longer = motion.duration() * (1 + std::pow(10, 3 * share(random)));
    motion.stretch(longer);
    REQUIRE(motion.duration() == longer);
    check_course(motion, c);
    check_end(motion, c);
    // It does not arrive before, but where a stop at once ends there.
    CHECK(std::abs(motion.at(0.95 * longer).v) + std::abs(motion.at(0.95 * longer).a) > 0);
  }
}

TEST_CASE("no motion that a search finds is faster, from thousands of states") {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> between(0, 1);
  int compared = 0;
  for (const auto& [n_max, m_max] : {std::pair{2, 12}, {3, 20}, {4, 9}, {5, 60}}) {
    test::Lattice lattice(n_max, m_max);
    const double h = 0.5 + between(random);
    const double j = 0.5 + between(random);
    const AxisLimits limits{m_max * j * h * h / 2, n_max * j * h, j};
    const double unit = j * h * h * h / 6;
    for (int n = -n_max; n <= n_max; ++n) {
      for (int m = -m_max; m <= m_max; ++m) {
        const AxisState from{0, m * j * h * h / 2, n * j * h};
        for (int steps = 1; steps <= 25; ++steps) {
          const int most = lattice.farthest(n, m, steps);
          if (most == test::Lattice::kNone) continue;
          const int least = -lattice.farthest(-n, -m, steps);
          // Both ends, and what lies between: a mixture of the two goes there in the same time.
          for (const double share : {0.0, between(random), 1.0}) {
            const double target = unit * (least + share * (most - least));
            REQUIRE(least_taken(from, target, limits) <= steps * h * (1 + 1e-9));
            ++compared;
          }
        }
      }
    }
  }
  CHECK(compared > 40'000);
}

TEST_CASE("nor where the start is beyond the limits, and the search comes back as fast") {
  using State = std::pair<int, int>;  // n, m
  constexpr int kNMax = 3;
  constexpr int kMMax = 12;
  const AxisLimits limits{kMMax / 2.0, kNMax, 1};  // h = j = 1
  std::mt19937 random(7);
  std::uniform_int_distribution<int> n_range(-5, 5);
  std::uniform_int_distribution<int> m_range(-24, 24);
  int compared = 0;
  for (int start = 0; start < 150; ++start) {
    const int n0 = n_range(random);
    const AxisState from{0, m_range(random) / 2.0, static_cast<double>(n0)};
    std::map<State, int> reached{{{n0, static_cast<int>(2 * from.v)}, 0}};
    for (int steps = 1; steps <= 25; ++steps) {
      std::map<State, int> next;
      for (const auto& [state, k] : reached) {
        for (int u = -1; u <= 1; ++u) {
          const auto [n, m] = std::pair{state.first + u, state.second + 2 * state.first + u};
          if (std::abs(n) > std::max(kNMax, std::abs(n0) - steps)) continue;
          const AxisState last{0, state.second / 2.0, static_cast<double>(state.first)};
          const JerkPhase phase{1, last.a, static_cast<double>(u)};
          if (!slow_enough(last, phase, from, limits, steps - 1)) continue;
          const int way = k + 3 * state.second + 3 * state.first + u;
          const auto at = next.try_emplace({n, m}, way).first;
          at->second = std::max(at->second, way);
        }
      }
      reached = std::move(next);
      const auto rest = reached.find({0, 0});
      if (rest == reached.end()) continue;
      ++compared;
      REQUIRE(least_taken(from, rest->second / 6.0, limits) <= steps * (1 + 1e-9));
    }
  }
  CHECK(compared > 500);
}

TEST_CASE("without a limit of jerk it is bang-bang, from any speed") {
  // v = 1, target behind: to rest 0.25 m in 0.5 s at 2 m/s², then back 1.25 m in 2·√(1.25/2)
  const AxisMotion back({0, 1, 0}, -1, {10, 2, kInfinity});
  CHECK(back.duration() == test::relative(0.5 + 2 * std::sqrt(1.25 / 2), 1e-14));
  CHECK(back.at(0.5).q == test::relative(0.25, 1e-14));
  // 3 m/s where 1 is allowed: 1 s and 2 m to come back, 2.75 m at 1 m/s, 0.25 m to rest
  const AxisMotion fast({0, 3, 0}, 5, {1, 2, kInfinity});
  CHECK(fast.duration() == test::relative(1 + 2.75 + 0.5, 1e-14));
  AxisMotion slow({0, 0, 0}, 1, {1, 2, kInfinity});
  slow.stretch(4);
  CHECK(slow.at(2).q == test::relative(0.5, 1e-14));
  CHECK(slow.at(4 - 1e-9).v < 1e-8);
}

TEST_CASE("a stop is not taken back where it ends at the target but for rounding") {
  const AxisLimits limits{1, 2, 20};
  const AxisMotion stop({0.3, 1, 0}, 0.3 + 0.5 * (0.5 + 0.1), limits);  // v/2·(v/a + a/j)
  CHECK(stop.duration() == test::relative(0.6, 1e-12));
  // From every state of a motion its rest takes the rest of the time.
  const AxisMotion whole({0, -0.4, 1}, 0.7, limits);
  for (double t = 0; t < whole.duration(); t += 0.01) {
    const AxisMotion rest(whole.at(t), 0.7, limits);
    CHECK(std::abs(t + rest.duration() - whole.duration()) < 1e-4);
  }
}

TEST_CASE("the motion of an axis takes no memory") {
  test::NoAllocation guard;
  AxisMotion motion({0, 0.5, 1}, 2, {1, 2, 20});
  motion.stretch(motion.duration() * 1.5);
  const AxisState state = motion.at(0.1);
  CHECK(guard.count() == 0);
  CHECK(state.q > 0);
}

}  // namespace rob::motion
