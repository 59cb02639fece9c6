#pragma once

#include <fmt/format.h>

#include <fstream>
#include <string>
#include <utility>
#include <vector>

/// The pictures of docs/pictures that programs draw: pixels, y downwards.
namespace rob::test {

struct Point {
  double x = 0;
  double y = 0;
};

inline std::string svg_line(Point from, Point to, const std::string& style) {
  return fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" {}/>\n", from.x,
                     from.y, to.x, to.y, style);
}

inline std::string svg_rect(Point corner, double width, double height, const std::string& style) {
  return fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" {}/>\n",
                     corner.x, corner.y, width, height, style);
}

inline std::string svg_curve(const std::vector<Point>& points, const std::string& style) {
  std::string text;
  for (const Point& p : points) text += fmt::format("{:.1f},{:.1f} ", p.x, p.y);
  if (!text.empty()) text.pop_back();
  return fmt::format("<polyline points=\"{}\" fill=\"none\" {}/>\n", text, style);
}

inline std::string svg_text(Point at, const std::string& words, const std::string& style = "") {
  return fmt::format("<text x=\"{:.0f}\" y=\"{:.0f}\" {}>{}</text>\n", at.x, at.y, style, words);
}

/// Writes a picture; false if the file cannot be written.
inline bool save_svg(const std::string& file, double width, double height,
                     const std::string& content) {
  std::ofstream out(file);
  out << fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
      "height=\"{1}\" font-size=\"12.5\" fill=\"#334155\" font-family=\"system-ui, 'Segoe UI', "
      "Roboto, 'DejaVu Sans', sans-serif\">\n"
      "<rect width=\"100%\" height=\"100%\" rx=\"10\" fill=\"#ffffff\"/>\n{2}</svg>\n",
      width, height, content);
  return static_cast<bool>(out.flush());
}

}  // namespace rob::test
