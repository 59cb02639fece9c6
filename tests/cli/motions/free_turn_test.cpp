// NEAR and FREE from outside: the joints of the trace, through Denavit and Hartenberg's tables of
// the makers, bring the tip where the program says, and the tool leans as it says.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "tests/support/rob_command.h"
#include "tests/support/trace_file.h"

using Eigen::Isometry3d;
using Eigen::Vector3d;
using nlohmann::json;
using rob::test::contains;
using rob::test::ProcessResult;
using rob::test::RobCommand;
using rob::test::TraceRow;

namespace {

constexpr double kRadOfDeg = 3.14159265358979323846 / 180;

Isometry3d turned_by(const Vector3d& axis, double degrees) {
  return Isometry3d(Eigen::AngleAxisd(degrees * kRadOfDeg, axis));
}
Isometry3d shifted(double x, double z) { return Isometry3d(Eigen::Translation3d(x, 0, z)); }

/// A line of the table: mm and deg.
struct DhLink {
  double a, alpha, d, offset;
};

/// An arm as its maker describes it.
struct MakersArm {
  std::string robot;
  bool craig;  ///< a and alpha belong to the axis before
  std::vector<DhLink> links;
  double flange;                ///< mm along the last z
  std::vector<double> fastest;  ///< deg/s

  Isometry3d at(const std::vector<double>& q) const {
    Isometry3d pose = Isometry3d::Identity();
    for (std::size_t i = 0; i < links.size(); ++i) {
      const DhLink& link = links[i];
      const Isometry3d along =
          turned_by(Vector3d::UnitZ(), q[i] + link.offset) * shifted(0, link.d);
      const Isometry3d across = shifted(link.a, 0) * turned_by(Vector3d::UnitX(), link.alpha);
      pose = craig ? pose * across * along : pose * along * across;
    }
    return pose * shifted(0, flange);
  }
};

const MakersArm kUr5e{"ur5e",
                      false,
                      {{0, 90, 162.5, 0},
                       {-425, 0, 0, 0},
                       {-392.2, 0, 0, 0},
                       {0, 90, 133.3, 0},
                       {0, -90, 99.7, 0},
                       {0, 0, 99.6, 0}},
                      0,
                      std::vector<double>(6, 180)};
const MakersArm kLwa4p{"lwa4p",
                       false,
                       {{0, -90, 205, 0},
                        {350, 180, 0, -90},
                        {0, -90, 0, -90},
                        {0, 90, 305, 0},
                        {0, -90, 0, 0},
                        {0, 0, 75, 0}},
                       0,
                       {72, 72, 72, 120, 120, 120}};
const MakersArm kFr3{"fr3",
                     true,
                     {{0, 0, 333, 0},
                      {0, -90, 0, 0},
                      {0, 90, 316, 0},
                      {82.5, 90, 0, 0},
                      {-82.5, -90, 384, 0},
                      {0, 90, 0, 0},
                      {88, 90, 0, 0}},
                     107,
                     {2.62 / kRadOfDeg, 2.62 / kRadOfDeg, 2.62 / kRadOfDeg, 2.62 / kRadOfDeg,
                      5.26 / kRadOfDeg, 4.18 / kRadOfDeg, 5.26 / kRadOfDeg}};

/// mm and deg, as POSE takes them.
struct FreeTarget {
  double x, y, z, a, b, c;

  std::string text() const {
    const auto mm = [](double value) { return std::to_string(value) + "mm, "; };
    const auto deg = [](double value) { return std::to_string(value) + "deg"; };
    return "POSE(" + mm(x) + mm(y) + mm(z) + deg(a) + ", " + deg(b) + ", " + deg(c) + ")";
  }
  Vector3d place() const { return {x, y, z}; }
  Eigen::Matrix3d orientation() const {
    return (turned_by(Vector3d::UnitZ(), c) * turned_by(Vector3d::UnitY(), b) *
            turned_by(Vector3d::UnitX(), a))
        .linear();
  }
};

/// The tip beside the axis of the last joint: a turn about the tool moves the flange.
const Vector3d kPenTip{10, -5, 120};
const std::string kPenLine = "TOOL pen = POSE(10mm, -5mm, 120mm, 0deg, 0deg, 0deg)\n";

struct FreeRun {
  json report;
  std::vector<TraceRow> rows;  ///< of the last line that moves
};

FreeRun run_free(const std::string& text, const std::vector<std::string>& more = {}) {
  const RobCommand rob(text);
  std::vector<std::string> arguments{"--fast", "--json", "--trace", rob.file("t.csv")};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const ProcessResult result = rob("run", arguments);
  REQUIRE_MESSAGE(result.exit_code == 0, result.err, result.out);
  FreeRun made{json::parse(result.out), {}};
  made.rows = rob::test::parse_trace(rob::test::read_whole_file(rob.file("t.csv"))).rows;
  int last = 0;
  for (const TraceRow& row : made.rows) last = std::max(last, row.line);
  std::erase_if(made.rows, [&](const TraceRow& row) { return row.line != last; });
  REQUIRE(made.rows.size() > 10);
  return made;
}

std::string refused_choice(const std::string& text, const std::vector<std::string>& more = {}) {
  const ProcessResult result = RobCommand(text)("check", more);
  CHECK(result.exit_code == 65);
  return result.err;
}

/// Part of the great circle from one direction to another.
Vector3d along_circle(const Vector3d& from, const Vector3d& to, double share) {
  const double angle = std::atan2(from.cross(to).norm(), from.dot(to));
  if (angle < 1e-9) return from;
  return (std::sin((1 - share) * angle) * from + std::sin(share * angle) * to) / std::sin(angle);
}

/// What of a line's orientation is not free: a direction that goes evenly from end to end.
using KeptAxis = Vector3d (*)(const Eigen::Matrix3d&);
Vector3d tool_axis(const Eigen::Matrix3d& turned) { return turned.col(2); }
Vector3d world_axis(const Eigen::Matrix3d& turned) { return turned.row(2); }

void check_kept_line(const MakersArm& maker, const std::vector<TraceRow>& rows,
                     const FreeTarget& from, const FreeTarget& to, KeptAxis kept) {
  const Vector3d way = to.place() - from.place();
  const Vector3d first = kept(from.orientation());
  const Vector3d last = kept(to.orientation());
  double off = 0;
  double leaning = 0;
  double spent = 0;  // of the speed of an axis
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const Isometry3d flange = maker.at(rows[k].q);
    const Vector3d tip = flange * kPenTip;
    const double share = way.dot(tip - from.place()) / way.squaredNorm();
    off = std::max(off, (tip - from.place() - share * way).norm());
    leaning = std::max(leaning, (kept(flange.linear()) - along_circle(first, last, share)).norm());
    if (k == 0) continue;
    for (std::size_t i = 0; i < maker.fastest.size(); ++i) {
      const double speed = std::abs(rows[k].q[i] - rows[k - 1].q[i]) / (rows[k].t - rows[k - 1].t);
      spent = std::max(spent, speed / maker.fastest[i]);
    }
  }
  CHECK(off < 1e-3);
  CHECK(leaning < 1e-4);
  CHECK(spent < 1.005);
  CHECK((maker.at(rows.back().q) * kPenTip - to.place()).norm() < 0.01);
}

void check_free_line(const MakersArm& maker, const std::string& free, const FreeTarget& from,
                     const FreeTarget& to, KeptAxis kept) {
  CAPTURE(maker.robot);
  CAPTURE(free);
  const FreeRun made = run_free("ROBOT \"" + maker.robot + "\"\nLAW LOOKAHEAD\n" + kPenLine +
                                "WITH pen AT 200mm/s DO\nMOVE " + from.text() + " FREE " + free +
                                " FINE\nMOVEL " + to.text() + " FREE " + free + " FINE\nENDWITH\n");
  check_kept_line(maker, made.rows, from, to, kept);
}

}  // namespace

TEST_CASE("with FREE SPIN the tip keeps its line and the tool leans as it is programmed") {
  const FreeTarget down{420, -30, 150, 180, 0, 0};
  const FreeTarget aside{400, 40, 160, 170, 10, 123};
  for (const MakersArm* maker : {&kUr5e, &kFr3})
    check_free_line(*maker, "SPIN", down, aside, tool_axis);
  check_free_line(kLwa4p, "SPIN", {300, -30, 250, 180, 0, 0}, {320, 30, 260, 170, 10, 200},
                  tool_axis);
}

TEST_CASE("with FREE c the tool turns about z of the world, and keeps its lean") {
  const FreeTarget from{420, -30, 150, 160, 10, 0};
  const FreeTarget to{400, 40, 160, 170, 15, 170};
  for (const MakersArm* maker : {&kUr5e, &kFr3}) check_free_line(*maker, "c", from, to, world_axis);
  check_free_line(kLwa4p, "c", {300, -30, 250, 170, 0, 0}, {320, 30, 260, 165, 10, 200},
                  world_axis);
}

TEST_CASE("what is free means nothing in a target: the joints are the same whatever it says") {
  const auto last = [](const std::string& c) {
    return run_free("ROBOT \"ur5e\"\nMOVE POSE(400mm, -200mm, 200mm, 180deg, 0deg, " + c +
                    ") FREE SPIN FINE\nMOVEL POSE(400mm, -150mm, 200mm, 180deg, 0deg, " + c +
                    ") FREE SPIN FINE\n")
        .rows.back()
        .q;
  };
  const auto one = last("0deg");
  const auto other = last("77deg");
  for (std::size_t i = 0; i < one.size(); ++i)
    CHECK(one[i] == doctest::Approx(other[i]).epsilon(1e-9));
}

TEST_CASE("what no turn as written can reach is reached with the turn left open") {
  // The tip is 80 mm beside axis 6, the place so near to axis 1 that the wrist cannot stand on
  // every side of it.
  const auto reached = [](const std::string& free) {
    return RobCommand(
        "ROBOT \"ur5e\"\nTOOL pen = POSE(80mm, 0mm, 100mm, 0deg, 0deg, 0deg)\n"
        "MOVE POSE(190mm, -60mm, 200mm, 180deg, 0deg, 0deg) WITH pen" +
        free + "\nMOVEL BY (0mm, 20mm, 0mm) WITH pen" + free + "\n")("check");
  };
  CHECK(contains(reached("").err, "E333"));
  CHECK(reached(" FREE SPIN").exit_code == 0);
}

TEST_CASE("TARGET after FREE is the pose that is reached") {
  const FreeRun made = run_free(
      "ROBOT \"ur5e\"\nMOVE POSE(400mm, -200mm, 200mm, 180deg, 0deg, 140deg) FREE SPIN FINE\n"
      "PRINT DIST(TARGET, FORWARD(JOINTS())) < 0.001mm, TURN(TARGET, FORWARD(JOINTS())) < "
      "0.001deg\n"
      "PRINT TURN(TARGET, POSE(400mm, -200mm, 200mm, 180deg, 0deg, 140deg)) > 1deg\n");
  CHECK(made.report["output"][0] == "TRUETRUE");
  CHECK(made.report["output"][1] == "TRUE");
}

TEST_CASE("NEAR takes the branch of its joints, wherever the robot stands") {
  // Elbow down, the wrist turned over: not what is nearest to the start.
  const std::string joints = "JOINTS(20deg, -20deg, -100deg, 30deg, 80deg, -150deg)";
  const std::vector<double> wanted{20, -20, -100, 30, 80, -150};
  const auto last = [&](const std::string& clause) {
    return run_free("ROBOT \"ur5e\"\nMOVE FORWARD(" + joints + ") " + clause + " FINE\n")
        .rows.back()
        .q;
  };
  const auto near = last("NEAR " + joints);
  const auto without = last("");
  double apart = 0;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    CHECK(std::abs(near[i] - wanted[i]) < 0.01);
    apart = std::max(apart, std::abs(without[i] - wanted[i]));
  }
  CHECK(apart > 10);
}

TEST_CASE("NEAR on a line names the branch that the robot is in, or the line is refused") {
  const std::string begin = "ROBOT \"ur5e\"\nVAR here = JOINTS()\n";
  const std::string line = "MOVEL BY (0mm, 100mm, -100mm)";
  CHECK(RobCommand(begin + line + " NEAR here\n")("check").exit_code == 0);
  CHECK(RobCommand(begin + line +
                   " NEAR here + JOINTS(5deg, 5deg, 5deg, 5deg, 5deg, 5deg)\n")("check")
            .exit_code == 0);
  const std::string other =
      refused_choice(begin + line + " NEAR JOINTS(0deg, 0deg, -90deg, -90deg, 90deg, 0deg)\n");
  CHECK(contains(other, "E587"));
  CHECK(contains(other, "MOVE p NEAR JOINTS("));
  // The same branch a whole turn of the last axis farther is another one, too.
  CHECK(contains(
      refused_choice(begin + line + " NEAR here + JOINTS(0deg, 0deg, 0deg, 0deg, 0deg, 359deg)\n"),
      "E587"));
}

TEST_CASE("FREE is refused where no axis turns the tool so") {
  const std::string flat = std::string(ROB_SOURCE_DIR) + "/tests/bench/xy.toml";
  for (const std::string free : {"c", "SPIN"}) {
    const std::string said =
        refused_choice("MOVE(10, 5, 0) FREE " + free + "\n", {"--robot", flat});
    CHECK(contains(said, "E586"));
    CHECK(contains(said, "FREE " + free + " is not possible on"));
  }
  // The gantry of three axes turns its tool about z, and keeps its angle where that is free.
  const FreeRun made = run_free("MOVE(40, 40, 30) FINE\nMOVE(140, 40, 90) FREE c FINE\n");
  CHECK(made.rows.back().q[0] == doctest::Approx(140));
  CHECK(made.rows.back().q[2] == doctest::Approx(30));
}

namespace {

/// The SO-101, whose targets leave c to the place.
class FiveAxes {
 public:
  explicit FiveAxes(const std::string& text) : rob_(text) {
    std::string robot =
        rob::test::read_whole_file(std::string(ROB_SOURCE_DIR) + "/motion/robots/so101.toml");
    const std::string law = "law = \"lookahead\"";
    if (!contains(robot, "free = "))
      robot.replace(robot.find(law), law.size(), law + "\nfree = \"c\"");
    std::ofstream(rob_.file("five.toml")) << robot;
  }
  ProcessResult operator()(const std::string& command, std::vector<std::string> more = {}) const {
    more.insert(more.end(), {"--robot", rob_.file("five.toml")});
    return rob_(command, more);
  }

 private:
  RobCommand rob_;
};

}  // namespace

TEST_CASE("five axes take a whole pose with FREE c, and with FREE SPIN what leans as they do") {
  const std::string there =
      "VAR j = JOINTS(20deg, 10deg, -10deg, 40deg, 30deg, 0deg)\nVAR p = FORWARD(j)\n"
      "VAR other = POSE(p.x, p.y, p.z, p.a, p.b, p.c + 25deg)\n";
  CHECK(contains(FiveAxes(there + "MOVE other\n")("check").err, "E333"));
  const auto output = [](const ProcessResult& result) {
    REQUIRE_MESSAGE(result.exit_code == 0, result.err);
    return json::parse(result.out)["output"];
  };
  const std::string reached = "PRINT DIST(TARGET, p) < 0.001mm, TURN(TARGET, p) < 0.01deg\n";
  CHECK(output(FiveAxes(there + "MOVE other FREE c NEAR j\n" + reached)(
            "run", {"--fast", "--json"}))[0] == "TRUETRUE");
  // The tool's z as it is; its own turn is another.
  const std::string spun = "MOVE p * POSE(0mm, 0mm, 0mm, 0deg, 0deg, 50deg) FREE SPIN NEAR j\n";
  CHECK(output(FiveAxes(there + spun + reached)("run", {"--fast", "--json"}))[0] == "TRUETRUE");
}
