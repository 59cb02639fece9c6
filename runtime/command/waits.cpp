#include "runtime/command/waits.h"

#include "motion/space/cycle_instant.h"

namespace rob::runtime {

using lang::Reply;

Reply Waits::wait(int line, double seconds) {
  if (!(seconds <= motion::MotionPlanner::kLongest))
    return links_.refuse(words_for_long_wait(seconds));
  return seconds == 0 ? queue_.stop(line) : queue_.dwell_alone(line, seconds);
}

/// A dwell of no length marks in the buffer where the waiting begins, and another where it ends:
/// so the time between belongs to the line that waits. No mark is waited for.
Reply Waits::stand(int line, double& now) {
  if (!standing_) {
    const Reply reply = queue_.dwell(line, 0);
    if (reply != Reply::Done) return reply;
    standing_ = true;
  }
  if (!progress_.has_acted()) return Reply::Later;
  const std::int64_t cycle = links_.channels.cycle.load(std::memory_order_relaxed);
  assumptions_.begin_condition();
  now = motion::cycle_instant(cycle, links_.robot.reference_period);
  return Reply::Done;
}

void Waits::note_read(int line, int signal) {
  if (standing_) return assumptions_.note_read_in_condition(signal);
  assumptions_.note_read(line, signal);
}

Reply Waits::waited(int line) {
  assumptions_.taken_as_met(line);  // also where what is assumed has met it
  const Reply reply = queue_.dwell_alone(line, 0);
  if (reply == Reply::Done) standing_ = false;
  return reply;
}

}  // namespace rob::runtime
