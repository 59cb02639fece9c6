// At the prompt and by the pendant a jog stops before the robot hits itself.

#include <doctest/doctest.h>

#include "base/unit_factors.h"
#include "runtime/prompt/pendant.h"
#include "runtime/prompt/pendant_view.h"
#include "tests/runtime/prompt/virtual_prompt.h"

using namespace rob::runtime;
using rob::test::VirtualPrompt;

namespace {

double elbow_of(const VirtualPrompt& prompt) {
  return prompt.session.robot().reports().last()->sample.reference.q[2] / rob::kDegree;
}

}  // namespace

TEST_CASE("a jog at the prompt says what it stops before, and leads away again") {
  // The UR5e's elbow folds the wrist onto the shoulder; its own end is at 180°.
  VirtualPrompt prompt("ur5e");
  prompt.enter({"JOG JOINT (elbow: 60deg/s) FOR 2s"});
  CHECK(prompt.screen.messages == "the jog stops: shoulder is near wrist3\n");
  const double held = elbow_of(prompt);
  CHECK(held > 150);
  CHECK(held < 170);
  prompt.enter({"JOG JOINT (elbow: -30deg/s) FOR 1s"});
  CHECK(elbow_of(prompt) < held - 10);
}

TEST_CASE("the pendant shows that it holds at a body") {
  VirtualPrompt prompt("ur5e");
  Pendant pendant(prompt.session, prompt.session.dead_man(), true);
  prompt.session.let_pass();
  constexpr Key kPageUp{Key::Kind::PageUp};
  pendant.press({Key::Kind::Character, U']', Key::Event::Press});  // 25 %: 45 deg/s
  pendant.press(kPageUp);
  bool shown = false;
  for (int i = 0; i < 25; ++i) {
    const double until = prompt.time() + 0.1;
    while (prompt.time() < until - 1e-9) {
      prompt.session.let_pass();
      pendant.go_on();
    }
    Key repeat = kPageUp;
    repeat.event = Key::Event::Repeat;
    pendant.press(repeat);
    shown = shown ||
            pendant_view(pendant, "", 80, 24).find("it holds short of a body") != std::string::npos;
  }
  CHECK(shown);
  CHECK(elbow_of(prompt) > 150);
  CHECK(elbow_of(prompt) < 170);
}
