#include <doctest/doctest.h>

#include <cmath>

#include "motion/robots/robot_library.h"
#include "runtime/run/run_recorder.h"

using namespace rob;
using motion::MotionEvent;

namespace {

/// What comes up the channels of a gantry, written by hand: two legs with a corner between, along x
/// to 100 mm and then along y.
struct Told {
  motion::RobotModel robot = motion::embedded_robot("gantry");
  runtime::Channels channels;
  runtime::ProgramLog log;

  explicit Told(motion::Law law) { robot.law = law; }

  void planned(std::uint32_t number, int line, double x, double y, double duration,
               bool stop = false) {
    runtime::LoggedSegment segment;
    segment.tag = static_cast<motion::Tag>(line);
    segment.number = number;
    segment.target = Eigen::Vector3d(x, y, 0);
    segment.duration = duration;
    segment.no_length = segment.stop = stop;
    log.planned(segment);
  }
  void event(MotionEvent::Kind kind, double time, std::uint32_t number, int line) {
    channels.events.push(
        {.kind = kind, .time = time, .tag = static_cast<motion::Tag>(line), .number = number});
  }
  /// A row of the run: the reference, and 0.1 mm beside it in y what was measured.
  void row(double time, double x, double y) {
    runtime::Snapshot snapshot;
    const Eigen::Vector3d q(x, y, 0);
    const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
    snapshot.sample.reference = {time, q, zero, zero};
    snapshot.measured = q + Eigen::Vector3d(0, 1e-4, 0);
    snapshot.drive = zero;
    channels.snapshots.push(snapshot);
  }

  runtime::RunResult result() {
    using Kind = MotionEvent::Kind;
    planned(1, 1, 0.1, 0, 5);
    planned(2, 2, 0.1, 0.1, 5);
    planned(3, 3, 0.1, 0.1, 0, true);
    runtime::RunRecorder recorder(robot, 1, channels, log, {robot, {}}, {});
    event(Kind::SegmentStarted, 0, 1, 1);
    row(0, 0, 0);
    if (robot.law == motion::Law::LookAhead) {
      event(Kind::DecisionPoint, 4, 1, 1);
      event(Kind::DecisionPoint, 4.9, 2, 2);  // before it begins
    }
    row(4.9, 0.098, 0);
    event(Kind::SegmentStarted, 5, 2, 2);
    row(5.1, 0.1, 0.002);
    row(10, 0.1, 0.1);
    event(Kind::SegmentStarted, 10.2, 3, 3);
    row(10.3, 0.1, 0.1);
    event(Kind::Finished, 10.3, 3, 3);
    recorder.drain();
    return recorder.finish();
  }
};

}  // namespace

TEST_CASE(
    "under the look-ahead law decision points are what motion tells, also before a line begins") {
  const runtime::RunResult result = Told(motion::Law::LookAhead).result();
  CHECK(result.law == "lookahead");
  REQUIRE(result.lines.size() == 3);
  CHECK(result.lines[0].decides == 4.0);
  CHECK(result.lines[1].decides == 4.9);
  CHECK(result.lines[1].starts == 5);
  CHECK(result.lines[0].planned == 0);  // nothing was foretold here
  CHECK(result.planned == 0);
  CHECK(result.lines[0].measured == 5);
}

TEST_CASE("under the look-ahead law a corner is planned to miss by what the references miss") {
  const runtime::RunResult result = Told(motion::Law::LookAhead).result();
  // From (98, 0) straight to (100, 2): the distance of (100, 0) mm is √2 mm.
  REQUIRE(result.lines[0].miss_planned.has_value());
  CHECK(*result.lines[0].miss_planned == doctest::Approx(std::sqrt(2)));
  // Measured from (98, 0.1) to (100, 2.1).
  CHECK(*result.lines[0].miss_measured == doctest::Approx(2.1 / std::sqrt(2)));
  CHECK(*result.lines[1].miss_planned < 1e-12);
  CHECK(result.lines[1].exact);
  CHECK_FALSE(result.lines[2].miss_planned.has_value());
  CHECK(result.deviation >= std::sqrt(2) * (1 - 1e-12));
}

TEST_CASE("under Paul's law what is planned comes with the motions") {
  const runtime::RunResult result = Told(motion::Law::Paul).result();
  CHECK(result.law == "paul");
  CHECK(result.lines[0].decides == 5.0);
  CHECK(result.lines[0].planned == 5);
  CHECK(result.planned == 10);
}
