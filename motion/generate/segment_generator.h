#pragma once

#include <atomic>
#include <cstdint>

#include "motion/generate/early_end.h"
#include "motion/generate/effect_order.h"
#include "motion/generate/event_queue.h"
#include "motion/generate/handler_call.h"
#include "motion/generate/path_law.h"
#include "motion/generate/segment_sequence.h"
#include "motion/generate/trajectory_generator.h"
#include "motion/generate/under_way.h"
#include "motion/generate/watch_list.h"
#include "motion/plan/look_ahead_buffer.h"
#include "motion/robots/robot_model.h"

namespace rob::motion {

/// Makes references on line, segment by segment (SegmentSequence), by a PathLaw; and what
/// interrupts them: holds, WHENs and their handlers, early ends (EarlyEnd).
///
/// WHENs are armed and disarmed by effects, asked in look() before the guard, and act in the cycle;
/// one that raises brakes like a guard. One with a handler holds the axes on the path until
/// go_on(), as hold() does; guards are not asked meanwhile.
///
/// Instants are s since the start of the run. The trajectory_generator.h rules on threads and the
/// tick hold; decidable() and late_decisions() may be read, and events taken, by one other thread.
class SegmentGenerator : public TrajectoryGenerator {
 public:
  void look(const CycleView& view) noexcept override;
  const GeneratorSample& advance(std::int64_t period) noexcept override;
  void keep_to(const JogRoom& room) noexcept override { sequence_.keep_to(room); }
  void hold() noexcept override { stopped_ = true; }
  void resume() noexcept override { stopped_ = held_reported_ = false; }
  void set_override(double share) noexcept override;
  void go_on(double time) noexcept override;
  void decline_handler(double time) noexcept override;
  void bar_handlers(bool barred) noexcept override;
  void leave_path(const JointVector& q, double time, bool all) noexcept override;
  void stand_at(const JointVector& q) noexcept override { sequence_.stand_at(q); }
  void brake() noexcept override;
  std::uint32_t decidable() const noexcept override {
    return decidable_.load(std::memory_order_acquire);
  }
  bool take_event(MotionEvent& event) noexcept override {
    return law_.ready() && events_.take(event);
  }
  bool take_rest(Rest& rest) noexcept override {
    early_.take();
    return events_.take(rest);
  }

  /// How often nothing was known at a decision instant.
  std::uint32_t late_decisions() const noexcept { return sequence_.late_decisions(); }

 protected:
  /// `start`: where the axes stand, m, rad. `law`: not used before the first call. Takes memory;
  /// nothing else here does.
  SegmentGenerator(const RobotModel& robot, LookAheadBuffer& buffer, PathLaw& law,
                   const JointVector& start);

  // For the law.
  UnderWay& now() noexcept { return now_; }
  EventQueue& events() noexcept { return events_; }

 private:
  void catch_up(std::int64_t period) noexcept;
  void step(double stamp) noexcept;
  void go_on_to_stamp() noexcept;
  PathOrders orders() const noexcept;
  bool do_watched(WatchedAction& action, WatchAnswer answer) noexcept;
  void end_early(double instant) noexcept;
  bool may_be_handled() const noexcept;
  void begin_handling(WatchedAction& action) noexcept;
  void report_handled() noexcept;
  void report_handling(double time) noexcept;
  void report_held() noexcept;
  MotionState state() const noexcept;
  void publish_decidable() noexcept;
  bool holding() const noexcept { return stopped_ || handler_.has_axes(); }
  bool axes_held() const noexcept { return holding() && sequence_.at_rest_since(); }

  const double period_;
  const std::int64_t most_missed_;
  PathLaw& law_;
  UnderWay now_;
  EventQueue events_;
  WatchList watches_;
  EffectOrder effects_;
  EarlyEnd early_;
  SegmentSequence sequence_;
  HandlerCall handler_;
  std::atomic<std::uint32_t> decidable_{0};
  std::int64_t last_period_ = -1;
  double override_ = 1;
  bool stopped_ = false;  ///< hold() has been asked for
  bool held_reported_ = false;
};

}  // namespace rob::motion
