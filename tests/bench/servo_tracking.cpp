/// What S2's feed-forward is worth: the tracking error of the simulated UMS-7 under PID alone and
/// with feed-forward, at S2's servo periods and at 1 kHz, for the arm that the servo knows and for
/// one that it does not (docs/servo.md). With an argument also the picture of it, as SVG.

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

#include "tests/drivers/arm_bench.h"

namespace {

using rob::test::ArmBench;
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
  std::string points;
  for (std::size_t k = 0; k < errors.size(); ++k) {
    const double x = kLeft + kWidth * static_cast<double>(k) / static_cast<double>(errors.size());
    points += fmt::format("{:.1f},{:.1f} ", x, middle - errors[k] * scale);
  }
  return fmt::format("<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.4\"/>\n",
                     points, colour);
}

std::string text(double x, double y, const std::string& words, const char* more = "") {
  return fmt::format("<text x=\"{:.0f}\" y=\"{:.0f}\" {}>{}</text>\n", x, y, more, words);
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
  return fmt::format(
             "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"#f8fafc\"/>\n"
             "<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" stroke=\"#cbd5e1\"/>\n",
             kLeft, top, kWidth, kLane, kLeft, middle, kLeft + kWidth, middle) +
         curve(alone, middle, scale, "#dc2626") + curve(fed, middle, scale, "#2563eb") +
         curve(fast, middle, scale, "#059669") +
         text(kLeft - 8, middle + 4, fmt::format("q{}", axis + 1), "text-anchor=\"end\"") +
         text(kLeft + kWidth + 6, top + 12, fmt::format("{:.2f}°", most));
}

void draw(const char* file) {
  const double bottom = kTop + 6 * (kLane + kGap);
  std::ofstream out(file);
  out << fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 880 {0}\" width=\"880\" "
      "height=\"{0}\" font-size=\"12.5\" fill=\"#334155\" font-family=\"system-ui, 'Segoe UI', "
      "Roboto, 'DejaVu Sans', sans-serif\">\n"
      "<rect width=\"100%\" height=\"100%\" rx=\"10\" fill=\"#ffffff\"/>\n",
      bottom + 34);
  out << text(kLeft, 24, "Where the UMS-7's axes are behind their references, over a tour of 9 s",
              "font-size=\"15\"");
  out << text(kLeft, 48, "PID alone, servo every 20 ms", "fill=\"#dc2626\"");
  out << text(kLeft + 230, 48, "with feed-forward, every 20 ms", "fill=\"#2563eb\"");
  out << text(kLeft + 470, 48, "with feed-forward, 1 kHz", "fill=\"#059669\"");
  for (int axis = 0; axis < 6; ++axis) out << lane(axis, kTop + axis * (kLane + kGap));
  for (int t = 0; t <= 9; t += 3)
    out << text(kLeft + kWidth * t / 9.0, bottom + 12, fmt::format("{} s", t),
                "text-anchor=\"middle\"");
  out << "</svg>\n";
}

}  // namespace

int main(int argc, char** argv) {
  print_table();
  if (argc > 1) draw(argv[1]);
}
