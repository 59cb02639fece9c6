#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

#include <Eigen/Geometry>

#include "motion/kinematics/arm_kinematics.h"
#include "motion/kinematics/chain_kinematics.h"
#include "tests/support/robot_drawing.h"

// From its right side: x to the right, z up, y into the page.

namespace rob::test {
namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kPi = 3.14159265358979323846;
constexpr double kTop = 138, kBottom = 456, kLeft = 110, kRight = 500;  // px, for the arm itself

/// Where an arm's parts are, m, and the positive sense of each axis.
struct Skeleton {
  Vector3d base, shoulder, elbow, corner, wrist, flange;  // corner: a2 beside the elbow
  Matrix3d tool;
  std::array<Vector3d, 6> axes;
};

Skeleton skeleton_of(const motion::RobotModel& robot, const motion::ArmParameters& p) {
  std::array<double, 6> theta{};
  for (std::size_t i = 0; i < 6; ++i)
    theta[i] = p.sign[i] * robot.start[static_cast<Eigen::Index>(i)] + p.offset[i];
  const auto about_z = [&](std::size_t i) { return AngleAxisd(theta[i], Vector3d::UnitZ()); };
  const Matrix3d base(about_z(0));
  const Matrix3d upper = base * AngleAxisd(theta[1], Vector3d::UnitY());
  const Matrix3d fore = upper * AngleAxisd(theta[2], Vector3d::UnitY());
  const Matrix3d turned = fore * about_z(3);
  const Matrix3d bent = turned * AngleAxisd(theta[4], Vector3d::UnitY());
  Skeleton s;
  s.base = Vector3d::Zero();
  s.shoulder = base * Vector3d(p.a1, 0, p.c1);
  s.elbow = s.shoulder + upper * Vector3d(0, 0, p.c2);
  s.corner = s.elbow + fore * Vector3d(p.a2, 0, 0);
  s.wrist = s.corner + fore * Vector3d(0, p.b, p.c3);
  s.flange = s.wrist + bent * Vector3d(0, 0, p.c4);
  s.tool = bent * about_z(5);
  s.axes = {base.col(2), base.col(1), base.col(1), fore.col(2), turned.col(1), bent.col(2)};
  for (std::size_t i = 0; i < 6; ++i) s.axes[i] *= p.sign[i];
  const motion::Pose pose = robot.kinematics->forward(robot.start);
  if ((pose.position - s.flange).norm() > 1e-9 ||
      (pose.orientation.toRotationMatrix() - s.tool).norm() > 1e-9)
    throw std::runtime_error("the drawing of " + robot.name + " is not where its tool is");
  return s;
}

/// m to px.
class View {
 public:
  explicit View(const std::vector<Vector3d>& points) {
    double left = 0, right = 0, low = 0, high = 0;
    for (const Vector3d& p : points) {
      left = std::min(left, p.x());
      right = std::max(right, p.x());
      low = std::min(low, p.z());
      high = std::max(high, p.z());
    }
    scale_ = std::min((kRight - kLeft) / (right - left), (kBottom - kTop) / (high - low));
    origin_ = {kLeft - left * scale_, kBottom + low * scale_};
  }
  Point operator()(const Vector3d& p) const {
    return {origin_.x + p.x() * scale_, origin_.y - p.z() * scale_};
  }

 private:
  double scale_ = 1;
  Point origin_;
};

std::string link(const View& view, const std::vector<Vector3d>& along) {
  std::vector<Point> points;
  for (const Vector3d& p : along) points.push_back(view(p));
  return svg_curve(points,
                   "stroke=\"#cbd5e1\" stroke-width=\"18\" stroke-linecap=\"round\" "
                   "stroke-linejoin=\"round\"");
}

std::string ground(Point at) {
  std::string text =
      svg_line({at.x - 46, at.y}, {at.x + 46, at.y}, "stroke=\"#475569\" stroke-width=\"2.5\"");
  for (double x = at.x - 42; x < at.x + 46; x += 12)
    text += svg_line({x, at.y}, {x - 8, at.y + 9}, "stroke=\"#94a3b8\"");
  return text;
}

std::string badge(Point at, int number) {
  return fmt::format(
             "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"9\" fill=\"#ffffff\" stroke=\"#0f172a\" "
             "stroke-width=\"1.5\"/>\n",
             at.x, at.y) +
         svg_text({at.x, at.y + 4}, std::to_string(number),
                  "text-anchor=\"middle\" font-weight=\"600\" fill=\"#0f172a\"");
}

/// An axis across the page: which way round it turns when its angle grows.
std::string turning_axis(Point at, int number, bool clockwise, Point number_at) {
  constexpr double kRadius = 19;
  const double from = -0.55 * kPi;
  const double sweep = clockwise ? 1.3 * kPi : -1.3 * kPi;
  std::vector<Point> arc;
  for (int k = 0; k <= 20; ++k) {
    const double angle = from + sweep * k / 20;
    arc.push_back({at.x + kRadius * std::cos(angle), at.y + kRadius * std::sin(angle)});
  }
  const Point tip = arc.back();
  const double end = from + sweep;
  const double sense = clockwise ? 1 : -1;
  const Point behind{tip.x + sense * 2 * std::sin(end), tip.y - sense * 2 * std::cos(end)};
  const Point ahead{tip.x - sense * 7 * std::sin(end), tip.y + sense * 7 * std::cos(end)};
  return svg_curve(arc, "stroke=\"#0f172a\" stroke-width=\"1.5\"") +
         arrow(behind, ahead, "#0f172a") + badge(number_at, number);
}

/// An axis in the page, along which the angle counts by the right hand; `at` on it.
std::string pointing_axis(Point at, int number, const Vector3d& direction) {
  const Point u{direction.x(), -direction.z()};
  const Point tip{at.x + 32 * u.x, at.y + 32 * u.y};
  return svg_line({at.x - 20 * u.x, at.y - 20 * u.y}, at,
                  "stroke=\"#0f172a\" stroke-dasharray=\"8 3 2 3\"") +
         arrow(at, tip, "#0f172a") + badge(at, number);
}

std::string axis_mark(Point at, int number, const Vector3d& direction, Point aside = {}) {
  if (std::abs(direction.y()) > 0.9)
    return turning_axis(at, number, direction.y() > 0, {at.x + aside.x, at.y + aside.y});
  return pointing_axis(at, number, direction);
}

std::string length_words(const char* name, double length) {
  return fmt::format("{} {}{:g}", name, length < 0 ? "−" : "", std::abs(length) * 1000);
}

/// Measures that are not 0.
std::string dimensions(const View& view, const Skeleton& s, const motion::ArmParameters& p) {
  constexpr double kAway = 40;
  std::string text;
  const auto add = [&](const char* name, double length, const Vector3d& from, const Vector3d& to,
                       double away) {
    if (length != 0) text += dimension(view(from), view(to), away, length_words(name, length));
  };
  const Vector3d below(s.base.x(), 0, s.shoulder.z());
  add("c1", p.c1, s.base, below, kAway);
  add("a1", p.a1, below, s.shoulder, -kAway);
  // Axis 1 needs the side that a column does not take; a step is shown on its free side.
  add("c2", p.c2, s.shoulder, s.elbow, p.c1 != 0 ? kAway : -kAway);
  add("a2", p.a2, s.elbow, s.corner, p.a2 < 0 ? kAway : -kAway);
  add("c3", p.c3, s.corner, s.wrist, kAway);
  add("c4", p.c4, s.wrist, s.flange, kAway);
  return text;
}

Direction on_page(const Vector3d& v) { return {v.x(), v.z(), v.y()}; }

Point between(const View& view, const Vector3d& a, const Vector3d& b, double share) {
  return view(a + share * (b - a));
}

std::string notes_on_signs() {
  const std::string grey = "fill=\"#64748b\"";
  std::string text;
  double y = 308;
  for (const char* line :
       {"Arrows show how an angle grows; one", "along its axis by the right hand.",
        "Frames: the world at the base, the tool", "without a tool at the flange."}) {
    text += svg_text({kListLeft, y}, line, grey);
    y += 18;
  }
  return text;
}

std::string notes(const motion::ArmParameters& p) {
  const double y = 308 + 4 * 18;
  std::string text =
      svg_text({kListLeft, 286}, "All lengths in mm.", "fill=\"#64748b\"") + notes_on_signs();
  if (p.b == 0) return text;
  text += svg_text({kListLeft, y + 8}, length_words("b", p.b) + ": so far the wrist lies");
  return text + svg_text({kListLeft, y + 26}, p.b < 0 ? "in front of axis 1." : "behind axis 1.");
}

}  // namespace

std::string arm_drawing(const motion::RobotModel& robot) {
  const auto& arm = dynamic_cast<const motion::ArmKinematics&>(*robot.kinematics);
  const motion::ArmParameters& p = arm.parameters();
  const Skeleton s = skeleton_of(robot, p);
  const View view({s.shoulder, s.elbow, s.corner, s.wrist, s.flange});
  const bool hand = p.c4 != 0;
  std::string text = drawing_frame(robot, "at its start, seen from its right side");
  text += ground(view(s.base));
  text += link(view, {s.base, {s.base.x(), 0, s.shoulder.z()}, s.shoulder});
  text += link(view, {s.shoulder, s.elbow});
  text += link(view, {s.elbow, s.corner, s.wrist});
  if (hand) text += link(view, {s.wrist, s.flange});
  text += dimensions(view, s, p);
  text +=
      coordinate_frame(view(s.base), {Direction{1, 0, 0}, Direction{0, 0, 1}, Direction{0, 1, 0}});
  text += coordinate_frame(
      view(s.flange), {on_page(s.tool.col(0)), on_page(s.tool.col(1)), on_page(s.tool.col(2))});
  // Beyond the arrows of their frames; numbers beside the places that frames have.
  constexpr Point kAside{-26, 24};
  const Point base = view(s.base);
  const Point flange = view(s.flange);
  const Vector3d& z = s.tool.col(2);
  const bool at_base = (s.shoulder - s.base).norm() < 1e-9;
  text += axis_mark({base.x, base.y - 78}, 1, s.axes[0]) +
          axis_mark(view(s.shoulder), 2, s.axes[1], at_base ? kAside : Point{}) +
          axis_mark(view(s.elbow), 3, s.axes[2]) +
          axis_mark(between(view, s.corner, s.wrist, 0.45), 4, s.axes[3]) +
          axis_mark(view(s.wrist), 5, s.axes[4], hand ? Point{} : kAside) +
          axis_mark({flange.x + 78 * z.x(), flange.y - 78 * z.z()}, 6, s.axes[5]);
  return text + notes(p);
}

std::string chain_drawing(const motion::RobotModel& robot) {
  constexpr double kBadge = 26;  // px: numbers that would lie on each other are so far apart
  const auto& chain = dynamic_cast<const motion::ChainKinematics&>(*robot.kinematics).chain();
  const std::vector<motion::JointChain::Line> lines = chain.lines(robot.start);
  const motion::Pose flange = chain.forward(robot.start);
  std::vector<Vector3d> points{Vector3d::Zero()};
  for (const motion::JointChain::Line& line : lines) points.push_back(line.point);
  points.push_back(flange.position);
  const View view(points);
  std::string text = drawing_frame(robot, "at its start, seen from its right side");
  text += ground(view(Vector3d::Zero()));
  text += link(view, points);
  text += coordinate_frame(view(Vector3d::Zero()),
                           {Direction{1, 0, 0}, Direction{0, 0, 1}, Direction{0, 1, 0}});
  const Matrix3d tool(flange.orientation);
  text += coordinate_frame(view(flange.position),
                           {on_page(tool.col(0)), on_page(tool.col(1)), on_page(tool.col(2))});
  std::vector<Point> marked;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    Point at = view(lines[i].point);
    const auto taken = [&](const Point& other) {
      return std::hypot(at.x - other.x, at.y - other.y) < kBadge - 1;
    };
    while (std::any_of(marked.begin(), marked.end(), taken)) at.x += kBadge;
    marked.push_back(at);
    text += axis_mark(at, static_cast<int>(i) + 1, lines[i].direction);
  }
  return text + notes_on_signs();
}

}  // namespace rob::test
