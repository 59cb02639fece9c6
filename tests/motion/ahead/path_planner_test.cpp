#include <doctest/doctest.h>

#include <numbers>

#include "tests/motion/ahead/ahead_run.h"

using rob::test::AheadRun;

// Times: "best known" of the published comparison of look-ahead planners (docs/motion.md), or a
// formula. Every axis has 1 m/s², 1 m/s.

namespace {

/// At F m/s within P m; jerk: 2·A/window.
struct PacedRun : AheadRun {
  PacedRun(double speed, double miss, double window = 0) {
    bounds.speed = speed;
    bounds.miss = miss;
    bounds.window = window;
  }
};

void check_limits(const AheadRun& run) {
  for (int i = 0; i < 2; ++i) CHECK(run.peak_acceleration(i) <= 1.0001);
  const double window = run.bounds.window;
  if (window == 0) return;
  for (int i = 0; i < 2; ++i) CHECK(run.peak_jerk(i) <= 1.01 * 2 / window);
}

/// `chords` of a circle of 50 mm, from its leftmost point; written to `digit` mm.
void circle(AheadRun& run, int chords, double digit) {
  for (int i = 1; i <= chords; ++i) {
    const double angle = i * 2 * std::numbers::pi / chords;
    run.line(digit * std::round((50 - 50 * std::cos(angle)) / digit),
             digit * std::round(50 * std::sin(angle) / digit));
  }
  run.close();
}

}  // namespace

/// Of a corner's zone of 0.1 mm passed at 17 mm/s: the nearest reference is 8.5 µm beside its
/// middle at most.
constexpr double kNearest = 1.004;

TEST_CASE("a line from rest to rest takes d/v + v/a + a/j") {
  for (const double window : {0.0, 0.02, 0.1}) {
    PacedRun run(0.3, 0.001, window);
    run.line(200, 0);
    run.close();
    CHECK(run.run() == doctest::Approx(0.2 / 0.3 + 0.3 + window / 2).epsilon(0.0021));
    CHECK(run.references().back().q[0] == doctest::Approx(0.2).epsilon(1e-14));
    check_limits(run);
  }
}

TEST_CASE("a line that is too short for its speed takes 2·sqrt(d/a)") {
  PacedRun run(1, 0.001);
  run.line(160, 0);
  run.close();
  CHECK(run.run() == doctest::Approx(2 * std::sqrt(0.16)).epsilon(0.002));
}

TEST_CASE("a triangle is passed within its zone, as fast as is known to be possible") {
  struct Case {
    double speed, miss, window, best;
  };
  // With jerk: the figures that the mean was designed for.
  for (const Case& c :
       {Case{0.1, 1e-4, 0, 3.252}, Case{0.3, 1e-4, 0, 1.808}, Case{0.3, 1e-3, 0, 1.782},
        Case{0.1, 1e-4, 0.02, 3.273}, Case{0.3, 1e-4, 0.02, 1.828}}) {
    PacedRun run(c.speed, c.miss, c.window);
    run.from(40, 40);
    run.line(140, 40);
    run.line(90, 126);
    run.line(40, 40);
    run.close();
    CHECK(run.run() <= 1.005 * c.best);
    check_limits(run);
    CHECK(run.miss(140, 40) <= kNearest * c.miss);
    CHECK(run.miss(90, 126) <= kNearest * c.miss);
    CHECK(run.miss(90, 126) >= 0.7 * c.miss);  // what the zone admits is used
  }
}

TEST_CASE("where a long mean would leave the zone, what is around a corner calms down or stops") {
  constexpr double kZone = 1e-4;
  constexpr double kPieces = 200;  // of a leg: the axes calm down pieces before the corner
  for (const double window : {0.03, 0.04, 0.05, 0.0667, 0.1, 0.2, 0.6}) {
    for (const bool in_pieces : {false, true}) {
      PacedRun run(0.3, kZone, window);
      const auto leg = [&](double x0, double y0, double x1, double y1) {
        for (double k = in_pieces ? 1 : kPieces; k <= kPieces; ++k)
          run.line(x0 + (x1 - x0) * k / kPieces, y0 + (y1 - y0) * k / kPieces);
      };
      leg(0, 0, 60, 0);
      leg(60, 0, 30, 40);
      leg(30, 40, 90, 60);
      run.close();
      const double time = run.run();
      check_limits(run);
      CHECK(run.miss(60, 0) <= kNearest * kZone);
      CHECK(run.miss(30, 40) <= kNearest * kZone);
      // With stops: from rest to rest as fast as |q'|·σ'' <= 1 m/s² admits, and 2A/J thrice, which
      // the mean takes where what follows cannot be foreseen.
      double stops = 0;
      for (const auto& [x, y] : {std::pair{60., 0.}, std::pair{-30., 40.}, std::pair{60., 20.}}) {
        const double way = std::hypot(x, y) / 1000;
        const double most = way / std::max(std::abs(x), std::abs(y)) * 1000;
        stops += way >= 0.09 / most ? way / 0.3 + 0.3 / most : 2 * std::sqrt(way / most);
        stops += window;
      }
      CHECK(time <= stops + 3 * 0.003);  // periods that are begun
    }
  }
}

TEST_CASE("what a corner may yet calm is not given away while the path becomes known bit by bit") {
  // Legs of 60 mm in pieces of 3 mm. The program is ahead by 25 mm, the mean reaches 15 mm.
  constexpr double kZone = 1e-4;
  constexpr double kPiece = 3;  // mm
  for (const double window : {0.02, 0.03, 0.04, 0.05, 0.0667, 0.1}) {
    CAPTURE(window);
    PacedRun run(0.3, kZone, window);
    int given = 0;
    const auto give = [&](int pieces) {
      for (; given < std::min(pieces, 40); ++given) {
        const double way = kPiece * (given + 1);
        way <= 60 ? run.line(way, 0) : run.line(60 - 0.6 * (way - 60), 0.8 * (way - 60));
      }
      if (given == 40) run.close();
    };
    while (!run.ended() || given < 40) {
      give(static_cast<int>((run.guide().sigma() * 1000 + 25) / kPiece));
      run.step();
    }
    check_limits(run);
    CHECK(run.miss(60, 0) <= kNearest * kZone);
  }
}

TEST_CASE("a line whose pieces become known bit by bit is as fast as a known one") {
  // The program is ahead by more than the guide needs to brake, v²/2a = 45 mm, and what a corner
  // may calm, T/2·(v + a·T/4) <= 16.3 mm: from rest to rest it takes d/v + v/a + T.
  constexpr double kAhead = 65;  // mm
  for (const double window : {0.0, 0.02, 0.05, 0.1}) {
    for (const double piece : {0.5, 3.0, 30.0}) {
      CAPTURE(window);
      CAPTURE(piece);
      PacedRun run(0.3, 1e-4, window);
      const int pieces = static_cast<int>(std::lround(300 / piece));
      int given = 0;
      int periods = 0;
      for (; periods < 4000 && (given < pieces || !run.ended()); ++periods) {
        const double known = run.guide().sigma() * 1000 + kAhead + 2 * piece;
        while (given < pieces && piece * given < known) run.line(piece * ++given, 0);
        if (given == pieces) run.close();
        run.step();
      }
      CHECK(run.ring().late == 0);
      CHECK(periods * 0.001 == doctest::Approx(0.3 / 0.3 + 0.3 + window).epsilon(0.003));
      check_limits(run);
    }
  }
}

TEST_CASE("however many corners ask for calm, the axes keep the least share of them") {
  // Corners of 90 degrees every 0.02 mm, many within the same mean.
  PacedRun run(0.3, 1e-4, 0.05);
  constexpr int kCorners = 300;
  for (int k = 0; k < kCorners; ++k) run.line(0.02 * (k / 2 + 1), 0.02 * ((k + 1) / 2));
  run.close();
  // A stop at each end of a leg, and the mean each time, would take five times as long and more.
  CHECK(run.run() < kCorners * (2 * std::sqrt(2e-5) + 0.05) / 5);
  check_limits(run);
}

TEST_CASE("a dense circle shares its zone between the curve and the mean, with few digits, too") {
  // r = 50 mm, zone 0.1 mm. One half of it is for the curve through the chords, the other for the
  // mean. With a share s of the accelerations and of the mean's W, all accelerations of two axes,
  // up to √2·s at 1 m/s², move the mean by no more than that at s³ = 12·zone/(√2·W²); those of the
  // circle itself at v = √(12·r·zone)/(s·W). The axes admit v = √(s·r). Beside that the circle
  // takes v/s to speed up and slow down, and the mean once.
  struct Case {
    int chords = 0;
    double digit = 0;  // mm
  };
  constexpr double kRadius = 0.05;
  constexpr double kZone = 1e-4;
  constexpr double kSpeed = 0.1;
  for (const double window : {0.02, 0.1, 0.2, 0.4, 2.0}) {
    for (const Case& c : {Case{1000, 1e-6}, Case{4000, 0.01}, Case{2000, 0.01}}) {
      CAPTURE(window);
      CAPTURE(c.chords);
      PacedRun run(kSpeed, kZone, window);
      circle(run, c.chords, c.digit);
      const double share =
          std::min(1.0, std::cbrt(12 * kZone / (std::numbers::sqrt2 * window * window)));
      const double mean = share * window;
      const double fastest =
          std::min({kSpeed, std::sqrt(12 * kRadius * kZone) / mean, std::sqrt(share * kRadius)});
      const double time = 2 * std::numbers::pi * kRadius / fastest + fastest / share + mean;
      CHECK(run.run() == doctest::Approx(time).epsilon(0.02));
      check_limits(run);
      double deepest = 0;
      for (const auto& point : run.references())
        deepest =
            std::max(deepest, std::abs(kRadius - std::hypot(point.q[0] - kRadius, point.q[1])));
      CHECK(deepest <= kZone);
    }
  }
}

TEST_CASE("a leg between two stops has the accelerations that are the best for its length") {
  // With 1 m/s³: by a third-order profile that is too short for any bound but jerk, ∛(32·d/J).
  constexpr double kJerk = 1;
  constexpr double kWindow = 2;  // of 1 m/s²
  for (const double way : {0.001, 0.02}) {
    PacedRun run(1, 1e-4, kWindow);
    run.from_rest = true;
    for (const double end : {way, 0.0, way}) run.line(1000 * end, 0);
    run.close();
    CHECK(run.run() == doctest::Approx(3 * std::cbrt(32 * way / kJerk)).epsilon(0.01));
    check_limits(run);
  }
}

TEST_CASE("a circle of a thousand chords is one path") {
  for (const double window : {0.0, 0.02}) {
    PacedRun run(0.3, 1e-4, window);
    circle(run, 1000, 1e-6);
    CHECK(run.run() <= (window == 0 ? 1.01 * 1.598 : 1.63));
    check_limits(run);
    double deepest = 0;
    for (const auto& point : run.references())
      deepest = std::max(deepest, 0.05 - std::hypot(point.q[0] - 0.05, point.q[1]));
    CHECK(deepest <= 1.01e-4);
  }
}

TEST_CASE("many short pieces of a line are as fast as the line") {
  PacedRun run(0.3, 1e-4);
  for (int i = 1; i <= 2000; ++i) run.line(i * 0.05, 0);
  run.close();
  CHECK(run.run() == doctest::Approx(0.1 / 0.3 + 0.3).epsilon(0.003));
}

TEST_CASE("a reversal stops at its point or short of it, within the zone") {
  PacedRun run(0.3, 1e-4);
  run.line(100, 0);
  run.line(0, 0);
  run.close();
  CHECK(run.run() <= 1.002 * 2 * (0.1 / 0.3 + 0.3));
  CHECK(run.miss(100, 0) <= 1.0001e-4);
  check_limits(run);
}

TEST_CASE("legs straight on have no corner, points that are one no way") {
  PacedRun run(0.3, 1e-4);
  run.line(50, 0);
  run.line(50, 0);
  run.line(100, 0);
  run.line(100, 0);
  run.close();
  CHECK(run.run() == doctest::Approx(0.1 / 0.3 + 0.3).epsilon(0.003));
}

TEST_CASE("a point that two motions name is passed within both of their zones") {
  for (const double second : {5e-4, 5e-3}) {
    PacedRun run(0.3, 2e-3);
    run.line(100, 0);
    run.bounds.miss = second;
    run.line(100, 0);
    run.line(100, 100);
    run.close();
    CHECK(run.run() > 0);
    const double zone = std::min(2e-3, second);
    CHECK(run.miss(100, 0) <= 1.001 * zone);
    CHECK(run.miss(100, 0) >= 0.9 * zone);
  }
}

TEST_CASE("without a zone a point is met exactly") {
  PacedRun run(0.3, 0);
  run.line(100, 0);
  run.line(100, 100);
  run.close();
  CHECK(run.run() == doctest::Approx(2 * (0.1 / 0.3 + 0.3)).epsilon(0.003));
  CHECK(run.miss(100, 0) < 1e-12);
}

TEST_CASE("a turning axis is rounded within its own zone") {
  PacedRun run(0.3, 1);
  run.bounds.turn = 0.01;
  run.line(100, 0, 0.5);
  run.line(200, 0, 0);
  run.close();
  CHECK(run.run() > 0);
  double most = 0;
  for (const auto& point : run.references()) most = std::max(most, point.q[2]);
  CHECK(most >= 0.48999);
  CHECK(run.peak_acceleration(2) <= 10.001);
}

TEST_CASE("a corner may take more than half of a leg that has no other") {
  // With 1 m/s² of each axis 0.3 m/s need a parabola of v²/2a on each side, which passes the point
  // at √2/4 of that.
  constexpr double kHalf = 0.045;
  PacedRun run(0.3, 1);
  run.bounds.lead = 1;
  run.line(100, 0);
  run.line(100, 60);
  run.close();
  CHECK(run.run() > 0);
  check_limits(run);
  CHECK(run.miss(100, 0) / kHalf == doctest::Approx(std::numbers::sqrt2 / 4).epsilon(0.001));
}

TEST_CASE("work() does all that can be done at once") {
  // Targets without a way are more than the ring of legs has room for; nothing follows in time.
  const auto is_all_done = [](AheadRun& run) {
    run.planner().work();
    const auto end = run.ring().end();
    const std::size_t legs = run.ring().leg_room();
    run.planner().work();
    return run.ring().end() == end && run.ring().leg_room() == legs;
  };
  constexpr std::size_t kLegs = 8;
  for (const int more : {0, 40}) {
    CAPTURE(more);
    AheadRun run(rob::test::fast_table(), kLegs);
    run.bounds.speed = 0.3;
    run.bounds.miss = 1e-3;
    run.line(100, 0);
    int given = 0;
    int failed = 0;
    for (int k = 0; k < 2000; ++k) {
      if (given < more && run.buffer().room() > 1) run.line(100, 0), ++given;
      if (!is_all_done(run)) ++failed;
      run.tick();
    }
    CHECK(failed == 0);
    CHECK(given == more);
    CHECK(run.guide().sigma() == doctest::Approx(0.1));
  }
}

TEST_CASE("before the first tick nothing is decided for want of time") {
  PacedRun run(0.3, 1e-3);
  for (int i = 1; i <= 3; ++i) {
    run.line(100 * i, 0);
    for (int k = 0; k < 3; ++k) run.planner().work();
  }
  run.close();
  CHECK(run.run() == doctest::Approx(0.3 / 0.3 + 0.3).epsilon(0.002));
  CHECK(run.ring().late == 0);
}

TEST_CASE("what nothing follows in time is led to its target as soon as it is counted") {
  PacedRun run(0.3, 1e-3);
  run.line(100, 0);
  while (run.ring().late == 0) {
    run.planner().work();
    if (run.ring().late == 0) run.tick();
  }
  REQUIRE(run.ring().end() > 0);
  CHECK(run.ring().run_end(run.ring().end() - 1));
  const rob::motion::Piece& last = run.ring().written(run.ring().end() - 1);
  CHECK(last.begin + last.length == doctest::Approx(0.1).epsilon(1e-12));
}

TEST_CASE("what nothing follows in time is led to its target, and counted") {
  PacedRun run(0.3, 1e-3);
  run.line(100, 0);
  for (int i = 0; i < 2000; ++i) run.step();
  CHECK(run.ring().late == 1);
  CHECK(run.references().back().q[0] == doctest::Approx(0.1).epsilon(1e-12));
  check_limits(run);
}
