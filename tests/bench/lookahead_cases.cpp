#include "tests/bench/lookahead_cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rob::bench {

namespace {

using Eigen::Vector3d;
using Places = std::vector<Vector3d>;

constexpr double kPi = std::numbers::pi;

/// As it stands in the program: whole nanometres.
Vector3d written(double x, double y) {
  return {std::round(x * 1e6) / 1e6, std::round(y * 1e6) / 1e6, 0};
}

/// (40, 40) (140, 40) (90, 126) (40, 40), moved to where the robot stands.
Places triangle() { return {{0, 0, 0}, {100, 0, 0}, {50, 86, 0}, {0, 0, 0}}; }

/// Begins and ends at its lowest place.
Places circle() {
  constexpr double kRadius = 50;
  constexpr int kChords = 1000;
  Places places;
  for (int k = 0; k <= kChords; ++k) {
    const double angle = 2 * kPi * k / kChords;
    places.push_back(written(kRadius * std::sin(angle), kRadius * (1 - std::cos(angle))));
  }
  return places;
}

/// 200 lines of 50 mm, 1 mm apart, to and fro.
Places hatch() {
  Places places;
  for (int line = 0; line < 200; ++line) {
    const double y = line;
    const double from = line % 2 == 0 ? 0 : 50;
    places.emplace_back(from, y, 0);
    places.emplace_back(50 - from, y, 0);
  }
  return places;
}

Places straight() {
  Places places;
  for (int k = 0; k <= 10'000; ++k) places.push_back(written(0.02 * k, 0));
  return places;
}

/// One turn while the circle is gone round.
std::vector<double> one_turn(std::size_t places) {
  std::vector<double> turns;
  for (std::size_t k = 0; k < places; ++k)
    turns.push_back(360.0 * static_cast<double>(k) / static_cast<double>(places - 1));
  return turns;
}

LookAheadCase made(const char* name, Places places, double speed, double zone, double linuxcnc,
                   double best_known, double jerk_linuxcnc = 0, double jerk_goal = 0) {
  LookAheadCase c;
  c.name = name;
  c.robot = "xy.toml";
  c.path.places = std::move(places);
  c.speed = speed;
  c.zone = zone;
  c.linuxcnc = linuxcnc;
  c.best_known = best_known;
  c.jerk_linuxcnc = jerk_linuxcnc;
  c.jerk_goal = jerk_goal;
  return c;
}

}  // namespace

double LookAheadCase::goal() const { return std::min(margin * best_known, linuxcnc - 0.001); }

std::string LookAheadCase::program(double jerk) const {
  std::string text;
  for (std::size_t k = 1; k < path.places.size(); ++k) {
    const Vector3d& p = path.places[k];
    const std::string turn = turns.empty() ? "" : fmt::format(", {:.6f}", turns[k]);
    text += fmt::format("MOVE({:.6f}, {:.6f}, {:.6f}{}) AT {:g}mm/s ZONE {:g}mm", p.x(), p.y(),
                        p.z(), turn, speed, zone);
    if (jerk > 0) text += fmt::format(" JERK {:g}mm/s^3", jerk);
    text += "\n";
  }
  return text;
}

std::vector<LookAheadCase> lookahead_cases() {
  std::vector<LookAheadCase> cases = {
      made("triangle", triangle(), 100, 0.1, 3.269, 3.252, 3.377, 3.28),
      made("triangle", triangle(), 300, 0.1, 1.825, 1.808, 1.933, 1.84),
      made("triangle", triangle(), 300, 1, 1.834, 1.782, 2.17, 1.81),
      made("circle as 1000 chords", circle(), 100, 0.1, 3.25, 3.241, 4.5, 3.27),
      made("circle as 1000 chords", circle(), 300, 0.1, 1.86, 1.598, 4.5, 1.63),
      made("hatch of 200 lines", hatch(), 100, 0.1, 129.1, 123.1, 155.5, 126.5),
      made("hatch of 200 lines", hatch(), 300, 0.1, 98.9, 92.6, 125.3, 96),
      made("straight, 0.02 mm pieces", straight(), 300, 0.1, 10.2, 0.967),
      made("circle, an axis turning", circle(), 100, 0.1, 24.5, 3.25)};
  cases[7].margin = 1.01;
  cases[8].robot = "xyza.toml";
  cases[8].turns = one_turn(cases[8].path.places.size());
  return cases;
}

}  // namespace rob::bench
