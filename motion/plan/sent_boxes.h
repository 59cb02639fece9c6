#pragma once

#include <cstdint>
#include <deque>
#include <memory>

#include "motion/plan/segment_descriptor.h"
#include "motion/robots/robot_model.h"

namespace rob::motion {

/// Keeps what motions have boxed for as long as the generator may have a copy, so that none of its
/// copies is the last. Belongs to the thread that sends them.
class SentBoxes {
 public:
  explicit SentBoxes(const RobotModel& robot)
      : most_(static_cast<std::uint32_t>(most_ahead(robot)) + kRunning) {}

  /// Before it is sent.
  void keep(const SegmentDescriptor& segment) {
    while (!boxes_.empty() && boxes_.front().number + most_ < segment.number) boxes_.pop_front();
    for (const auto& box : {segment.on_the_way.box(), segment.jog.box()})
      if (box) boxes_.push_back({segment.number, box});
  }

 private:
  struct Box {
    std::uint32_t number = 0;  ///< of its motion
    std::shared_ptr<const void> value;
  };

  static constexpr std::uint32_t kRunning = 8;  ///< [choice] one runs, others have just been done

  std::uint32_t most_;  ///< how many motions the generator can have copies of
  std::deque<Box> boxes_;
};

}  // namespace rob::motion
