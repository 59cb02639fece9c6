// The pendant on the virtual clock: what keys do to the robot.

#include "runtime/prompt/pendant.h"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <regex>

#include "motion/robots/robot_library.h"
#include "runtime/prompt/pendant_keys.h"
#include "runtime/prompt/pendant_view.h"
#include "tests/runtime/prompt/virtual_prompt.h"
#include "tests/support/degrees.h"

using namespace rob::runtime;
using rob::test::kDegree;
using rob::test::VirtualPrompt;
using Event = Key::Event;

namespace {

constexpr Key kRight{Key::Kind::Right};
constexpr Key kUpKey{Key::Kind::Up};

Key letter(char c, Event event = Event::Press) {
  return {Key::Kind::Character, static_cast<char32_t>(c), event};
}

Key with(Key key, Event event) {
  key.event = event;
  return key;
}

struct Held : VirtualPrompt {
  explicit Held(bool releases, const std::string& robot = "gantry")
      : VirtualPrompt(robot), pendant(session, session.dead_man(), releases) {
    session.let_pass();
  }
  void pass(double seconds) {
    const double until = time() + seconds;
    while (time() < until - 1e-9) {
      session.let_pass();
      pendant.go_on();
    }
  }
  /// Until the robot stands.
  void rest() {
    do pass(0.02);
    while (!session.robot().idle());
    pendant.go_on();
  }
  const rob::motion::GeneratorSample& sample() const {
    return session.robot().reports().last()->sample;
  }
  double q(int axis) const { return sample().reference.q[axis]; }
  double speed(int axis) const { return sample().reference.qd[axis]; }
  /// m/s, of the flange.
  Eigen::Vector3d velocity() const {
    constexpr double kMoment = 1e-6;  // s
    const auto place = [&](double time) {
      return session.robot()
          .robot()
          .kinematics->forward(sample().reference.q + sample().reference.qd * time)
          .position;
    };
    return (place(kMoment) - place(-kMoment)) / (2 * kMoment);
  }

  Pendant pendant;
};

}  // namespace

TEST_CASE("a key that is held moves its axis at the share of its speed") {
  Held held(true);
  held.pendant.press(kRight);
  held.pass(0.7);
  // 10 % of 20 mm/s.
  CHECK(held.speed(0) == doctest::Approx(0.002));
  CHECK(held.speed(1) == 0);
}

TEST_CASE("the stop begins within 50 ms of the release") {
  Held held(true);
  held.pendant.press(letter(']'));
  held.pendant.press(kRight);
  held.pass(0.6);
  const double moving = held.speed(0);
  CHECK(moving == doctest::Approx(0.005));
  held.pendant.press(with(kRight, Event::Release));
  held.pass(0.05);
  CHECK(held.speed(0) < moving);
  held.rest();
  CHECK(held.speed(0) == 0);
}

TEST_CASE("a key whose repeats stop coming moves no further") {
  // A held key is good for 0.75 s, its repeats for 0.3 s each.
  Held held(true);
  held.pendant.press(kRight);
  for (int i = 0; i < 20; ++i) {
    held.pass(0.1);
    held.pendant.press(with(kRight, Event::Repeat));
  }
  CHECK(held.speed(0) > 0);
  held.pass(0.3 + 0.4);  // and the time that braking takes
  CHECK(held.speed(0) == 0);
}

TEST_CASE("a step is as long as it says") {
  Held held(false);
  CHECK(held.pendant.style() == Pendant::Style::Step);
  held.pendant.press(kRight);
  held.rest();
  CHECK(held.q(0) == doctest::Approx(0.001).epsilon(1e-6));  // 1 mm
  held.pendant.press(letter('.'));
  held.pendant.press(kUpKey);
  held.rest();
  CHECK(held.q(1) == doctest::Approx(0.010).epsilon(1e-6));
}

TEST_CASE("a step that does not take whole periods at full rate is as long as it says, too") {
  Held held(false, "lwa4p");
  held.pendant.press(letter(']'));  // 25 % of 72 deg/s: 10 deg would take 0.5556 s
  held.pendant.press(letter('.'));
  const double before = held.q(0);
  held.pendant.press(kRight);
  held.rest();
  CHECK((held.q(0) - before) / kDegree == doctest::Approx(10).epsilon(1e-6));
}

TEST_CASE("at full speed a tool goes 250 mm/s, if its axes can, and axes as fast as they can") {
  const auto fastest = [](const std::string& robot, bool tool, const Key& key, auto speed) {
    Held held(true, robot);
    for (int i = 0; i < 3; ++i) held.pendant.press(letter(']'));  // 25, 50, 100 %
    REQUIRE(held.pendant.share() == 1);
    if (tool) held.pendant.press(letter('w'));
    held.pendant.press(key);
    held.pass(0.6);
    return speed(held);
  };
  const Key page_up{Key::Kind::PageUp};
  const auto axis_speed = [](const Held& held) { return held.speed(0); };
  const auto tool_speed = [](const Held& held) { return held.velocity().norm(); };
  CHECK(fastest("gantry", true, kRight, axis_speed) == doctest::Approx(0.02));
  CHECK(fastest("lwa4p_urdf", false, kRight, axis_speed) / kDegree == doctest::Approx(72));
  CHECK(fastest("lwa4p", true, page_up, tool_speed) == doctest::Approx(0.25));
}

TEST_CASE("never more than one step is pending") {
  Held held(false);
  for (int i = 0; i < 10; ++i) held.pendant.press(kRight);
  for (int i = 0; i < 5; ++i) held.rest();
  CHECK(held.q(0) == doctest::Approx(0.002).epsilon(1e-6));
}

TEST_CASE("a pulse moves for 0.3 s, its repeats prolong it, and any other key stops it") {
  Held held(false);
  held.pendant.press(letter('m'));
  CHECK(held.pendant.style() == Pendant::Style::Pulse);
  held.pendant.press(kRight);
  held.rest();
  const double one = held.q(0);
  CHECK(one > 0);
  CHECK(one < 0.002 * 0.75);  // 10 % of 20 mm/s for 0.3 s, and what it takes to come to rest
  held.pendant.press(kRight);
  for (int i = 0; i < 10; ++i) {
    held.pass(0.1);
    held.pendant.press(kRight);
  }
  CHECK(held.speed(0) == doctest::Approx(0.002));
  held.pendant.press(letter('w'));
  CHECK(held.pendant.frame() == rob::lang::JogFrame::Joint);  // it did nothing else
  held.pass(0.05);
  CHECK(held.speed(0) < 0.002);
}

TEST_CASE("a jog stops short of a limit without an error, and may go back") {
  Held held(true);  // x from 0 to 400 mm, and it stands at 0
  const Key left{Key::Kind::Left};
  held.pendant.press(left);
  held.pass(0.5);
  held.pendant.press(with(left, Event::Release));
  held.rest();
  CHECK(held.q(0) >= 0);
  CHECK(held.session.worst() == ExitCode::Done);
  held.pendant.press(kRight);
  held.pass(0.5);
  CHECK(held.speed(0) > 0);
}

TEST_CASE("an arm jogs in the world and in its tool") {
  Held held(true, "lwa4p");
  held.pendant.press(letter('w'));
  CHECK(held.pendant.coordinates() == std::vector<std::string>{"x", "y", "z", "a", "b", "c"});
  const auto place = [&] {
    return held.session.robot().robot().kinematics->forward(held.sample().reference.q).position;
  };
  const Eigen::Vector3d before = place();
  held.pendant.press(Key{Key::Kind::PageUp});
  held.pass(0.7);
  held.pendant.press(with(Key{Key::Kind::PageUp}, Event::Release));
  held.rest();
  const Eigen::Vector3d moved = place() - before;
  CHECK(moved.z() > 0.005);
  CHECK(moved.head<2>().norm() < 1e-6);
}

TEST_CASE("an arm under the pendant is never faster than the speed that is shown") {
  Held held(true, "lwa4p");
  held.pendant.press(letter('w'));
  for (int i = 0; i < 10; ++i) held.pendant.press(letter(']'));  // to 250 mm/s
  held.pendant.press(Key{Key::Kind::PageUp});
  double fastest = 0;  // m/s
  for (int i = 0; i < 100; ++i) {
    held.pass(0.004);
    fastest = std::max(fastest, held.velocity().norm());
  }
  CHECK(fastest <= 1.005 * 0.25);
  CHECK(fastest >= 0.99 * 0.25);
}

TEST_CASE("outputs are toggled, and Esc leaves") {
  Held held(false);
  held.pendant.press(letter('g'));
  held.rest();
  CHECK(held.enter({"PRINT gripper"}) == "TRUE\n");
  held.pendant.press(letter('o'));
  held.pendant.press(letter('3'));
  held.rest();
  CHECK(held.enter({"PRINT DOUT[3]"}) == "TRUE\n");
  held.pendant.press(Key{Key::Kind::Escape});
  CHECK(held.pendant.over());
}

TEST_CASE("half a turn of the tool is shown as HERE prints it, 180deg") {
  Held held(false);
  held.enter({"MOVE(0, 0, -180) FINE", "STOP", "WAIT 1s"});
  CHECK(held.enter({"PRINT HERE"}).find("180deg)") != std::string::npos);
  const auto view = [&] { return pendant_view(held.pendant, "", 80, 24); };
  CHECK(view().find("c   180.00 deg") != std::string::npos);
  held.enter({"MOVE(0, 0, -179.998) FINE", "STOP", "WAIT 1s"});  // -180.00 with two decimals
  CHECK(view().find("c   180.00 deg") != std::string::npos);
}

TEST_CASE("the view shows place, mode and keys within the size of the terminal") {
  Held held(false);
  held.pendant.press(kRight);
  held.rest();
  const std::string view = pendant_view(held.pendant, "hello", 80, 24);
  CHECK(view.starts_with("  gantry idle (1, 0, 0)"));
  const double shown = held.session.robot().reports().last()->measured[0] * 1000;
  CHECK(view.find(fmt::format("> x       {:>12.3f} mm", shown)) != std::string::npos);
  CHECK(view.find("hello") != std::string::npos);
  const std::string small = pendant_view(held.pendant, "", 39, 3);
  CHECK(small == "  the pendant needs 40x12 characters;\n  this terminal has 39x3. Esc leaves");
}

TEST_CASE("Ctrl-C forgets the name that is being typed, and the pendant stays") {
  Held held(true);
  held.pendant.press(letter('p'));
  held.pendant.press(letter('a'));
  REQUIRE(held.pendant.naming() == "a");
  held.pendant.give_up();
  CHECK_FALSE(held.pendant.naming());
  CHECK_FALSE(held.pendant.over());
}

namespace {

std::vector<std::string> lines_of(const std::string& view) {
  std::vector<std::string> lines(1);
  for (const char c : view) {
    if (c == '\n') {
      lines.emplace_back();
    } else {
      lines.back() += c;
    }
  }
  return lines;
}

long width_of(const std::string& line) {
  return std::ranges::count_if(line, [](char c) { return (c & 0xC0) != 0x80; });
}

std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++count;
  return count;
}

bool has_key(const Pendant& pendant, const std::string& key) {
  return std::ranges::count(acting_keys(pendant), key) == 1;
}

}  // namespace

TEST_CASE("the pendant of every robot fits 40x12, with its axes, its tool and all of its keys") {
  for (const std::string_view robot : rob::motion::robot_names()) {
    INFO(std::string(robot));
    Held held(false, std::string(robot));
    const std::string view = pendant_view(held.pendant, "", 40, 12);
    const std::vector<std::string> lines = lines_of(view);
    CHECK(lines.size() <= 12);
    for (const std::string& line : lines) CHECK(width_of(line) <= 40);
    for (const auto& axis : held.session.robot().robot().axes)
      CHECK(view.find(" " + axis.name) != std::string::npos);
    CHECK(view.find(" mm\n a ") != std::string::npos);
    CHECK(view.find("Esc leave") != std::string::npos);
  }
}

TEST_CASE("the pendant shows only keys that act on its robot") {
  const Held gantry(false);
  CHECK(has_key(gantry.pendant, "l lift"));
  CHECK(has_key(gantry.pendant, "PgDn PgUp theta"));
  CHECK_FALSE(has_key(gantry.pendant, "w world t tool"));
  Held arm(false, "lwa4p");
  CHECK(has_key(arm.pendant, "w world t tool"));
  CHECK(has_key(arm.pendant, "g gripper"));
  CHECK_FALSE(has_key(arm.pendant, "l lift"));
  arm.pendant.press(letter('w'));
  CHECK(has_key(arm.pendant, "j joint t tool"));
  const Held servos(false, "so101");  // without outputs
  CHECK(has_key(servos.pendant, "w world t tool"));
  CHECK_FALSE(has_key(servos.pendant, "o out"));
}

TEST_CASE("keys that do nothing are not shown, and those do nothing") {
  Held held(false);
  for (int i = 0; i < 10; ++i) held.pendant.press(letter('['));
  CHECK(has_key(held.pendant, "] speed"));
  held.pendant.press(letter('t'));
  CHECK(held.pendant.frame() == rob::lang::JogFrame::Joint);
  held.pendant.press(letter('m'));
  CHECK_FALSE(has_key(held.pendant, ", . step"));
  held.pendant.press(letter('o'));
  CHECK(acting_keys(held.pendant) == std::vector<std::string>{"1-9 the output", "Esc none"});
  held.pendant.press(Key{Key::Kind::Escape});
  CHECK_FALSE(held.pendant.over());
  CHECK(has_key(held.pendant, "o out"));
}

TEST_CASE("the view has no minus before zero, and ASCII alone where that is wanted") {
  Held held(false, "lwa4p");
  held.pendant.press(kRight);
  held.rest();
  for (const auto& [columns, rows] : {std::pair{40, 12}, std::pair{80, 24}}) {
    const std::string view = pendant_view(held.pendant, "", columns, rows, false);
    CHECK(std::ranges::all_of(view, [](char c) { return static_cast<unsigned char>(c) < 0x80; }));
    CHECK_FALSE(std::regex_search(view, std::regex("-0\\.0+ ")));
    CHECK(view.find("<- -> j1") != std::string::npos);
  }
}

TEST_CASE("the end of an axis that stops a jog is told once a stop") {
  Held held(false);  // x from 0 to 400 mm, and it stands at 0
  const Key left{Key::Kind::Left};
  const auto told = [&] {
    return occurrences(held.screen.messages, "axis x stops the jog: it ends at 0 mm\n");
  };
  for (int i = 0; i < 3; ++i) {
    held.pendant.press(left);
    held.rest();
  }
  CHECK(told() == 1);
  for (int i = 0; i < 2; ++i) held.pendant.press(letter('.'));  // 50 mm
  held.pendant.press(kRight);
  held.rest();
  for (int i = 0; i < 2; ++i) {
    held.pendant.press(left);
    held.rest();
  }
  CHECK(told() == 2);
}

TEST_CASE("a jog that is over before it has begun is no news") {
  Held held(false);
  held.pendant.press(letter('m'));
  held.pendant.press(kRight);
  held.session.dead_man().release();  // as where the computer is too busy to begin in time
  held.rest();
  CHECK(held.screen.messages.empty());
}
