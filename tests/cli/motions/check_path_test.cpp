// `rob check --path` from outside: the path that the look-ahead law plans.
#include <doctest/doctest.h>

#include <cmath>

#include "tests/support/rob_command.h"
#include "tests/support/topp.h"

using rob::test::contains;
using rob::test::ProcessResult;
using rob::test::RobCommand;
using rob::test::ToppNode;

namespace {

constexpr const char* kCorner = "LAW LOOKAHEAD\nMOVE(100, 0, 0)\nMOVE(100, 50, 0)\nMOVE(0, 50, 0)";

std::vector<ToppNode> path_of(const RobCommand& rob) {
  const std::string file = rob.file("path.csv");
  const ProcessResult result = rob("check", {"--path", file});
  REQUIRE_MESSAGE(result.exit_code == 0, result.err);
  return rob::test::parse_topp_path(rob::test::read_whole_file(file));
}

/// Where a value and its slope lead by the trapezoidal rule with its end correction (Euler and
/// Maclaurin), exact for polynomials of the third degree.
double by_trapezoid(double step, double from, double slope, double slope_there, double bend,
                    double bend_there) {
  return from + step / 2 * (slope + slope_there) + step * step / 12 * (bend - bend_there);
}

/// Of neighbouring rows of one piece: each column is the slope of the one before it.
void check_slopes(const ToppNode& a, const ToppNode& b) {
  const double step = b.sigma - a.sigma;
  for (std::size_t i = 0; i < a.q.size(); ++i) {
    const double there = by_trapezoid(step, a.q[i], a.dq[i], b.dq[i], a.ddq[i], b.ddq[i]);
    CHECK(std::abs(b.q[i] - there) < 1e-4);
    const double slope = a.dq[i] + step / 2 * (a.ddq[i] + b.ddq[i]);
    CHECK(std::abs(b.dq[i] - slope) < 1e-4);
  }
}

}  // namespace

TEST_CASE("the planned path has a row for both ends of each piece, in mm and deg") {
  const auto nodes = path_of(RobCommand(kCorner));
  REQUIRE(nodes.size() > 10);
  CHECK(nodes.front().sigma == 0);
  CHECK(nodes.front().dq == rob::test::AxisValues{1, 0, 0});
  CHECK(nodes.back().sigma == doctest::Approx(250));
  CHECK(nodes.back().q == rob::test::AxisValues{0, 50, 0});
  CHECK(nodes.back().dq == rob::test::AxisValues{-1, 0, 0});
  // At 20 mm/s an axis of 100 mm/s² takes 20²/(2·100) mm on each side of a right angle.
  std::size_t corner = 0;
  while (nodes[corner].ddq[1] == 0) ++corner;
  const ToppNode& in = nodes[corner];
  const double half = 2;
  CHECK(in.sigma == doctest::Approx(100 - half));
  CHECK(in.q[0] == doctest::Approx(100 - half));
  CHECK(in.q[1] == 0);
  CHECK(in.ddq[0] == doctest::Approx(-1 / (2 * half)));
  const ToppNode& middle = nodes[corner + 1];
  CHECK(middle.sigma == doctest::Approx(100));
  CHECK(middle.q[0] == doctest::Approx(100 - half / 4));
  CHECK(middle.q[1] == doctest::Approx(half / 4));
}

TEST_CASE("the derivatives of an arm's planned path are the slopes of its axes") {
  const std::string arm =
      "ROBOT \"irb120\"\nLAW LOOKAHEAD\nMOVE(350, -100, 300, 180, 0, 180) FINE\n"
      "MOVEL(350, 100, 300) ZONE 5mm AT 200mm/s\nMOVEL(350, 100, 400) AT 200mm/s\n";
  const auto nodes = path_of(RobCommand(arm));
  std::size_t pieces = 0;
  double curved = 0;
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    if (nodes[i + 1].sigma == nodes[i].sigma) {
      for (std::size_t k = 0; k < 6; ++k)
        CHECK(nodes[i + 1].q[k] == doctest::Approx(nodes[i].q[k]).epsilon(1e-9));
      continue;
    }
    ++pieces;
    check_slopes(nodes[i], nodes[i + 1]);
    for (const double bend : nodes[i].ddq) curved = std::max(curved, std::abs(bend));
  }
  CHECK(pieces > 50);
  CHECK(pieces * 2 == nodes.size());
  CHECK(curved > 1e-3);
  const auto run = nlohmann::json::parse(RobCommand(arm)("run", {"--fast", "--json"}).out);
  for (std::size_t i = 0; i < 6; ++i)
    CHECK(nodes.back().q[i] == doctest::Approx(run["final"]["joints"][i].get<double>()));
}

TEST_CASE("a path that cannot be written, or is not planned, is refused with the way out") {
  const RobCommand rob(kCorner);
  const auto refusal = [&](const std::vector<std::string>& more) { return rob("check", more); };
  const ProcessResult paul = refusal({"--law", "paul", "--path", rob.file("p.csv")});
  CHECK(paul.exit_code == 64);
  CHECK(contains(paul.err, "use --law lookahead"));
  CHECK(paul.out.empty());
  CHECK_FALSE(std::filesystem::exists(rob.file("p.csv")));

  const ProcessResult two = refusal({rob.program(), "--path", rob.file("p.csv")});
  CHECK(two.exit_code == 64);
  CHECK(contains(two.err, "--path is of one program"));

  const ProcessResult own = refusal({"--path", rob.program()});
  CHECK(own.exit_code == 64);
  CHECK(contains(own.err, "is the program; name another file"));
  CHECK(rob::test::read_whole_file(rob.program()) == kCorner);

  const ProcessResult nowhere = refusal({"--path", rob.file("none/p.csv")});
  CHECK(nowhere.exit_code == 74);
  CHECK(contains(nowhere.err, "check the name and the folder"));

  const ProcessResult device = refusal({"--path", "/dev/full"});
  CHECK(device.exit_code == 74);
  CHECK(contains(device.err, "it is no regular file; name a file"));

  const ProcessResult wrong =
      RobCommand("LAW LOOKAHEAD\nMOVE(1, 2\n")("check", {"--path", "/dev/full"});
  CHECK(wrong.exit_code == 65);
  CHECK_FALSE(contains(wrong.err, "/dev/full"));
}

TEST_CASE("a path is saved whole: until then, and after a refusal, the file is the old one") {
  const RobCommand rob(kCorner);
  const std::string file = rob.file("path.csv");
  std::ofstream(file) << "old";
  // What a crash has left behind is in nobody's way; a folder of that name is.
  const std::string temporary = rob.file(".path.csv.saving");
  std::filesystem::create_directory(temporary);
  const ProcessResult refused = rob("check", {"--path", file});
  CHECK(refused.exit_code == 74);
  CHECK(rob::test::read_whole_file(file) == "old");
  std::filesystem::remove(temporary);
  std::ofstream(temporary) << "left behind";
  CHECK(rob("check", {"--path", file}).exit_code == 0);
  CHECK(rob::test::read_whole_file(file).starts_with("sigma,q1,"));
  CHECK_FALSE(std::filesystem::exists(temporary));
}
