// A robot after a gap that cannot be made up: nobody has looked after the machine, so what follows
// begins where it is found (docs/faults.md, rows 16 and 38).
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "tests/support/stepped_run.h"

using rob::motion::DriverStatus;
using rob::motion::JointReference;
using rob::motion::JointVector;
using rob::runtime::RunResult;
using rob::runtime::Snapshot;
using rob::test::kPublishedProgram;
using rob::test::SteppedRun;

namespace {

constexpr double kGapPeriod = 0.01;
constexpr std::int64_t kGapAt = 400;  // at 4 s x goes at 20 mm/s
constexpr double kV = 0.020;          // m/s
constexpr double kA = 0.100;          // m/s²

/// A run in which one or both ticks do not come for a while.
RunResult run_with_gap(SteppedRun& run, std::int64_t missed, bool servo_too = true) {
  run.task.step(1'000'000);
  run.controller.servo().enable(0);
  for (std::int64_t cycle = 0; !run.controller.motion().over() && cycle < 5000; ++cycle) {
    const bool gone = cycle > kGapAt && cycle <= kGapAt + missed;
    if (!gone || !servo_too) run.controller.servo().cycle(static_cast<double>(cycle) * kGapPeriod);
    if (!gone) run.controller.motion().cycle(cycle, 0);
    run.recorder.drain();
  }
  return run.recorder.finish();
}

std::vector<Snapshot> rows_after(const SteppedRun& run, double time) {
  std::vector<Snapshot> rows;
  std::ranges::copy_if(run.rows, std::back_inserter(rows),
                       [&](const Snapshot& row) { return row.sample.reference.time > time; });
  REQUIRE_FALSE(rows.empty());
  return rows;
}

/// A machine that goes on by itself while nobody tells it anything: x with its speed, until `rests`
/// s after the last command, where it stands. Its answers are `stale` cycles old after the gap.
class Lonely final : public rob::motion::ServoBackend {
 public:
  struct Ways {
    double rests = 1e9;
    int stale = 0;
  };
  Lonely(const Ways& ways, std::vector<JointReference>& told) : ways_(ways), told_(told) {
    state_.measured.q = rob::motion::embedded_robot("gantry").start;
    state_.measured.qd.setZero(3);
  }

  int axes() const noexcept override { return 3; }
  void open() override {}
  void close() noexcept override {}
  DriverStatus enable(double) noexcept override { return {}; }
  void disable(double) noexcept override {}
  bool follows_references() const noexcept override { return true; }

  DriverStatus read(double now, rob::motion::ServoState& state) noexcept override {
    if (now - read_ > 0.1) left_ = ways_.stale;
    move(now);
    read_ = now;
    if (left_ > 0) {
      --left_;
      return DriverStatus::Ok;  // what it said last
    }
    state_.measured.time = state_.seen = now;
    state = state_;
    return DriverStatus::Ok;
  }
  DriverStatus write(double now, const rob::motion::ServoCommand& command) noexcept override {
    told_.push_back(command.reference);
    last_ = now;
    at_ = command.reference.time;
    state_.measured.q = command.reference.q;
    state_.measured.qd = command.reference.qd;
    return DriverStatus::Ok;
  }

 private:
  void move(double now) noexcept {
    const double until = std::min(now, last_ + ways_.rests);
    if (until > at_) state_.measured.q += state_.measured.qd * (until - at_);
    if (now > last_ + ways_.rests) state_.measured.qd.setZero();
    at_ = std::max(at_, now);
  }

  Ways ways_;
  std::vector<JointReference>& told_;
  rob::motion::ServoState state_;
  double read_ = 0;
  double last_ = 0;
  double at_ = 0;
  int left_ = 0;
};

struct LonelyRun {
  std::vector<JointReference> told;
  SteppedRun run;
  RunResult result;
  std::vector<JointReference> after;  // of what it was told behind the gap

  explicit LonelyRun(const Lonely::Ways& ways)
      : run(kPublishedProgram, std::make_unique<Lonely>(ways, told)),
        result(run_with_gap(run, 100)) {
    std::ranges::copy_if(told, std::back_inserter(after), [](const JointReference& reference) {
      return reference.time > static_cast<double>(kGapAt + 100) * kGapPeriod;
    });
  }
};

/// 100 mm along x on a machine that stays at its last reference, while both ticks do not come for
/// 60 ms of each 150 ms, so often. Where the machine was told to be in the end, m.
struct OftenLate {
  std::vector<JointReference> told;
  SteppedRun run;
  RunResult result;

  explicit OftenLate(int gaps)
      : run("MOVE(100,0,0)\n", std::make_unique<Lonely>(Lonely::Ways{.rests = 0}, told)) {
    run.task.step(1'000'000);
    run.controller.servo().enable(0);
    for (std::int64_t cycle = 0; !run.controller.motion().over() && cycle < 5000; ++cycle) {
      const std::int64_t since = cycle - 200;  // at 2 s x goes at 20 mm/s
      const bool gone = since >= 0 && since / 15 < gaps && since % 15 < 6;
      if (gone) continue;
      run.controller.servo().cycle(static_cast<double>(cycle) * kGapPeriod);
      run.controller.motion().cycle(cycle, 0);
      run.recorder.drain();
    }
    result = run.recorder.finish();
  }
};

}  // namespace

TEST_CASE("fault 15: a run ends when the machine is back on its references, not before") {
  const OftenLate late(2);
  CAPTURE(late.result.error.value_or(decltype(late.result.error)::value_type{}).message);
  CHECK_FALSE(late.result.error.has_value());
  CHECK(late.told.back().q[0] == doctest::Approx(0.100).epsilon(1e-9));
  // 2·60 ms at 20 mm/s are caught up at a tenth of that: the program itself takes 7.75 s.
  CHECK(late.run.rows.back().measured[0] == doctest::Approx(0.100).epsilon(1e-6));
}

TEST_CASE("fault 16: a computer that is late so often that the machine falls behind stops") {
  const OftenLate late(20);
  REQUIRE(late.result.error.has_value());
  CHECK(late.result.error->code == "E501");
  // 210 ms at 20 mm/s, twice v²/a, and at most another gap: 70 ms and its v²/a
  for (const Snapshot& row : late.run.rows)
    CHECK(row.sample.reference.q[0] - row.measured[0] < 0.280 * kV + 3 * kV * kV / kA);
}

TEST_CASE("fault 38: axes that their drives have braked stay there, and the references with them") {
  SteppedRun run(kPublishedProgram);
  const RunResult result = run_with_gap(run, 100);
  REQUIRE(result.error.has_value());
  CHECK(result.error->code == "E501");
  const std::vector<Snapshot> rows =
      rows_after(run, static_cast<double>(kGapAt + 101) * kGapPeriod);
  // The drives' watchdog braked 0.25 s after the last command, and took its way.
  const Snapshot& before = *(std::ranges::find_if(run.rows,
                                                  [&](const Snapshot& row) {
                                                    return row.sample.reference.time ==
                                                           rows.front().sample.reference.time;
                                                  }) -
                             1);
  const double stands = rows.back().measured[0];
  const double way = 0.25 * before.sample.reference.qd[0];
  CHECK(stands - before.measured[0] == doctest::Approx(way).epsilon(0.1));
  for (const Snapshot& row : rows) {
    CHECK(std::abs(row.measured[0] - stands) < 5e-6);
    CHECK(std::abs(row.sample.reference.q[0] - stands) < 5e-6);
    CHECK(std::abs(row.sample.reference.qd[0]) < 1e-6);
  }
}

TEST_CASE("fault 38: a machine that stands after the gap is told to stay where it stands") {
  const LonelyRun lonely({.rests = 0.1});
  CHECK(lonely.result.error->code == "E501");
  REQUIRE_FALSE(lonely.after.empty());
  const double stands = lonely.after.front().q[0];
  for (const JointReference& reference : lonely.after) {
    CHECK(reference.q[0] == stands);
    CHECK(reference.qd[0] == 0);
  }
  // 4 s of the program, and 0.1 s at its speed
  CHECK(lonely.run.rows.back().sample.reference.q[0] == doctest::Approx(stands));
}

TEST_CASE("fault 38: one that moves after the gap is braked from there, with the speed it has") {
  const LonelyRun lonely({});
  CHECK(lonely.result.error->code == "E501");
  REQUIRE_FALSE(lonely.after.empty());
  const JointReference& first = lonely.after.front();
  CHECK(first.qd[0] == doctest::Approx(kV).epsilon(0.1));
  JointReference before = first;
  for (const JointReference& reference : lonely.after) {
    const double dt = reference.time - before.time;
    CHECK(reference.qd[0] <= before.qd[0] + 1e-12);
    CHECK(before.qd[0] - reference.qd[0] <= kA * dt + 1e-9);
    CHECK(reference.q[0] - before.q[0] <= before.qd[0] * dt + 1e-12);
    CHECK(reference.q[0] >= before.q[0]);
    before = reference;
  }
  CHECK(before.qd[0] == 0);
  // v²/2a beyond where it was found
  CHECK(before.q[0] - first.q[0] == doctest::Approx(kV * kV / (2 * kA)).epsilon(0.1));
}

TEST_CASE("fault 38: nothing is told to a machine before it has said where it is") {
  const LonelyRun lonely({.rests = 0.1, .stale = 7});
  CHECK(lonely.result.error->code == "E501");
  REQUIRE_FALSE(lonely.after.empty());
  const double gap_end = static_cast<double>(kGapAt + 101) * kGapPeriod;
  CHECK(lonely.after.front().time >= gap_end + 7 * kGapPeriod - 1e-9);
  for (const JointReference& reference : lonely.after)
    CHECK(reference.q[0] == lonely.after.front().q[0]);
}

TEST_CASE(
    "fault 16: where the generator alone was late the hold begins where the servo has gone on") {
  SteppedRun run(kPublishedProgram);
  const RunResult result = run_with_gap(run, 100, false);
  REQUIRE(result.error.has_value());
  CHECK(result.error->code == "E501");
  const std::vector<Snapshot> rows =
      rows_after(run, static_cast<double>(kGapAt + 101) * kGapPeriod);
  // It went on for three periods and braked: no axis is led back.
  double farthest = 0;
  for (const Snapshot& row : rows) {
    CHECK(row.measured[0] > farthest - 5e-6);
    farthest = std::max(farthest, row.measured[0]);
  }
  CHECK(std::abs(rows.back().sample.reference.q[0] - rows.back().measured[0]) < 2e-5);
}
