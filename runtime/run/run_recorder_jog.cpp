#include <utility>

#include "runtime/run/run_recorder.h"

/// Member functions of RunRecorder for motions without a target.
namespace rob::runtime {

/// The next thing that is programmed: a further point, or rates.
void RunRecorder::programmed(const LoggedSegment& planned) {
  if (planned.jog->present()) return path_.unprogrammed(planned.tip);
  if (path_.is_unprogrammed() && last_) reached_ = last_->sample.reference.q;
  from_ = std::exchange(reached_, planned.target);
  meter_.watch(planned.number, planned.target, planned.tip);
  if (!comes_timed()) references_.watch(planned.number, planned.target, planned.tip);
  const bool on_line = planned.leg != nullptr && planned.leg->line.has_value();
  path_.programmed({planned.path, from_, planned.target, planned.duration}, on_line, planned.tip);
}

/// One that has come to rest where nothing follows.
void RunRecorder::end_jog(double time) {
  if (!running_ || !running_->jog->present()) return;
  running_->cut = true;
  end_segment(time, nullptr);
}

void RunRecorder::stop_jog(const motion::MotionEvent& event) {
  add_event(event.time, "limit", static_cast<int>(event.tag),
            text_for_stopped_jog(event.axis, robot_));
}

}  // namespace rob::runtime
