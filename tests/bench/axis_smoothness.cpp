/// S3's test: each axis of its arm by itself, −10° … +10° at 5, 10 and 20 °/s, under three servos.
/// Prints how smooth the axes run (docs/servo.md). With a folder as argument also writes the
/// velocities there, axisN.csv, and the pictures of them, smoothness_N.svg.

#include "tests/drivers/smoothness_bench.h"

#include <fmt/format.h>

#include <array>
#include <fstream>
#include <string>

#include "tests/support/svg.h"

namespace {

using rob::motion::ServoStructure;
using rob::test::kSmoothnessDegree;
using rob::test::Point;
using rob::test::Smoothness;
using rob::test::SmoothnessSample;

struct Structure {
  ServoStructure structure;
  const char* name;
  const char* colour;
};

constexpr std::array<Structure, 3> kStructures = {
    {{ServoStructure::PulseTrain, "pulse train", "#dc2626"},
     {ServoStructure::PositionLoop, "position loop", "#d97706"},
     {ServoStructure::DoubleLoop, "double loop", "#2563eb"}}};
constexpr std::array<int, 3> kSpeeds = {5, 10, 20};  // °/s

/// One axis: all structures, all speeds.
using Runs = std::array<std::array<Smoothness, kSpeeds.size()>, kStructures.size()>;

Runs runs_of(int axis) {
  Runs runs;
  for (std::size_t i = 0; i < kStructures.size(); ++i)
    for (std::size_t j = 0; j < kSpeeds.size(); ++j)
      runs[i][j] =
          rob::test::run_smoothness(axis, kSpeeds[j] * kSmoothnessDegree, kStructures[i].structure);
  return runs;
}

void print_row(int axis, const Runs& runs) {
  for (std::size_t j = 0; j < kSpeeds.size(); ++j) {
    fmt::print("| {} | {} °/s |", axis + 1, kSpeeds[j]);
    for (const auto& run : runs) {
      const Smoothness& found = run[j];
      fmt::print(" {:.2f} / {:.2f} / {} |", found.ripple * 100, found.peak * 100, found.spikes);
    }
    fmt::print("\n");
  }
}

bool write_csv(const std::string& file, const Runs& runs) {
  std::ofstream out(file);
  out << "structure,speed_deg_s,t_s,wanted_deg_s,velocity_deg_s\n";
  for (std::size_t i = 0; i < kStructures.size(); ++i)
    for (std::size_t j = 0; j < kSpeeds.size(); ++j)
      for (const SmoothnessSample& s : runs[i][j].samples)
        out << fmt::format("{},{},{:.3f},{:.6g},{:.6g}\n", kStructures[i].name, kSpeeds[j], s.t,
                           s.wanted / kSmoothnessDegree, s.velocity / kSmoothnessDegree);
  return static_cast<bool>(out.flush());
}

// The picture: a row a structure, a column a speed; velocity from 70 % to 130 % over time.
constexpr double kLeft = 72, kTop = 74, kWidth = 252, kHeight = 118, kGap = 18;
constexpr double kLow = 0.7, kHigh = 1.3;

std::string grid(Point corner, bool first) {
  std::string text = rob::test::svg_rect(corner, kWidth, kHeight, "fill=\"#f8fafc\"");
  for (const int percent : {80, 100, 120}) {
    const double y = corner.y + kHeight * (kHigh - percent / 100.0) / (kHigh - kLow);
    text += rob::test::svg_line({corner.x, y}, {corner.x + kWidth, y}, "stroke=\"#cbd5e1\"");
    if (!first) continue;
    text += rob::test::svg_text({corner.x - 8, y + 4}, fmt::format("{} %", percent),
                                "text-anchor=\"end\" fill=\"#64748b\"");
  }
  return text;
}

/// Some 300 points, whatever the run lasts.
std::string velocity_curve(Point corner, const Smoothness& run, int speed, const char* colour) {
  const auto every = static_cast<std::size_t>(20 / speed * 4);
  std::vector<Point> points;
  for (std::size_t k = 0; k < run.samples.size(); k += every) {
    const SmoothnessSample& s = run.samples[k];
    const double share = s.velocity / (speed * kSmoothnessDegree);
    points.push_back(
        {corner.x + kWidth * s.t / run.samples.back().t,
         corner.y + kHeight * (kHigh - std::clamp(share, kLow, kHigh)) / (kHigh - kLow)});
  }
  return rob::test::svg_curve(points, fmt::format("stroke=\"{}\" stroke-width=\"1.3\"", colour));
}

bool draw(const std::string& file, int axis, const Runs& runs) {
  const double right = kLeft + 3 * kWidth + 2 * kGap;
  std::string text = rob::test::svg_text(
      {kLeft, 26}, fmt::format("How smoothly axis {} runs from −10° to +10°", axis + 1),
      "font-size=\"15\"");
  text += rob::test::svg_text({right, 26}, "velocity, % of the programmed one",
                              "text-anchor=\"end\" fill=\"#64748b\"");
  for (std::size_t i = 0; i < kStructures.size(); ++i) {
    for (std::size_t j = 0; j < kSpeeds.size(); ++j) {
      const Point corner{kLeft + static_cast<double>(j) * (kWidth + kGap),
                         kTop + static_cast<double>(i) * (kHeight + kGap + 12)};
      const Smoothness& run = runs[i][j];
      text += grid(corner, j == 0);
      text += velocity_curve(corner, run, kSpeeds[j], kStructures[i].colour);
      text += rob::test::svg_text(
          {corner.x + 6, corner.y - 5},
          fmt::format("{}{} °/s", j == 0 ? std::string(kStructures[i].name) + ", " : "",
                      kSpeeds[j]),
          fmt::format("fill=\"{}\"", kStructures[i].colour));
      text += rob::test::svg_text({corner.x + kWidth - 6, corner.y - 5},
                                  fmt::format("ripple {:.2f} %", run.ripple * 100),
                                  "text-anchor=\"end\"");
      if (i + 1 < kStructures.size()) continue;
      text += rob::test::svg_text({corner.x, corner.y + kHeight + 18}, "0 s", "fill=\"#64748b\"");
      text += rob::test::svg_text({corner.x + kWidth, corner.y + kHeight + 18},
                                  fmt::format("{:.1f} s", run.samples.back().t),
                                  "text-anchor=\"end\" fill=\"#64748b\"");
    }
  }
  return rob::test::save_svg(file, right + 24, kTop + 3 * (kHeight + kGap + 12) + 8, text);
}

}  // namespace

int main(int argc, char** argv) {
  fmt::print("Ripple rms / peak, % of the speed, / spikes beyond {:.0f} %:\n",
             rob::test::kSpike * 100);
  fmt::print("| axis | speed |");
  for (const Structure& structure : kStructures) fmt::print(" {} |", structure.name);
  fmt::print("\n|---|---|---|---|---|\n");
  for (int axis = 0; axis < 6; ++axis) {
    const Runs runs = runs_of(axis);
    print_row(axis, runs);
    if (argc < 2) continue;
    const std::string folder = argv[1];
    const bool written = write_csv(fmt::format("{}/axis{}.csv", folder, axis + 1), runs) &&
                         draw(fmt::format("{}/smoothness_{}.svg", folder, axis + 1), axis, runs);
    if (written) continue;
    fmt::print(stderr, "axis_smoothness: cannot write into {}\n", folder);
    return 74;
  }
}
