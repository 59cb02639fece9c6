#include <algorithm>
#include <optional>

#include "motion/generate/corner_miss.h"
#include "runtime/run/run_recorder.h"
#include "runtime/words/units.h"

/// Member functions of RunRecorder for the planned motions. Under Paul's law a motion is queued
/// with its time. Under the look-ahead law the times come with the whole path: the plan is what was
/// foretold of the run (run.cpp), the miss at a corner is that of the references, and motion itself
/// reports when its decision points come.
namespace rob::runtime {

using motion::MotionEvent;

void RunRecorder::plan(const LoggedSegment& planned, const MotionEvent& event, LineTotal& line) {
  // After a guarded motion the program goes on when it has ended: nothing is decided before.
  const bool decides = line.count == 1 && !planned.guard.present();
  if (!comes_timed()) {
    if (const auto told = decisions_.find(planned.number); decides && told != decisions_.end())
      line.decides = told->second;
    decisions_.erase(decisions_.begin(), decisions_.upper_bound(planned.number));
    return;
  }
  const double duration = planned.span() / (planned.dwell ? 1 : override_share_);
  running_->ends = event.time + duration;
  const bool jog = planned.jog->present();
  if (decides) line.decides = running_->ends - (jog ? robot_.reference_period : 0);
  if (jog) return;  // how long it takes to come to rest shows itself
  line.planned += duration;
  result_.planned += duration;
}

/// It may come before the motion begins.
void RunRecorder::take_decision(const MotionEvent& event) {
  if (!running_ || running_->number != event.number) {
    decisions_[event.number] = event.time;
    return;
  }
  LineTotal& line = line_of(*running_);
  if (line.count == 1 && !running_->guard.present()) line.decides = event.time;
}

/// The running motion has been made exact for the next one, which begins at rest.
void RunRecorder::count_stop() {
  if (!running_ || running_->cut || running_->ends_at_rest()) return;
  LineTotal& line = line_of(*running_);
  line.exact = true;
  if (!comes_timed()) return;
  const double duration = 2 * running_->t_acc / override_share_;
  line.planned += duration;
  result_.planned += duration;
}

/// The rest of the running motion takes longer, or less, than was foretold when it began.
void RunRecorder::change_override(double time, double share) {
  const double before = override_share_;
  override_share_ = std::min(share, 1.0);
  if (!comes_timed() || !running_ || running_->dwell || running_->jog->present() || running_->cut ||
      running_->ends <= time)
    return;
  const double more = (running_->ends - time) * (before / override_share_ - 1);
  running_->ends += more;
  LineTotal& line = line_of(*running_);
  line.planned += more;
  result_.planned += more;
  if (line.count == 1 && line.decides.has_value()) *line.decides += more;
}

/// The references are all that there is of the plan of a jog.
void RunRecorder::plan_jog(double duration) {
  if (comes_timed()) {
    line_of(*running_).planned += duration;
    result_.planned += duration;
  }
  running_->cut = true;
}

void RunRecorder::plan_corner(const LoggedSegment* next) {
  if (running_->stop || !comes_timed()) return;
  const double miss = next == nullptr ? 0
                                      : kMillimetresPerMetre *
                                            motion::corner_miss(*robot_.kinematics, running_->from,
                                                                *running_, *next, running_->tip);
  add_planned_miss(line_of(*running_), miss);
}

void RunRecorder::add_planned_miss(LineTotal& line, double miss) {
  line.miss_planned.raise_to(miss);
  result_.deviation = std::max(result_.deviation, miss);
}

}  // namespace rob::runtime
