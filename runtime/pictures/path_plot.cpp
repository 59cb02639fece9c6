#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "runtime/pictures/path_svg.h"
#include "runtime/pictures/path_view.h"
#include "runtime/words/units.h"

namespace rob::runtime {

namespace {

/// A field of dots, two across and four up in each character (Unicode's block of braille patterns).
class Dots {
 public:
  Dots(int columns, int rows)
      : columns_(columns),
        rows_(rows),
        cells_(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), 0) {}

  int width() const { return 2 * columns_; }
  int height() const { return 4 * rows_; }

  void set(int x, int y) {
    if (x < 0 || y < 0 || x >= width() || y >= height()) return;
    // Unicode 15, 21.1: dots 1 to 3 and 7 are the left column from above, 4 to 6 and 8 the right
    // one.
    constexpr unsigned kBits[4][2] = {{0x01, 0x08}, {0x02, 0x10}, {0x04, 0x20}, {0x40, 0x80}};
    cells_[static_cast<std::size_t>(y / 4 * columns_ + x / 2)] |= kBits[y % 4][x % 2];
  }

  void line(double x0, double y0, double x1, double y1) {
    const int steps =
        1 + static_cast<int>(std::ceil(std::max(std::abs(x1 - x0), std::abs(y1 - y0))));
    for (int i = 0; i <= steps; ++i) {
      const double share = static_cast<double>(i) / steps;
      set(static_cast<int>(std::floor(x0 + share * (x1 - x0))),
          static_cast<int>(std::floor(y0 + share * (y1 - y0))));
    }
  }

  std::string text() const {
    std::string result;
    for (int row = 0; row < rows_; ++row) {
      std::string line;
      for (int column = 0; column < columns_; ++column)
        append(line, cells_[static_cast<std::size_t>(row * columns_ + column)]);
      result += line + "\n";
    }
    return result;
  }

 private:
  /// U+2800 and the dots, as UTF-8.
  static void append(std::string& line, unsigned dots) {
    line += '\xE2';
    line += static_cast<char>(0xA0U | (dots >> 6U));
    line += static_cast<char>(0x80U | (dots & 0x3FU));
  }

  int columns_;
  int rows_;
  std::vector<unsigned> cells_;
};

std::string plot(const PathView& view, const std::vector<ToolWay::Stretch>& stretches, int columns,
                 int rows) {
  // Dots of terminals are about as high as they are wide.
  const double scale =
      std::min((2.0 * columns - 1) / view.width(), (4.0 * rows - 1) / view.height());
  Dots dots(static_cast<int>(std::ceil((view.width() * scale + 1) / 2)),
            static_cast<int>(std::ceil((view.height() * scale + 1) / 4)));
  for (const ToolWay::Stretch& stretch : stretches)
    for (std::size_t i = 1; i < stretch.corners.size(); ++i) {
      const auto [x0, y0] = view.seen(stretch.corners[i - 1]);
      const auto [x1, y1] = view.seen(stretch.corners[i]);
      dots.line((x0 - view.left) * scale, (view.top - y0) * scale, (x1 - view.left) * scale,
                (view.top - y1) * scale);
    }
  return dots.text() + fmt::format("{} {} to {} mm, {} {} to {} mm\n", view.across,
                                   shown(view.left, 1), shown(view.right, 1), view.upward,
                                   shown(view.bottom, 1), shown(view.top, 1));
}

}  // namespace

std::string path_plot(const motion::RobotModel& robot, const ToolWay& way, int columns, int rows) {
  std::string text;
  for (const PathView& view : views_of(robot, way.stretches()))
    text += plot(view, way.stretches(), columns, rows);
  return text;
}

}  // namespace rob::runtime
