#include "tests/support/paul_model.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstddef>
#include <utility>

#include "tests/support/gantry.h"
#include "tests/support/published_program.h"

using namespace rob::test;

namespace {

PaulStep move(int line, AxisValues target, double t_user = 0) {
  return {.line = line, .stop = false, .target = std::move(target), .t_user = t_user};
}
PaulStep stop(int line) { return {.line = line, .stop = true, .target = {}, .t_user = 0}; }

}  // namespace

TEST_CASE("the published gantry program has five segments and lasts 19.10 s") {
  const PaulModel model = published_program();
  const double starts[] = {0, 2.75, 7.75, 12.05, 16.35};  // S1's segment times, added by hand
  REQUIRE(model.segments().size() == 5);
  for (std::size_t i = 0; i < 5; ++i)
    CHECK(model.segments()[i].start == doctest::Approx(starts[i]));
  CHECK(model.total() == doctest::Approx(19.10).epsilon(1e-12));
}

TEST_CASE("the corners of the published program are missed by 4.0, 9.6 and 10.3 mm") {
  const PaulModel model = published_program();
  CHECK(std::abs(model.corner_miss(0) - 4.0) < 0.05);
  CHECK(std::abs(model.corner_miss(1) - 9.6) < 0.05);
  CHECK(std::abs(model.corner_miss(2) - 10.3) < 0.05);
  CHECK(model.corner_miss(3) < 1e-9);
}

TEST_CASE("at the middle of a corner the vertex is missed by 3/16 t_acc |v2 - v1|") {
  const PaulModel model = published_program();
  // Leg 2 runs at (20, 0) mm/s, leg 3 at (-50, 86)/4.3 mm/s; the vertex is (140, 40).
  const double dv_x = -50 / 4.3 - 20;
  const double dv_y = 86 / 4.3;
  const AxisState middle = model.at(7.75 + 1.375);
  CHECK(middle.q[0] == doctest::Approx(140 + 3.0 / 16 * 1.375 * dv_x));
  CHECK(middle.q[1] == doctest::Approx(40 + 3.0 / 16 * 1.375 * dv_y));
  CHECK(middle.qd[0] == doctest::Approx((20 - 50 / 4.3) / 2));
  CHECK(middle.qdd[1] == doctest::Approx(0.75 * dv_y / 1.375));
}

TEST_CASE("between corners the axes run straight and evenly") {
  const AxisState state =
      published_program().at(2.75 + 1.375 + 2.0);  // 2 s behind the vertex (40, 40)
  CHECK(state.q[0] == doctest::Approx(40 + 2.0 * 20).epsilon(1e-12));
  CHECK(state.q[1] == doctest::Approx(40).epsilon(1e-12));
  CHECK(state.qd[0] == doctest::Approx(20).epsilon(1e-12));
  CHECK(state.qdd[0] == 0);
}

TEST_CASE("velocity is the slope of position and acceleration the slope of velocity, everywhere") {
  const PaulModel model = published_program();
  constexpr double kStep = 1e-5;
  for (double t = 0.01; t < 19.09; t += 0.0373) {
    const AxisState before = model.at(t - kStep);
    const AxisState here = model.at(t);
    const AxisState behind = model.at(t + kStep);
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(std::abs((behind.q[i] - before.q[i]) / (2 * kStep) - here.qd[i]) < 1e-6);
      // At a joint of two formulas the acceleration has a kink of at most 32 mm/s³.
      CHECK(std::abs((behind.qd[i] - before.qd[i]) / (2 * kStep) - here.qdd[i]) < 4e-4);
    }
  }
}

TEST_CASE("a run begins and ends at rest, exactly at its places") {
  const PaulModel model = published_program();
  CHECK(model.at(0).q == AxisValues{0, 0, 0});
  CHECK(model.at(0).qd == AxisValues{0, 0, 0});
  const AxisState end = model.at(19.2);
  CHECK(end.q[0] == doctest::Approx(40).epsilon(1e-14));
  CHECK(end.q[1] == doctest::Approx(40).epsilon(1e-14));
  CHECK(end.qd == AxisValues{0, 0, 0});
}

TEST_CASE("the slowest axis, the user's time and twice t_acc bound a segment from below") {
  const PaulModel model(gantry_robot(), {0, 0, 0},
                        {move(1, {10, 0, 90}), move(2, {11, 0, 90}), move(3, {21, 0, 90}, 6.5)});
  CHECK(model.segments()[0].t1 == 4.5);
  CHECK(model.segments()[1].t1 == 2.75);
  CHECK(model.segments()[2].t1 == 6.5);
}

TEST_CASE("a repeated MOVE makes its target exact, and STOP after it costs nothing") {
  const PaulModel model(gantry_robot(), {0, 0, 0},
                        {move(1, {60, 0, 0}), move(2, {60, 0, 0}), stop(3), stop(4)});
  REQUIRE(model.segments().size() == 2);
  CHECK(model.total() == doctest::Approx(3 + 2.75));
  CHECK(model.corner_miss(0) < 1e-9);
}

TEST_CASE("where nothing has moved STOP and END cost nothing") {
  const PaulModel model(gantry_robot(), {5, 6, 7}, {stop(1), stop(2)});
  CHECK(model.segments().empty());
  CHECK(model.total() == 0);
  CHECK(model.at(1).q == AxisValues{5, 6, 7});
}

TEST_CASE("a tool that turns back passes nearer before the corner than in it") {
  // To x = 50 and 1 mm back: at the end of the first corner the tool comes back over x = 49.5, so
  // it has been on the second target, 49, on its way out. The corner there begins 0.5 mm away.
  const PaulModel model(gantry_robot(), {0, 0, 0},
                        {move(1, {50, 0, 0}), move(2, {49, 0, 0}), move(3, {49, 60, 0}), stop(4)});
  CHECK(model.nearest_pass(1) < 0.02);
  CHECK(model.at(5.5).q[0] == doctest::Approx(49.5));
  CHECK(model.corner_miss(1) > 0.2);
  CHECK(model.corner_miss(1) < 0.5);
  CHECK(model.nearest_pass(0) <= model.corner_miss(0));
}
