#include "drivers/link/grbl_link.h"

#include <doctest/doctest.h>

#include <chrono>
#include <thread>

#include "tests/drivers/link/wire_bench.h"
#include "tests/emulators/grbl_emulator.h"

namespace rob::drivers {
namespace {

using motion::DriverStatus;
using test::all;
using test::GrblEmulator;
using test::mentions;
using test::WireBench;

std::unique_ptr<WireBackend> machine_on(GrblEmulator& grbl, bool home = false,
                                        double period = 0.02) {
  const auto axes = test::plain_axes(3, 0, 50);
  WireSettings settings = test::settings_for(grbl.path(), axes, period);
  settings.home = home;
  return std::make_unique<WireBackend>(settings, grbl_link(axes));
}

motion::JointVector place(double x, double y, double z) {
  motion::JointVector q(3);
  q << x, y, z;
  return q;
}

}  // namespace

TEST_CASE("grbl goes where it is told, in the time that it is told") {
  GrblEmulator grbl;
  grbl.stand_at(5, 0, 0);
  {
    WireBench bench(machine_on(grbl));
    CHECK(bench.machine().position()[0] == 5);
    bench.go(place(25, 10, -3), 1.0);
    bench.comes(DriverStatus::Lost, 0.5);
    CHECK(bench.state().measured.q[0] == doctest::Approx(25).epsilon(0.001));
    CHECK(bench.count(DriverStatus::Silent) == 0);
  }
  const auto q = grbl.position();
  CHECK(q[0] == doctest::Approx(25).epsilon(0.0005));
  CHECK(q[1] == doctest::Approx(10).epsilon(0.0005));
  CHECK(q[2] == doctest::Approx(-3).epsilon(0.0005));
  CHECK(grbl.moved_for() == doctest::Approx(1.0).epsilon(0.1));
  CHECK(grbl.moves() > 25);
  CHECK(grbl.overflows() == 0);
}

TEST_CASE("what grbl reports is compared with the references of the same instant") {
  double period = 0;
  SUBCASE("close together") { period = 0.02; }
  SUBCASE("so far apart that most reports lie between two") { period = 0.04; }
  GrblEmulator grbl;
  WireBench bench(machine_on(grbl, false, period));
  // At 20 mm/s: 80 ms are 1.6 mm; the wire and a busy computer leave a part of it.
  const double start = bench.now();
  double worst = 0;
  while (bench.now() - start < 2) {
    const double t = bench.now() - start;
    bench.cycle(place(20 * t, 0, 0));
    const double then = bench.state().measured.time - start;
    if (then < 0.3) continue;
    worst = std::max(worst, std::abs(bench.state().measured.q[0] - 20 * then));
  }
  CHECK(worst < 0.2);
}

TEST_CASE("fault 18: grbl that is held by something falls behind its references") {
  GrblEmulator grbl;
  WireBench bench(machine_on(grbl));
  bench.go(place(4, 0, 0), 0.5);
  grbl.jammed = true;
  bench.go(place(24, 0, 0), 1.0);  // at 20 mm/s: 200 ms of window, 100 ms between reports
  CHECK(bench.state().measured.q[0] < 6);
  CHECK(bench.now() - bench.state().measured.time < 0.5);
}

TEST_CASE("a short motion, and one that comes after a pause, arrive wholly") {
  GrblEmulator grbl;
  WireBench bench(machine_on(grbl));
  bench.go(place(0.5, 0, 0), 0.03);  // fewer moves than are collected
  bench.comes(DriverStatus::Lost, 0.5);
  CHECK(grbl.position()[0] == doctest::Approx(0.5).epsilon(0.01));
  bench.go(place(0, 0, 0), 0.2);
  bench.comes(DriverStatus::Lost, 0.5);
  CHECK(std::abs(grbl.position()[0]) < 0.005);
  CHECK(grbl.idle());
}

TEST_CASE("positions are those of the work coordinates") {
  GrblEmulator grbl;
  grbl.offset = {10, 0, 0};
  grbl.stand_at(15, 0, 0);
  grbl.settings[20] = 1;  // soft limits
  const auto machine = machine_on(grbl);
  REQUIRE(test::trouble_opening(*machine) == "");
  CHECK(machine->position()[0] == 5);
  CHECK(machine->least(0) == -410);
  CHECK(machine->most(0) == -10);
  CHECK(machine->most_speed(0) == 100);  // 6000 mm/min
  CHECK(machine->most_acceleration(1) == 500);
}

TEST_CASE("position and limits wait for the work offset, which grblHAL's first report leaves out") {
  for (const int in_report : {1, 2, 0}) {  // grbl, grblHAL, and reports that never have it: $#
    CAPTURE(in_report);
    GrblEmulator grbl;
    grbl.offset_in_report = in_report;
    grbl.offset = {-100, -80, 4};
    grbl.settings[20] = 1;
    WireBench bench(machine_on(grbl));
    CHECK(bench.machine().position()[0] == doctest::Approx(100));
    CHECK(bench.machine().position()[1] == doctest::Approx(80));
    CHECK(bench.machine().position()[2] == doctest::Approx(-4));
    CHECK(bench.machine().least(0) == doctest::Approx(-300));
    CHECK(bench.machine().most(1) == doctest::Approx(80));
    bench.go(place(110, 80, -4), 0.5);
    bench.comes(DriverStatus::Lost, 0.5);
    CHECK(grbl.position()[0] == doctest::Approx(10).epsilon(0.01));
    CHECK(std::abs(grbl.position()[1]) < 0.01);
  }
}

TEST_CASE("an old banner that makes it ask too soon: the settings are asked for again") {
  GrblEmulator grbl;
  grbl.starts_for = 1.2;
  grbl.stand_at(3, 0, 0);
  const auto machine = machine_on(grbl);
  CHECK(test::trouble_opening(*machine) == "");
  CHECK(machine->position()[0] == 3);
}

TEST_CASE("what is done at the machine stops the streaming, and is named") {
  struct Case {
    const char* what;
    void (*happens)(GrblEmulator& grbl);
  };
  const Case cases[] = {
      {"put on hold", [](GrblEmulator& grbl) { grbl.hold(); }},
      {"safety door is open", [](GrblEmulator& grbl) { grbl.open_door(); }},
      {"feed override of grbl is at 50 %", [](GrblEmulator& grbl) { grbl.override_feed(50); }},
      {"feed override of grbl is at 150 %", [](GrblEmulator& grbl) { grbl.override_feed(150); }},
      {"is jogged", [](GrblEmulator& grbl) { grbl.take_foreign("$J=G91 G21 Y5 F600"); }},
      {"work offset of grbl was changed", [](GrblEmulator& grbl) {
         grbl.set_offset({7, 0, 0});
       }}};
  for (const Case& made : cases) {
    CAPTURE(made.what);
    GrblEmulator grbl;
    WireBench bench(machine_on(grbl));
    bench.go(place(4, 0, 0), 0.4);
    made.happens(grbl);
    bench.go(place(20, 0, 0), 1.6);
    CHECK(bench.comes(DriverStatus::Alarm, 2));
    const std::string trouble = bench.machine().trouble();
    CAPTURE(trouble);
    CHECK(mentions(trouble, made.what));
    CHECK(mentions(trouble, "; "));  // and there is a remedy
    CHECK_FALSE(mentions(trouble, "cable"));
  }
}

TEST_CASE("after an alarm it still reports where grbl stands") {
  GrblEmulator grbl;
  WireBench bench(machine_on(grbl));
  bench.go(place(4, 0, 0), 0.4);
  grbl.hold();
  CHECK(bench.comes(DriverStatus::Alarm, 2));
  bench.comes(DriverStatus::Lost, 0.4);
  CHECK(bench.state().measured.q[0] == doctest::Approx(grbl.position()[0]).epsilon(1e-3));
  CHECK(bench.state().measured.qd[0] == 0);
}

TEST_CASE("fault 29: with the answers to all lines lost it is said that they are, at once") {
  GrblEmulator grbl;
  WireBench bench(machine_on(grbl));
  bench.go(place(4, 0, 0), 0.4);
  grbl.lost_oks = 1000;
  const double since = bench.now();
  bench.go(place(24, 0, 0), 1);
  CHECK(bench.count(DriverStatus::Alarm) > 0);
  CHECK(mentions(bench.machine().trouble(), "answers of grbl were lost on the wire"));
  CHECK(bench.now() - since < 3);
  CHECK(grbl.position()[0] < 24);
}

TEST_CASE("what else moves grbl is offered as the cause where an axis is off its reference") {
  GrblEmulator grbl;
  WireBench bench(machine_on(grbl));
  bench.go(place(4, 0, 0), 0.4);
  CHECK(mentions(bench.machine().remark(), "grbl counts its own steps"));
}

TEST_CASE("fault 26: a silent grbl is left when its axes can have braked, not seconds later") {
  GrblEmulator grbl;
  WireBench bench(machine_on(grbl));
  bench.go(place(4, 0, 0), 0.4);
  grbl.silent = true;
  CHECK(bench.comes(DriverStatus::Silent, 3));
  const double since = bench.now();
  bench.machine().disable(since);
  bench.close();
  CHECK(bench.now() - since < 1);
  CHECK(test::eventually([&] { return grbl.resets() == 2; }));  // the first was to connect
  CHECK(grbl.idle());
}

TEST_CASE("fault 38: grbl that ran dry while nothing was sent is not driven on") {
  GrblEmulator grbl;
  WireBench bench(machine_on(grbl));
  bench.go(place(8, 0, 0), 0.4);
  // The tick is gone for longer than grbl has moves; the thread of the wire is, too.
  std::this_thread::sleep_for(std::chrono::milliseconds(600));
  REQUIRE(test::eventually([&] { return grbl.idle(); }));
  const double stands = grbl.position()[0];
  const int moves = grbl.moves();
  for (int i = 0; i < 20; ++i) {  // only looking
    bench.look();
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  CHECK(grbl.moves() == moves);
  CHECK(bench.state().measured.q[0] == doctest::Approx(stands).epsilon(1e-3));
  CHECK(bench.now() - bench.state().seen < 0.3);
  bench.go(place(stands, 0, 0), 0.2);
  CHECK(std::abs(grbl.position()[0] - stands) < 0.01);
}

TEST_CASE("fault 30: an error stops the streaming, in words") {
  GrblEmulator grbl;
  WireBench bench(machine_on(grbl));
  bench.go(place(2, 0, 0), 0.2);
  grbl.error_next = 33;
  bench.go(place(4, 0, 0), 0.3);
  CHECK(bench.comes(DriverStatus::Alarm, 2));
  CHECK(mentions(bench.machine().trouble(), "grbl error:33: the target is not valid"));
  bench.comes(DriverStatus::Lost, 0.1);  // what was on the wire has come
  const int moves = grbl.moves();
  bench.go(place(0, 0, 0), 0.2);
  CHECK(grbl.moves() == moves);
}

TEST_CASE("fault 30: an alarm says whether the position is lost") {
  for (const int number : {1, 2, 3}) {
    GrblEmulator grbl;
    WireBench bench(machine_on(grbl));
    bench.go(place(1, 0, 0), 0.2);
    grbl.raise_alarm(number);
    CHECK(bench.comes(DriverStatus::Alarm, 2));
    CHECK(mentions(bench.machine().trouble(), "ALARM:" + std::to_string(number)));
    CHECK(mentions(bench.machine().trouble(), "its position is not known") == (number != 2));
  }
}

TEST_CASE("fault 29: an ok that is lost is noticed") {
  GrblEmulator grbl;
  WireBench bench(machine_on(grbl));
  bench.go(place(1, 0, 0), 0.2);
  grbl.lost_oks = 1;
  bench.go(place(40, 0, 0), 2);
  CHECK(bench.count(DriverStatus::Alarm) > 0);  // though those of all lines behind have come
  CHECK(mentions(bench.machine().trouble(), "answers of grbl were lost on the wire"));
  CHECK(grbl.overflows() == 0);
}

TEST_CASE("fault 31: grbl that restarts is not driven on") {
  GrblEmulator grbl;
  WireBench bench(machine_on(grbl));
  bench.go(place(1, 0, 0), 0.2);
  grbl.restart();
  CHECK(bench.comes(DriverStatus::Alarm, 2));
  CHECK(mentions(bench.machine().trouble(), "has restarted"));
}

TEST_CASE("faults 23, 26: silence and an unplugged grbl") {
  GrblEmulator grbl;
  WireBench bench(machine_on(grbl));
  bench.go(place(1, 0, 0), 0.2);
  grbl.silent = true;
  CHECK(bench.comes(DriverStatus::Silent, 3));
  grbl.unplug();
  CHECK(bench.comes(DriverStatus::Lost, 2));
}

TEST_CASE("a grbl that cannot be used is refused, and it is said why") {
  SUBCASE("an old firmware") {
    GrblEmulator grbl;
    grbl.banner = "Grbl 0.9j ['$' for help]";
    CHECK(mentions(test::trouble_opening(*machine_on(grbl)), "Rob needs grbl 1.1"));
  }
  SUBCASE("an acceleration that its look-ahead cannot hold") {
    GrblEmulator grbl;
    grbl.settings[120] = 10;
    // 50 mm/s / (2 · 80 ms) = 312.5 mm/s²
    CHECK(mentions(test::trouble_opening(*machine_on(grbl)), "$120=313.000"));
  }
  SUBCASE("all accelerations that are too low are told at once") {
    GrblEmulator grbl;
    for (const int axis : {0, 1, 2}) grbl.settings[120 + axis] = 10 + axis;
    const std::string trouble = test::trouble_opening(*machine_on(grbl));
    for (const char* part : {"$120=10.000 (axis x)", "$121=11.000 (axis y)", "$122=12.000 (axis z)",
                             "write $120=313.000, $121=313.000, $122=313.000"})
      CHECK(mentions(trouble, part));
  }
  SUBCASE("an open door") {
    GrblEmulator grbl;
    grbl.opens_door = true;
    CHECK(mentions(test::trouble_opening(*machine_on(grbl)), "its safety door is open; close"));
  }
  SUBCASE("a line that is too slow for its moves") {
    GrblEmulator grbl;
    const auto axes = test::plain_axes(3, 0, 50);
    WireBackend machine(test::settings_for(grbl.path(), axes, 0.02), grbl_link(axes, 9600));
    CHECK(mentions(test::trouble_opening(machine), "at 9600 baud the moves do not reach grbl"));
  }
  SUBCASE("locked") {
    GrblEmulator grbl;
    grbl.locked = true;
    CHECK(mentions(test::trouble_opening(*machine_on(grbl)), "grbl is locked"));
    CHECK(test::trouble_opening(*machine_on(grbl, true)) == "");  // homing unlocks it
  }
  SUBCASE("homing that is given up: it stops at once") {
    GrblEmulator grbl;
    grbl.homes_on = true;
    int looks = 0;
    const auto axes = test::plain_axes(3, 0, 50);
    WireSettings settings = test::settings_for(grbl.path(), axes, 0.02);
    settings.home = true;
    settings.given_up = [&] { return ++looks == 5; };
    WireBackend machine(settings, grbl_link(axes));
    CHECK(mentions(test::trouble_opening(machine), "homing was given up"));
    CHECK(test::eventually([&] { return grbl.resets() == 2; }));  // the first was to connect
  }
  SUBCASE("without homing switches") {
    GrblEmulator grbl;
    grbl.settings[22] = 0;
    CHECK(mentions(test::trouble_opening(*machine_on(grbl, true)),
                   "homing is switched off in grbl ($22=0)"));
    CHECK(grbl.homing() == 0);
  }
}

TEST_CASE("what is not acknowledged never is more than grbl's buffer holds") {
  GrblStream stream;
  stream.begin({0}, {250}, 0.02);
  int sent = 0;
  int bytes = 0;
  for (int i = 1; i <= 40; ++i) {
    WireCommand command{0.02 * i, {static_cast<double>(i)}, {}};
    stream.push(command);
    for (std::string line; !(line = stream.next_line(0)).empty(); ++sent)
      bytes += static_cast<int>(line.size());
  }
  CHECK(bytes <= 127);
  CHECK(sent >= 3);
  CHECK(stream.open_lines() == sent);
  stream.acknowledged();
  CHECK_FALSE(stream.next_line(0).empty());
}

TEST_CASE("a move lasts as long as its references are apart, and steps are whole") {
  GrblStream stream;
  stream.begin({0, 2}, {250, 100}, 0.02);
  for (int i = 1; i <= 4; ++i) stream.push({1 + 0.02 * i, {0.1011 * i, 0}, {}});
  // 0.1011 mm are 25.275 steps: 25, then 26 and so on; 0.02 s are F3000.
  CHECK(stream.next_line(0) == "G91G21G93G1X0.10000F3000.000\n");
  CHECK(stream.next_line(0) == "G91G21G93G1X0.10400F3000.000\n");
  stream.push({1.12, {0.5055, 0.02}, {}});  // one reference was missing
  stream.next_line(0);
  stream.next_line(0);
  for (int i = 0; i < 4; ++i) stream.acknowledged();
  CHECK(stream.next_line(0) == "G91G21G93G1X0.10000Z0.02000F1500.000\n");
}

TEST_CASE("no move is faster than the axes, though references were missing") {
  GrblStream stream;
  stream.begin({0}, {250}, 0.02, {20});
  stream.push({1, {0}, {}});
  stream.push({1.02, {0.4}, {}});
  // 0.3 s late: grbl has run dry, and 6 mm are to be made up at 20 mm/s: 0.3 s, 200 a minute.
  for (int i = 0; i < 4; ++i) stream.push({1.32 + 0.02 * i, {6.4 + 0.4 * i}, {}});
  CHECK(stream.next_line(0) == "G91G21G93G1X0.40000F3000.000\n");
  CHECK(stream.next_line(0) == "G91G21G93G1X6.00000F200.000\n");
  CHECK(stream.next_line(0) == "G91G21G93G1X0.40000F3000.000\n");
}

}  // namespace rob::drivers
