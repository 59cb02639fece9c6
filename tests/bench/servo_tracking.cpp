/// What S2's feed-forward is worth: the tracking error of the simulated UMS-7 under PID alone and
/// with feed-forward, at S2's servo periods and at 1 kHz, for the arm that the servo knows and for
/// one that it does not (docs/servo.md). With an argument also the picture of it, as SVG.

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/drivers/arm_bench.h"
#include "tests/support/svg.h"

namespace {

using rob::test::ArmBench;
using rob::test::Point;
using rob::test::svg_curve;
using rob::test::svg_line;
using rob::test::svg_rect;
using rob::test::svg_text;
using rob::test::TrackingCase;

constexpr double kDegree = 3.14159265358979323846 / 180;

struct Plant {
  const char* name;
  double payload, masses, friction;
};

constexpr Plant kPlants[] = {{"as the servo believes", 0, 1, 1},
                             {"with 3 kg in the hand", 3, 1, 1},
                             {"coefficients 30 % off", 0, 1.3, 1},
                             {"friction 50 % up", 0, 1, 1.5}};
constexpr double kPeriods[] = {0.020, 0.015, 0.001};

TrackingCase case_of(const Plant& plant, double period, bool feed_forward) {
  return {period, feed_forward, plant.payload, plant.masses, plant.friction, 40};
}

std::string row(const rob::motion::JointVector& errors) {
  std::string text;
  for (const double error : errors) text += fmt::format("{:8.3f}", error / kDegree);
  return text;
}

void print_table() {
  for (const Plant& plant : kPlants) {
    fmt::print("The arm {}. Tracking error in degrees:\n", plant.name);
    fmt::print("  servo                        q1      q2      q3      q4      q5      q6\n");
    for (const double period : kPeriods) {
      for (const bool feed_forward : {false, true}) {
        const auto found = rob::test::track(case_of(plant, period, feed_forward));
        const char* law = feed_forward ? "PID + u0" : "PID alone";
        fmt::print("  {:2.0f} ms {:9}  rms {}\n", period * 1e3, law, row(found.rms));
        fmt::print("                   max {}\n", row(found.worst));
      }
    }
    fmt::print("\n");
  }
}

// The picture: one lane an axis, error over time.
constexpr double kLeft = 64, kWidth = 756, kTop = 64, kLane = 92, kGap = 14;

/// Axis `axis` of a run, every 30 ms, in degrees.
std::vector<double> errors_of(const TrackingCase& c, int axis) {
  ArmBench bench(c);
  std::vector<double> errors;
  for (int k = 0; bench.step(); ++k)
    if (k % 30 == 0) errors.push_back(bench.error()[axis] / kDegree);
  return errors;
}

std::string curve(const std::vector<double>& errors, double middle, double scale,
                  const char* colour) {
  std::vector<Point> points;
  for (std::size_t k = 0; k < errors.size(); ++k) {
    const double x = kLeft + kWidth * static_cast<double>(k) / static_cast<double>(errors.size());
    points.push_back({x, middle - errors[k] * scale});
  }
  return svg_curve(points, fmt::format("stroke=\"{}\" stroke-width=\"1.4\"", colour));
}

std::string lane(int axis, double top) {
  const Plant& known = kPlants[0];
  const auto alone = errors_of(case_of(known, 0.020, false), axis);
  const auto fed = errors_of(case_of(known, 0.020, true), axis);
  const auto fast = errors_of(case_of(known, 0.001, true), axis);
  double most = 0;
  for (const auto* errors : {&alone, &fed, &fast})
    for (const double error : *errors) most = std::max(most, std::abs(error));
  const double middle = top + kLane / 2;
  const double scale = 0.94 * kLane / 2 / most;
  return svg_rect({kLeft, top}, kWidth, kLane, "fill=\"#f8fafc\"") +
         svg_line({kLeft, middle}, {kLeft + kWidth, middle}, "stroke=\"#cbd5e1\"") +
         curve(alone, middle, scale, "#dc2626") + curve(fed, middle, scale, "#2563eb") +
         curve(fast, middle, scale, "#059669") +
         svg_text({kLeft - 8, middle + 4}, fmt::format("q{}", axis + 1), "text-anchor=\"end\"") +
         svg_text({kLeft + kWidth + 6, top + 12}, fmt::format("{:.2f}°", most));
}

bool draw(const char* file) {
  const double bottom = kTop + 6 * (kLane + kGap);
  std::string picture =
      svg_text({kLeft, 24},
               "Where the UMS-7's axes are behind their references, over a tour of 9 s",
               "font-size=\"15\"") +
      svg_text({kLeft, 48}, "PID alone, servo every 20 ms", "fill=\"#dc2626\"") +
      svg_text({kLeft + 230, 48}, "with feed-forward, every 20 ms", "fill=\"#2563eb\"") +
      svg_text({kLeft + 470, 48}, "with feed-forward, 1 kHz", "fill=\"#059669\"");
  for (int axis = 0; axis < 6; ++axis) picture += lane(axis, kTop + axis * (kLane + kGap));
  for (int t = 0; t <= 9; t += 3)
    picture += svg_text({kLeft + kWidth * t / 9.0, bottom + 12}, fmt::format("{} s", t),
                        "text-anchor=\"middle\"");
  return rob::test::save_svg(file, 880, bottom + 34, picture);
}

}  // namespace

int main(int argc, char** argv) {
  print_table();
  if (argc > 1 && !draw(argv[1])) {
    fmt::print(stderr, "servo_tracking: cannot write {}\n", argv[1]);
    return 74;
  }
}
