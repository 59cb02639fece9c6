#include "motion/plan/look_ahead_buffer.h"

#include <doctest/doctest.h>

using namespace rob::motion;

TEST_CASE("the buffer holds the robot file's number of motions, and effects beside them") {
  LookAheadBuffer buffer(2);
  SegmentDescriptor segment;
  segment.number = 1;
  CHECK(buffer.push(segment));
  segment.number = 2;
  CHECK(buffer.push(segment));
  CHECK(buffer.full());
  CHECK_FALSE(buffer.push(segment));
  for (std::uint32_t id = 0; id < LookAheadBuffer::kEffects; ++id) {
    Effect effect;
    effect.id = id;
    REQUIRE(buffer.push(effect));
  }
  CHECK_FALSE(buffer.push(Effect{}));

  CHECK(buffer.next_segment()->number == 1);
  buffer.pop_segment();
  CHECK(buffer.next_segment()->number == 2);
  CHECK_FALSE(buffer.full());
  CHECK(buffer.next_effect()->id == 0);
  buffer.pop_effect();
  CHECK(buffer.next_effect()->id == 1);
}

TEST_CASE("a closed buffer still gives what is in it") {
  LookAheadBuffer buffer(2);
  buffer.push(SegmentDescriptor{});
  CHECK_FALSE(buffer.closed());
  buffer.close();
  CHECK(buffer.closed());
  REQUIRE(buffer.next_segment() != nullptr);
  buffer.pop_segment();
  CHECK(buffer.next_segment() == nullptr);
}
