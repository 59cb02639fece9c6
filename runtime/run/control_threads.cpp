#include "runtime/run/control_threads.h"

#include "motion/space/cycle_instant.h"
#include "runtime/time/real_time.h"

namespace rob::runtime {

namespace {}  // namespace

ControlThreads::ControlThreads(Controller& controller)
    : controller_(controller),
      line_(controller.watches_jogs() ? 4 : 3),
      servo_(
          clock_, controller.robot().servo_period, kServoPriority,
          [this](std::int64_t number, double, double) {
            controller_.servo().cycle(
                clock_, motion::cycle_instant(number, controller_.robot().servo_period));
            return !stopping_.load(std::memory_order_relaxed);
          },
          &line_),
      motion_(
          clock_, controller.robot().reference_period, kMotionPriority,
          [this](std::int64_t number, double now, double lateness) {
            if (!first_) first_ = now;
            drift_ =
                now - *first_ - motion::cycle_instant(number, controller_.robot().reference_period);
            controller_.motion().cycle(number, lateness);
            return !controller_.motion().over();
          },
          &line_),
      path_(
          clock_, kPlanningPeriod, kPathPriority,
          [this](std::int64_t, double, double) {
            controller_.plan_path();
            return !stopping_.load(std::memory_order_relaxed);
          },
          &line_) {
  if (controller.watches_jogs())
    jogs_.emplace(
        clock_, controller.robot().reference_period, kPathPriority,
        [this](std::int64_t, double, double) {
          controller_.watch_jogs();
          return !stopping_.load(std::memory_order_relaxed);
        },
        &line_);
  line_.wait_until_ready();
}

void ControlThreads::begin() {
  clock_ = SystemClock(kThreadLead);
  begun_ = true;
  line_.go();
}

ControlThreads::~ControlThreads() {
  if (!begun_) return;  // the tasks end at the line
  controller_.request_hold();
  finish();
}

Timing ControlThreads::finish() {
  motion_.join();
  stopping_ = true;
  path_.join();
  if (jogs_) jogs_->join();
  servo_.join();
  return {motion_.punctuality().missed, motion_.punctuality().worst_lateness, drift_, false};
}

}  // namespace rob::runtime
