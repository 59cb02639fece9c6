#include <doctest/doctest.h>

#include <atomic>
#include <chrono>
#include <thread>
#include <vector>

#include "runtime/time/clock.h"
#include "runtime/time/periodic_task.h"

using rob::runtime::Clock;
using rob::runtime::PeriodicSchedule;
using rob::runtime::PeriodicTask;
using rob::runtime::StartLine;
using rob::runtime::SystemClock;
using rob::runtime::VirtualClock;

namespace {

/// A clock whose sleeper wakes up late by what the test says, one entry a wait.
class LateClock final : public Clock {
 public:
  explicit LateClock(std::vector<double> lateness) : lateness_(std::move(lateness)) {}

  double now() const noexcept override { return now_; }
  void sleep_until(double time) noexcept override {
    if (time > now_) now_ = time;
    if (wake_ < lateness_.size()) now_ += lateness_[wake_++];
  }
  void work(double seconds) { now_ += seconds; }

 private:
  std::vector<double> lateness_;
  std::size_t wake_ = 0;
  double now_ = 0;
};

}  // namespace

TEST_CASE("work inside a cycle is covered by the period, not added to it") {
  LateClock clock({});
  PeriodicSchedule schedule(0.010);
  for (int k = 0; k < 1000; ++k) {
    CHECK(schedule.wait(clock) == k);
    clock.work(0.009);
  }
  // The 1000th cycle began at 9.990 s; with relative timers it would have been 18.981 s.
  CHECK(clock.now() == doctest::Approx(9.999));
  CHECK(schedule.punctuality().missed == 0);
}

TEST_CASE("a wake-up late by less than a period is its own cycle, and its lateness is known") {
  LateClock clock({0.0, 0.004, 0.0});
  PeriodicSchedule schedule(0.010);
  CHECK(schedule.wait(clock) == 0);
  CHECK(schedule.wait(clock) == 1);
  CHECK(schedule.lateness() == doctest::Approx(0.004));
  CHECK(schedule.wait(clock) == 2);
  CHECK(schedule.lateness() == doctest::Approx(0.0));
  CHECK(schedule.punctuality().missed == 0);
  CHECK(schedule.punctuality().worst_lateness == doctest::Approx(0.004));
}

TEST_CASE("missed periods are skipped and counted, never made up by a burst") {
  LateClock clock({0.0, 0.035, 0.0, 0.0});
  PeriodicSchedule schedule(0.010);
  CHECK(schedule.wait(clock) == 0);
  CHECK(schedule.wait(clock) == 4);  // deadline 1 at 0.010, woken at 0.045
  CHECK(schedule.wait(clock) == 5);
  CHECK(clock.now() == doctest::Approx(0.050));
  CHECK(schedule.punctuality().missed == 3);
  CHECK(schedule.punctuality().cycles == 3);
  CHECK(schedule.punctuality().worst_lateness == doctest::Approx(0.035));
}

TEST_CASE("virtual time passes only when somebody waits, and never goes back") {
  VirtualClock clock;
  CHECK(clock.now() == 0.0);
  clock.sleep_until(2.5);
  CHECK(clock.now() == 2.5);
  clock.sleep_until(1.0);
  CHECK(clock.now() == 2.5);
}

TEST_CASE("the system clock starts before zero by its lead and never wakes a sleeper early") {
  SystemClock clock(0.05);
  CHECK(clock.now() < 0.0);
  for (const double time : {0.0, 0.0015, 0.0131}) {
    clock.sleep_until(time);
    CHECK(clock.now() >= time - 1e-9);
  }
}

TEST_CASE(
    "a task that waits at the start line begins with the first period of the clock set there") {
  using namespace std::chrono_literals;
  SystemClock clock;
  StartLine line(1);
  std::atomic<std::int64_t> first{-1};
  PeriodicTask task(
      clock, 0.001, 1,
      [&](std::int64_t number, double, double) {
        first = number;
        return false;
      },
      &line);
  line.wait_until_ready();
  std::this_thread::sleep_for(20ms);  // 20 of its periods, if it did not wait
  CHECK(first == -1);
  clock = SystemClock(0.5);
  line.go();
  task.join();
  CHECK(first >= 0);
  CHECK(first <= 500);  // by the clock set last: half a second of stall is room enough
}

TEST_CASE("a task that still waits at the start line can be ended") {
  SystemClock clock;
  StartLine line(2);
  bool ran = false;
  {
    PeriodicTask task(
        clock, 1, 1, [&](std::int64_t, double, double) { return ran = true; }, &line);
  }
  CHECK_FALSE(ran);
}
