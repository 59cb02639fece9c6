#include <utility>

#include "runtime/run/run_recorder.h"

/// Member functions of RunRecorder for the handlers of WHEN.
namespace rob::runtime {

using motion::MotionEvent;

void RunRecorder::begin_handler(const MotionEvent& event) {
  add_event(event.time, "when", static_cast<int>(event.tag), "its handler begins");
  interrupted_.emplace(Interrupted{event.time, static_cast<int>(event.tag),
                                   std::exchange(running_, std::nullopt),
                                   std::exchange(behind_, std::nullopt), reached_, path_});
  if (last_) reached_ = last_->sample.reference.q;
}

/// The interrupted motion goes on as though no time had passed, or has come to its end.
void RunRecorder::end_handler(const MotionEvent& event) {
  if (!interrupted_) return;
  const bool left = event.value != 0;
  end_segment(event.time, nullptr);
  end_corner();
  add_event(event.time, "when", interrupted_->line,
            left ? "its handler has ended the motion" : "its handler ends");
  running_ = interrupted_->running;
  behind_ = interrupted_->behind;
  const double pause = event.time - interrupted_->time;
  if (running_) {
    running_->started += pause;
    running_->ends += pause;
    running_->cut = left;
    if (left) line_of(*running_).ended = LineTotal::Ended::Brake;
  }
  if (!left) {
    reached_ = interrupted_->reached;
    path_ = interrupted_->path;
  } else if (last_) {
    reached_ = last_->sample.reference.q;
  }
  interrupted_.reset();
}

}  // namespace rob::runtime
