#include "tests/support/robot_drawing.h"

// From above: x to the right, y up, z towards the reader.

namespace rob::test {
namespace {

constexpr double kScale = 1000;  // px a metre
constexpr Point kOrigin{110, 450};

Point at(double x, double y) { return {kOrigin.x + x * kScale, kOrigin.y - y * kScale}; }

std::string rail(Point from, Point to) {
  return svg_line(from, to, "stroke=\"#94a3b8\" stroke-width=\"10\" stroke-linecap=\"round\"");
}

}  // namespace

std::string gantry_drawing(const motion::RobotModel& robot) {
  const motion::Axis& x = robot.axes[0];
  const motion::Axis& y = robot.axes[1];
  // The bridge stands where it would be seen, not at the start, which is the origin.
  const double bridge = x.min + 0.45 * (x.max - x.min);
  const double tool = y.min + 0.4 * (y.max - y.min);
  std::string text = drawing_frame(
      robot, "from above; the bridge stands away from its start, the origin, to be seen");
  text += svg_rect(at(x.min, y.max), (x.max - x.min) * kScale, (y.max - y.min) * kScale,
                   "fill=\"#f1f5f9\" stroke=\"#cbd5e1\" stroke-dasharray=\"4 4\"");
  text += rail({at(x.min, 0).x, at(0, y.min).y + 26}, {at(x.max, 0).x, at(0, y.min).y + 26});
  text += rail({at(x.min, 0).x, at(0, y.max).y - 26}, {at(x.max, 0).x, at(0, y.max).y - 26});
  text += svg_line({at(bridge, 0).x, at(0, y.min).y + 26}, {at(bridge, 0).x, at(0, y.max).y - 26},
                   "stroke=\"#cbd5e1\" stroke-width=\"22\" stroke-linecap=\"round\"");
  const Point carriage = at(bridge, tool);
  text += fmt::format(
      "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"20\" fill=\"#ffffff\" stroke=\"#475569\" "
      "stroke-width=\"2\"/>\n",
      carriage.x, carriage.y);
  text += coordinate_frame(carriage, {Direction{1, 0, 0}, Direction{0, 1, 0}, Direction{0, 0, -1}});
  text += svg_text({carriage.x + 26, carriage.y + 30}, "tool; theta turns it about z");
  text += coordinate_frame(at(0, 0), {Direction{1, 0, 0}, Direction{0, 1, 0}, Direction{0, 0, -1}});
  text += dimension(at(x.min, y.min), at(x.max, y.min), -52,
                    fmt::format("x {:g} mm", (x.max - x.min) * 1000));
  text += dimension(at(x.min, y.min), at(x.min, y.max), 40,
                    fmt::format("y {:g}", (y.max - y.min) * 1000));
  text += svg_text({kListLeft, 220}, "The lift moves the tool along z", "fill=\"#64748b\"");
  return text + svg_text({kListLeft, 238}, "between two ends; it is no axis.", "fill=\"#64748b\"");
}

}  // namespace rob::test
