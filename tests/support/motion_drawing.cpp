#include "tests/support/motion_drawing.h"

#include <algorithm>
#include <cmath>

#include "motion/path/paul_transition.h"
#include "tests/support/plot.h"
#include "tests/support/rounded_polyline.h"

namespace rob::test {

namespace {

constexpr const char* kPaul = "#2563eb";
constexpr const char* kAhead = "#ea580c";
constexpr const char* kGrey = "fill=\"#64748b\"";
constexpr const char* kDashed = "stroke-dasharray=\"5 4\"";

std::string title(const std::string& words) {
  return svg_text({40, 30}, words, "font-size=\"15\"");
}

std::string key(Point at, const char* colour, const std::string& words) {
  return svg_line(at, {at.x + 26, at.y},
                  fmt::format("stroke=\"{}\" stroke-width=\"2.5\"", colour)) +
         svg_text({at.x + 34, at.y + 4}, words);
}

std::string dot(Point at, const char* colour) {
  return fmt::format(
      "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3.5\" fill=\"#ffffff\" stroke=\"{}\" "
      "stroke-width=\"1.6\"/>\n",
      at.x, at.y, colour);
}

/// The corner of the drawing: from A at (-L, 0) over B at 0 to C, turned by 100°.
struct Corner {
  static constexpr double kSpeed = 1;   // of both legs
  static constexpr double kHalf = 1;    // Paul's t_acc
  static constexpr double kTime = 2.4;  // of each leg
  motion::JointVector a{{-kSpeed * kTime, 0.0}};
  motion::JointVector b{{0.0, 0.0}};
  motion::JointVector c{{kSpeed * kTime * std::cos(1.75), kSpeed* kTime* std::sin(1.75)}};
  double turn() const { return (c / kTime - (b - a) / kTime).norm(); }  // |v2 − v1|
  double acceleration() const { return 0.75 * turn() / kHalf; }         // Paul's greatest
  /// Of the parabola with that acceleration.
  double parabola_half() const { return turn() / acceleration() / 2; }
};

std::vector<Point> paul_places(const Corner& corner) {
  // S1's A is where the motion before stands when the corner begins.
  const motion::PaulTransition law(corner.a * (Corner::kHalf / Corner::kTime), corner.b, corner.c,
                                   Corner::kTime, Corner::kHalf);
  std::vector<Point> places;
  for (int k = 0; k <= 80; ++k) {
    const auto at = law.sample(-Corner::kHalf + 2 * Corner::kHalf * k / 80);
    places.push_back({at.q[0], at.q[1]});
  }
  return places;
}

std::vector<Point> parabola_places(const Corner& corner) {
  const double half = corner.parabola_half();
  const motion::JointVector v1 = (corner.b - corner.a) / Corner::kTime,
                            v2 = corner.c / Corner::kTime;
  std::vector<Point> places;
  for (int k = 0; k <= 80; ++k) {
    const double t = 2 * half * k / 80;
    const motion::JointVector q = v1 * (t - half) + (v2 - v1) * (t * t / (4 * half));
    places.push_back({q[0], q[1]});
  }
  return places;
}

std::string corner_places(const Corner& corner) {
  const Plot plot{{60, 70}, 330, 330, -2.6, 0.5, -0.4, 2.7};
  const auto paul = paul_places(corner), parabola = parabola_places(corner);
  std::string text = plot.curve({{corner.a[0], corner.a[1]}, {0, 0}, {corner.c[0], corner.c[1]}},
                                "#94a3b8", 1.3, kDashed) +
                     plot.curve({{corner.a[0], 0}, paul.front()}, "#334155") +
                     plot.curve({paul.back(), {corner.c[0], corner.c[1]}}, "#334155") +
                     plot.curve(paul, kPaul, 2.5);
  text += plot.curve(parabola, kAhead, 2.5);
  for (const Point& p : {paul.front(), paul.back()}) text += dot(plot(p.x, p.y), kPaul);
  for (const Point& p : {parabola.front(), parabola.back()}) text += dot(plot(p.x, p.y), kAhead);
  text += svg_text({plot(-2.4, 0).x - 6, plot(0, 0).y + 22}, "A");
  text += svg_text({plot(0, 0).x + 8, plot(0, 0).y + 16}, "B", "font-weight=\"600\"");
  return text + svg_text({plot(corner.c[0], 0).x + 10, plot(0, corner.c[1]).y + 6}, "C");
}

std::string corner_accelerations(const Corner& corner) {
  const Plot plot{{500, 110}, 340, 180, -1.3, 1.3, 0, 1.25};
  std::vector<Point> paul;
  for (int k = 0; k <= 60; ++k) {
    const double h = k / 60.0;
    paul.push_back({2 * h - 1, 4 * h * (1 - h)});
  }
  const double half = corner.parabola_half() / Corner::kHalf;
  std::string text = plot.ground();
  text += plot.curve({{-1.3, 0}, {1.3, 0}}, "#94a3b8", 1);
  text += plot.curve({{-1.3, 1}, {1.3, 1}}, "#94a3b8", 1, "stroke-dasharray=\"3 4\"");
  text += plot.curve(paul, kPaul, 2.5);
  text += plot.curve({{-half, 0}, {-half, 1}, {half, 1}, {half, 0}}, kAhead, 2.5);
  text += svg_text({500, 96}, "acceleration", kGrey);
  text += svg_text({846, plot(0, 1).y + 4}, "a_max", kGrey);
  for (const auto& [x, words] : {std::pair{-1.0, "−t_acc"}, {0.0, "0"}, {1.0, "t_acc"}})
    text += svg_text({plot(x, 0).x, plot(x, 0).y + 18}, words,
                     "text-anchor=\"middle\" fill=\"#64748b\"");
  return text;
}

/// The triangle of the drawing of speeds, mm, and its corners' ZONE.
const std::vector<Eigen::Vector3d> kTriangle = {{0, 0, 0}, {100, 0, 0}, {50, 86, 0}, {0, 0, 0}};
constexpr double kZone = 5, kSpeed = 250, kAxis = 1000;

}  // namespace

Drawing corner_drawing() {
  const Corner corner;
  std::string text = title("A corner under both laws, with the same speed and the same a_max") +
                     corner_places(corner) + corner_accelerations(corner);
  text += key({500, 340}, kPaul, "Paul's quartic: 2·t_acc, misses B by 3/16·t_acc·|v2 − v1|");
  text += key({500, 366}, kAhead, "look-ahead's parabola: misses B by |v2 − v1|²/8a");
  return {920, 430, text};
}

Drawing speed_drawing() {
  const auto nodes = rounded_polyline(kTriangle, kZone);
  const ToppMotion motion =
      time_optimal(nodes, {{1000, 1000, 1000}, {kAxis, kAxis, kAxis}, kSpeed}, 4000);
  const Plot plot{{70, 70}, 770, 260, 0, motion.sigma.back(), 0, 300};
  std::vector<Point> most, driven;
  for (std::size_t k = 0; k < motion.sigma.size(); k += 4) {
    most.push_back({motion.sigma[k], motion.most[k]});
    driven.push_back({motion.sigma[k], motion.rate[k]});
  }
  most.push_back({motion.sigma.back(), 0});
  driven.push_back({motion.sigma.back(), 0});
  std::string text = title("The speed along the triangle, each corner with ZONE 5mm") +
                     plot.ground() + plot.rules_y(100) + plot.rules_x(50);
  // Corners are where the second derivative is not 0.
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    if (nodes[i].ddq == AxisValues{0, 0, 0} || nodes[i + 1].sigma <= nodes[i].sigma) continue;
    const Point at = plot(nodes[i].sigma, plot.high);
    text += svg_rect(at, plot(nodes[i + 1].sigma, 0).x - at.x, plot.height, "fill=\"#fde68a\"");
  }
  text += plot.curve({{0, kSpeed}, {plot.right, kSpeed}}, "#94a3b8", 1.3, kDashed);
  text += plot.curve(most, kPaul, 4, "stroke-opacity=\"0.45\"") + plot.curve(driven, kAhead, 2);
  text += svg_text({70, 58}, "mm/s", kGrey) + svg_text({810, 366}, "σ, mm", kGrey);
  text += svg_text({plot(4, 0).x, plot(0, kSpeed).y - 8}, "AT 250mm/s", kGrey);
  text += key({70, 396}, kPaul, "S: from here the standstill at the end can be reached") +
          key({460, 396}, kAhead, "what is driven: as fast as S lets") +
          svg_rect({720, 389}, 24, 13, "fill=\"#fde68a\"") + svg_text({752, 400}, "corner");
  return {880, 424, text};
}

namespace {

/// Up at a, and at once down again: the hardest for a bound of the jerk.
struct Bang {
  static constexpr double kA = 1000, kHalf = 0.09;  // mm/s², s
  static double speed(double t) { return kA * std::clamp(std::min(t, 2 * kHalf - t), 0.0, kHalf); }
  static double acceleration(double t) { return t < 0 || t > 2 * kHalf ? 0 : t < kHalf ? kA : -kA; }
  static double place(double t) {
    const double up = std::clamp(t, 0.0, kHalf), down = std::clamp(t - kHalf, 0.0, kHalf);
    return kA * up * up / 2 + kA * kHalf * down - kA * down * down / 2;
  }
};

}  // namespace

Drawing mean_drawing() {
  constexpr double kWindow = 0.04, kEnd = 0.238, kStep = 0.0005;
  const Plot speed{{70, 70}, 770, 130, -0.01, kEnd, 0, 100};
  const Plot acceleration{{70, 240}, 770, 150, -0.01, kEnd, -1200, 1200};
  std::vector<Point> guide_v, guide_a, mean_v, mean_a;
  for (double t = -0.01; t < kEnd; t += kStep) {
    guide_v.push_back({t, Bang::speed(t)});
    guide_a.push_back({t, Bang::acceleration(t)});
    mean_v.push_back({t, (Bang::place(t) - Bang::place(t - kWindow)) / kWindow});
    mean_a.push_back({t, (Bang::speed(t) - Bang::speed(t - kWindow)) / kWindow});
  }
  std::string text = title("A motion and its mean over the last 40 ms: the jerk is 2·a/40 ms") +
                     speed.ground() + speed.rules_y(50) + acceleration.ground() +
                     acceleration.rules_y(1000) + acceleration.rules_x(0.04);
  text += speed.curve(guide_v, "#94a3b8", 2) + speed.curve(mean_v, kAhead, 2.5) +
          acceleration.curve(guide_a, "#94a3b8", 2) + acceleration.curve(mean_a, kAhead, 2.5);
  text += svg_text({70, 60}, "speed, mm/s", kGrey) +
          svg_text({70, 230}, "acceleration, mm/s²", kGrey) + svg_text({850, 408}, "s", kGrey);
  text += key({70, 436}, "#94a3b8", "guide") + key({220, 436}, kAhead, "references: its mean");
  return {880, 460, text};
}

}  // namespace rob::test
