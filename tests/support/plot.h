#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "tests/support/svg.h"

namespace rob::test {

/// A picture's field with two scales. `corner`: its upper left one, px.
struct Plot {
  Point corner;
  double width = 0, height = 0;  ///< px
  double left = 0, right = 1;    ///< what its sides stand for
  double low = 0, high = 1;

  Point operator()(double x, double y) const {
    return {corner.x + (x - left) / (right - left) * width,
            corner.y + (high - y) / (high - low) * height};
  }

  std::string ground(const char* colour = "#f8fafc") const {
    return svg_rect(corner, width, height, std::string("rx=\"4\" fill=\"") + colour + "\"");
  }
  /// Lines across at whole multiples of a step, with their values; `sides`: also the x ones.
  std::string rules_y(double step) const {
    std::string text;
    for (double y = std::ceil(low / step) * step; y <= high + step * 1e-9; y += step) {
      const Point at = (*this)(left, y);
      text += svg_line(at, {at.x + width, at.y}, "stroke=\"#e2e8f0\"");
      text += svg_text({at.x - 8, at.y + 4}, number(y), "text-anchor=\"end\" fill=\"#64748b\"");
    }
    return text;
  }
  std::string rules_x(double step) const {
    std::string text;
    for (double x = std::ceil(left / step) * step; x <= right + step * 1e-9; x += step) {
      const Point at = (*this)(x, low);
      text += svg_line(at, {at.x, at.y - height}, "stroke=\"#e2e8f0\"");
      text += svg_text({at.x, at.y + 18}, number(x), "text-anchor=\"middle\" fill=\"#64748b\"");
    }
    return text;
  }
  /// Points of the scales, in this colour.
  std::string curve(const std::vector<Point>& points, const char* colour, double stroke = 1.8,
                    const char* more = "") const {
    std::vector<Point> placed;
    for (const Point& p : points) placed.push_back((*this)(p.x, p.y));
    return svg_curve(placed, fmt::format("stroke=\"{}\" stroke-width=\"{}\" "
                                         "stroke-linejoin=\"round\" {}",
                                         colour, stroke, more));
  }

 private:
  static std::string number(double value) {
    const double shown = std::abs(value) < 1e-9 ? 0 : value;
    return fmt::format("{}{:g}", shown < 0 ? "−" : "", std::abs(shown));
  }
};

}  // namespace rob::test
