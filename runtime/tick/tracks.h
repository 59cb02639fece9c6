#pragma once

#include <array>
#include <cstdint>

#include "motion/generate/trajectory_generator.h"
#include "runtime/tick/channels.h"

namespace rob::runtime {

/// One generator, and whom it reports to.
struct Track {
  motion::TrajectoryGenerator& generator;
  MotionProgress& progress;
  motion::GeneratorSample current{};  ///< handed out last, measured when its stamp has come
  /// Events are computed up to a period ahead and wait here for their instant.
  motion::SpscRing<motion::MotionEvent> pending{Channels::kEvents};
};

/// The motions of the program and those of the handlers of its WHENs. One of the two has the axes:
/// a handler gets them at rest, and gives them back. Every call but the constructor may be used in
/// the tick; `now`: of the current cycle, s.
class Tracks {
 public:
  Tracks(motion::TrajectoryGenerator& program, motion::TrajectoryGenerator& handlers,
         Channels& channels, const motion::JointVector& start);

  Track& program() noexcept { return program_; }
  const Track& program() const noexcept { return program_; }
  std::array<Track*, 2> both() noexcept { return {&program_, &handlers_}; }
  /// The one that has the axes.
  Track& active() noexcept { return *active_; }
  const Track& active() const noexcept { return *active_; }
  bool handling() const noexcept { return active_ == &handlers_; }
  bool is_handlers(const Track& track) const noexcept { return &track == &handlers_; }
  /// Handed out last.
  const motion::JointReference& reference() const noexcept { return active_->current.reference; }

  void look(const motion::CycleView& seen) noexcept;
  void advance(std::int64_t number) noexcept;
  void hold() noexcept;
  void resume() noexcept;
  void set_override(double share) noexcept;

  /// The track whose event is due first, at `until` at the latest; null if there is none.
  Track* next_due(double until) noexcept;
  /// How a motion of `track` has ended; `barred`: no handler may begin.
  void hand_over_rest(Track& track, const motion::MotionEvent& event, double now,
                      bool barred) noexcept;
  /// The program's decision about the motion that a handler interrupted. `q`: where the axes
  /// are on their path.
  void take_after_handler(const motion::JointVector& q, double now, bool barred) noexcept;

  void report_settled() noexcept;
  void report_progress() noexcept;

 private:
  void begin_handler(const motion::Rest& rest, double now, bool barred) noexcept;

  Channels& channels_;
  Track program_;
  Track handlers_;
  Track* active_ = &program_;
};

}  // namespace rob::runtime
