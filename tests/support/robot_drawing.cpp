#include "tests/support/robot_drawing.h"

#include <algorithm>
#include <cmath>

namespace rob::test {
namespace {

constexpr double kDegree = 3.14159265358979323846 / 180;
constexpr double kFrameLength = 36;  // px of a coordinate axis

std::string in_words(double value, motion::AxisKind kind) {
  const bool linear = kind == motion::AxisKind::Linear;
  // Adding 0 makes 0 of -0.
  return linear ? fmt::format("{:g} mm", value * 1000 + 0)
                : fmt::format("{:g}°", std::round(value / kDegree * 1e6) / 1e6 + 0);
}

std::string minus_signs(std::string text) {
  for (std::size_t at; (at = text.find('-')) != std::string::npos;) text.replace(at, 1, "−");
  return text;
}

}  // namespace

std::string drawing_frame(const motion::RobotModel& robot, const std::string& view) {
  const std::string grey = "fill=\"#64748b\"";
  std::string text = svg_text({36, 34}, robot.name, "font-size=\"17\" font-weight=\"600\"");
  text += svg_text({36, 54}, view, grey);
  double y = 96;
  text += svg_text({kListLeft, y}, "axis", grey);
  text += svg_text({kListLeft + 64, y}, "from … to", grey);
  text += svg_text({kDrawingWidth - 36, y}, "at start", grey + " text-anchor=\"end\"");
  for (int i = 0; i < robot.axis_count(); ++i) {
    const motion::Axis& axis = robot.axes[static_cast<std::size_t>(i)];
    y += 22;
    text += svg_text({kListLeft, y}, fmt::format("{}  {}", i + 1, axis.name));
    text += svg_text({kListLeft + 64, y}, minus_signs(in_words(axis.min, axis.kind) + " … " +
                                                      in_words(axis.max, axis.kind)));
    text += svg_text({kDrawingWidth - 36, y}, minus_signs(in_words(robot.start[i], axis.kind)),
                     "text-anchor=\"end\"");
  }
  return text;
}

std::string arrow(Point from, Point to, const char* colour) {
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  const double ux = (to.x - from.x) / length;
  const double uy = (to.y - from.y) / length;
  const Point neck{to.x - 9 * ux, to.y - 9 * uy};
  return svg_line(from, neck, fmt::format("stroke=\"{}\" stroke-width=\"2\"", colour)) +
         fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}L{:.1f} {:.1f}Z\" fill=\"{}\"/>\n",
                     to.x, to.y, neck.x - 4 * uy, neck.y + 4 * ux, neck.x + 4 * uy, neck.y - 4 * ux,
                     colour);
}

std::string dimension(Point from, Point to, double away, const std::string& words) {
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  const Point u{(to.x - from.x) / length, (to.y - from.y) / length};
  const Point n{u.y, -u.x};  // to the left of the way, y being downwards
  const auto beside = [&](Point p, double d) { return Point{p.x + d * n.x, p.y + d * n.y}; };
  const std::string thin = "stroke=\"#94a3b8\"";
  std::string text;
  for (const Point end : {from, to}) {
    text += svg_line(beside(end, std::copysign(10, away)),
                     beside(end, away + std::copysign(5, away)), thin);
    const Point tick = beside(end, away);
    text += svg_line({tick.x - 4 * (u.x + n.x), tick.y - 4 * (u.y + n.y)},
                     {tick.x + 4 * (u.x + n.x), tick.y + 4 * (u.y + n.y)},
                     "stroke=\"#475569\" stroke-width=\"1.4\"");
  }
  text += svg_line(beside(from, away), beside(to, away), thin);
  // The words stand beside the line, on its far side.
  const Point middle = beside({(from.x + to.x) / 2, (from.y + to.y) / 2},
                              away + std::copysign(std::abs(n.x) > 0.5 ? 7 : 9, away));
  const double side = n.x * away;
  const char* anchor = side < -0.3 * std::abs(away)  ? "end"
                       : side > 0.3 * std::abs(away) ? "start"
                                                     : "middle";
  const double drop = n.y * away > 0.5 * std::abs(away) ? 8 : 4;
  return text +
         svg_text({middle.x, middle.y + drop}, words, fmt::format("text-anchor=\"{}\"", anchor));
}

std::string coordinate_frame(Point at, const std::array<Direction, 3>& axes) {
  constexpr std::array<const char*, 3> kColours = {kRed, kGreen, kBlue};
  constexpr std::array<const char*, 3> kNames = {"x", "y", "z"};
  std::string text;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& [right, up, into] = axes[i];
    const std::string fill = fmt::format("fill=\"{}\" font-weight=\"600\"", kColours[i]);
    if (std::hypot(right, up) > 0.3) {
      const Point tip{at.x + kFrameLength * right, at.y - kFrameLength * up};
      text += arrow(at, tip, kColours[i]);
      text += svg_text({tip.x + 10 * right - 4, tip.y - 10 * up + 4}, kNames[i], fill);
      continue;
    }
    // Seen from its end: a cross goes into the page, a dot comes out of it.
    text += fmt::format(
        "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"6\" fill=\"#ffffff\" stroke=\"{}\" "
        "stroke-width=\"1.8\"/>\n",
        at.x, at.y, kColours[i]);
    const std::string stroke = fmt::format("stroke=\"{}\" stroke-width=\"1.6\"", kColours[i]);
    if (into > 0) {
      text += svg_line({at.x - 4, at.y - 4}, {at.x + 4, at.y + 4}, stroke);
      text += svg_line({at.x - 4, at.y + 4}, {at.x + 4, at.y - 4}, stroke);
    } else {
      text += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2\" fill=\"{}\"/>\n", at.x, at.y,
                          kColours[i]);
    }
    text += svg_text({at.x - 18, at.y + 16}, kNames[i], fill);
  }
  return text;
}

}  // namespace rob::test
