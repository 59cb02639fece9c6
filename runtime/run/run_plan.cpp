#include "runtime/run/run_plan.h"

#include <algorithm>

#include "motion/generate/corner_miss.h"
#include "runtime/words/units.h"

namespace rob::runtime {

RunPlan::RunPlan(const motion::RobotModel& robot, double override_share)
    : robot_(robot), override_share_(std::min(override_share, 1.0)) {}

void RunPlan::add_time(double time, LineTotal& line) {
  line.planned += time;
  duration_ += time;
}

void RunPlan::begin(RunningMotion& motion, double time, LineTotal& line) {
  // After a guarded motion the program goes on when it has ended: nothing is decided before.
  const bool decides = line.count == 1 && !motion.guard.present();
  if (!comes_timed()) {
    if (const auto told = decisions_.find(motion.number); decides && told != decisions_.end())
      line.decides = told->second;
    decisions_.erase(decisions_.begin(), decisions_.upper_bound(motion.number));
    return;
  }
  const double duration = motion.span() / (motion.dwell ? 1 : override_share_);
  motion.ends = time + duration;
  const bool jog = motion.jog->present();
  if (decides) line.decides = motion.ends - (jog ? robot_.reference_period : 0);
  if (jog) return;  // how long it takes to come to rest shows itself
  add_time(duration, line);
}

void RunPlan::take_decision(const motion::MotionEvent& event, const RunningMotion* running,
                            LineTotal* line) {
  if (running == nullptr || running->number != event.number) {
    decisions_[event.number] = event.time;
  } else if (line->count == 1 && !running->guard.present()) {
    line->decides = event.time;
  }
}

void RunPlan::add_stop(const RunningMotion& motion, LineTotal& line) {
  if (motion.cut || motion.ends_at_rest()) return;
  line.exact = true;
  if (comes_timed()) add_time(2 * motion.t_acc / override_share_, line);
}

void RunPlan::change_override(double time, double share, RunningMotion* running, LineTotal* line) {
  const double before = override_share_;
  override_share_ = std::min(share, 1.0);
  if (!comes_timed() || running == nullptr || running->dwell || running->jog->present() ||
      running->cut || running->ends <= time)
    return;
  const double more = (running->ends - time) * (before / override_share_ - 1);
  running->ends += more;
  add_time(more, *line);
  if (line->count == 1 && line->decides.has_value()) *line->decides += more;
}

void RunPlan::add_jog(double duration, LineTotal& line) {
  if (comes_timed()) add_time(duration, line);
}

void RunPlan::add_corner(const RunningMotion& motion, const LoggedSegment* next, LineTotal& line) {
  if (motion.stop || !comes_timed()) return;
  const double miss =
      next == nullptr ? 0
                      : kMillimetresPerMetre * motion::corner_miss(*robot_.kinematics, motion.from,
                                                                   motion, *next, motion.tip);
  add_miss(line, miss);
}

void RunPlan::add_miss(LineTotal& line, double miss) {
  line.miss_planned.raise_to(miss);
  miss_ = std::max(miss_, miss);
}

}  // namespace rob::runtime
