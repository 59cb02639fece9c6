#include "motion/plan/sent_boxes.h"

#include <doctest/doctest.h>

#include <memory>

namespace rob::motion {
namespace {

SegmentDescriptor numbered(std::uint32_t number) {
  SegmentDescriptor segment;
  segment.number = number;
  return segment;
}

}  // namespace

TEST_CASE("what a motion has boxed is kept as long as the generator can have a copy") {
  RobotModel robot;
  robot.look_ahead = 64;
  SentBoxes boxes(robot);
  std::weak_ptr<const void> events;
  std::weak_ptr<const void> rates;
  {
    SegmentDescriptor segment = numbered(1);
    segment.on_the_way.push_back({0.5, 0, {}});
    segment.jog = JogRates{JogRates::Space::Joint, JointVector::Zero(3), {}};
    events = segment.on_the_way.box();
    rates = segment.jog.box();
    boxes.keep(segment);
  }
  const auto most = static_cast<std::uint32_t>(most_ahead(robot));
  for (std::uint32_t number = 2; number <= most + 2; ++number) {
    boxes.keep(numbered(number));
    REQUIRE_FALSE(events.expired());
    REQUIRE_FALSE(rates.expired());
  }
  boxes.keep(numbered(2 * most));
  CHECK(events.expired());
  CHECK(rates.expired());
}

TEST_CASE("events of a copy are its own once they are changed") {
  SegmentDescriptor first = numbered(1);
  first.on_the_way.push_back({0.25, 0, {}});
  SegmentDescriptor second = first;
  CHECK(first.on_the_way.box() == second.on_the_way.box());
  second.on_the_way.change_each([](PathEvent& event) { event.share *= 2; });
  second.on_the_way.push_back({0.75, 0, {}});
  REQUIRE(first.on_the_way.size() == 1);
  CHECK(first.on_the_way[0].share == 0.25);
  REQUIRE(second.on_the_way.size() == 2);
  CHECK(second.on_the_way[0].share == 0.5);
}

}  // namespace rob::motion
