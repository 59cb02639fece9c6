#include "runtime/pictures/path_svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "runtime/pictures/markup.h"
#include "runtime/pictures/path_view.h"
#include "runtime/run/line_text.h"
#include "runtime/words/units.h"

namespace rob::runtime {

namespace {

using Stretch = ToolWay::Stretch;

// px
constexpr double kWidth = 920;
constexpr double kMargin = 56;
constexpr double kMostHeight = 620;  // of a view
constexpr double kHeading = 44;

/// Okabe and Ito's colours, which people tell apart who see few colours, but yellow.
constexpr const char* kColours[] = {"#0072b2", "#d55e00", "#009e73",
                                    "#cc79a7", "#56b4e9", "#8a6d00"};

const char* colour_of(int line) {
  return kColours[static_cast<std::size_t>(line) % std::size(kColours)];
}

/// A view on the page: where its field begins, px, and px per mm.
struct Sheet {
  const PathView& view;
  double top = 0;
  double scale = 1;
  double left = kMargin;

  double height() const { return view.height() * scale; }
  double x(double mm) const { return left + (mm - view.left) * scale; }
  double y(double mm) const { return top + (view.top - mm) * scale; }
};

double scale_for(const PathView& view) {
  return std::min((kWidth - 2 * kMargin) / view.width(), kMostHeight / view.height());
}

std::string path_data(const PathView& view, const std::vector<Eigen::Vector3d>& points) {
  std::string text;
  for (const Eigen::Vector3d& point : points) {
    const auto [across, up] = view.seen(point);
    text += fmt::format("{}{} {}", text.empty() ? "M" : " L", shown(across, 4), shown(up, 4));
  }
  return text;
}

/// The lines of the grid that stand for whole multiples of a step, with their values.
std::string grid(const Sheet& sheet) {
  const PathView& view = sheet.view;
  const double step = view.grid_step();
  std::string text = "<g stroke=\"#e5e7eb\" font-size=\"11\" fill=\"#6b7280\">\n";
  for (double v = std::ceil(view.left / step) * step; v <= view.right; v += step)
    text += fmt::format(
        "<path d=\"M{0:.1f} {1:.1f} V{2:.1f}\"/><text x=\"{0:.1f}\" y=\"{3:.1f}\" "
        "text-anchor=\"middle\" stroke=\"none\">{4}</text>\n",
        sheet.x(v), sheet.top, sheet.top + sheet.height(), sheet.top + sheet.height() + 15,
        shown(v, 3));
  for (double v = std::ceil(view.bottom / step) * step; v <= view.top; v += step)
    text += fmt::format(
        "<path d=\"M{1:.1f} {0:.1f} H{2:.1f}\"/><text x=\"{3:.1f}\" y=\"{4:.1f}\" "
        "text-anchor=\"end\" stroke=\"none\">{5}</text>\n",
        sheet.y(v), sheet.x(view.left), sheet.x(view.right), sheet.left - 6, sheet.y(v) + 4,
        shown(v, 3));
  text += fmt::format(
      "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\" stroke=\"none\">{} mm</text>\n"
      "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\" stroke=\"none\">{} mm</text>\n",
      sheet.x(view.right), sheet.top + sheet.height() + 29, view.across, sheet.left - 6,
      sheet.top - 8, view.upward);
  return text + "</g>\n";
}

/// Lines that moved for less than a period have no stretch of their own: a point, then.
std::vector<Stretch> with_short_lines(const RunResult& result, const ToolWay& way) {
  std::vector<Stretch> stretches = way.stretches();
  std::set<int> drawn;
  for (const Stretch& stretch : stretches) drawn.insert(stretch.line);
  for (const LineResult& line : result.lines) {
    if (drawn.contains(line.line) || (line.way == 0 && !line.miss_planned)) continue;
    const Eigen::Vector3d place = way.at(line.starts);
    stretches.push_back({line.line, line.starts, line.starts, {place, place}});
  }
  return stretches;
}

std::string paths(const RunResult& result, const Sheet& sheet,
                  const std::vector<Stretch>& stretches) {
  std::string text = fmt::format(
      "<g id=\"{}\" transform=\"matrix({:.6g} 0 0 {:.6g} {:.6g} {:.6g})\" fill=\"none\" "
      "stroke-width=\"2\" stroke-linejoin=\"round\" stroke-linecap=\"round\">\n",
      sheet.view.id, sheet.scale, -sheet.scale, sheet.x(0), sheet.y(0));
  std::set<std::pair<int, std::string>> drawn;  // a loop draws its way once
  for (const Stretch& stretch : stretches) {
    std::string data = path_data(sheet.view, stretch.corners);
    if (!drawn.emplace(stretch.line, data).second) continue;
    text += fmt::format(
        "<path data-line=\"{}\" stroke=\"{}\" vector-effect=\"non-scaling-stroke\" d=\"{}\"/>\n",
        markup(line_text(stretch.line, result.used)), colour_of(stretch.line), data);
  }
  return text + "</g>\n";
}

/// Around a target that a corner misses, a circle as large as it is missed by.
std::string zones(const RunResult& result, const Sheet& sheet, const ToolWay& way) {
  std::map<int, double> misses;
  for (const LineResult& line : result.lines)
    if (line.miss_planned.value_or(0) > 0) misses[line.line] = *line.miss_planned;
  std::string text =
      "<g class=\"zones\" fill=\"#f59e0b\" fill-opacity=\"0.25\" "
      "stroke=\"#b45309\" stroke-width=\"0.7\">\n";
  std::set<std::string> drawn;
  for (const ToolWay::Target& target : way.targets()) {
    const auto miss = misses.find(target.line);
    if (miss == misses.end()) continue;
    const auto [across, up] = sheet.view.seen(target.place);
    std::string circle = fmt::format(
        "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\"><title>line {}: the corner is missed by "
        "{} mm</title></circle>\n",
        sheet.x(across), sheet.y(up), std::max(1.5, miss->second * sheet.scale),
        markup(line_text(target.line, result.used)), shown(miss->second, 2));
    if (drawn.insert(circle).second) text += circle;
  }
  return text + "</g>\n";
}

/// Numbers and times of lines, where there is room for them.
class Labels {
 public:
  explicit Labels(const Sheet& sheet) : sheet_(sheet) {}

  void add(const std::string& line, int tag, double starts, double takes,
           const std::vector<Eigen::Vector3d>& points) {
    const auto [across, up] = sheet_.view.middle_of(points);
    const std::string words = fmt::format("{}  {:.2f} s + {:.2f} s", line, starts, takes);
    constexpr double kLetter = 6.2;  // px
    constexpr double kLineHeight = 14;
    const Box box{sheet_.x(across) + 6, sheet_.y(up) - 6,
                  kLetter * static_cast<double>(words.size()), kLineHeight};
    if (std::ranges::any_of(taken_, [&](const Box& other) { return other.meets(box); })) return;
    taken_.push_back(box);
    text_ += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" fill=\"{}\">{}</text>\n", box.x, box.y,
                         colour_of(tag), markup(words));
  }
  std::string text() const {
    return "<g class=\"lines\" font-size=\"12\" stroke=\"#ffffff\" stroke-width=\"3\" "
           "paint-order=\"stroke\">\n" +
           text_ + "</g>\n";
  }

 private:
  struct Box {
    double x, y, width, height;
    bool meets(const Box& other) const {
      return x < other.x + other.width && other.x < x + width && y < other.y + other.height &&
             other.y < y + height;
    }
  };

  const Sheet& sheet_;
  std::vector<Box> taken_;
  std::string text_;
};

std::string labels(const RunResult& result, const Sheet& sheet,
                   const std::vector<Stretch>& stretches) {
  Labels labels(sheet);
  std::set<int> named;
  for (const Stretch& stretch : stretches) {
    if (!named.insert(stretch.line).second) continue;
    const LineResult line = [&] {
      for (const LineResult& each : result.lines)
        if (each.line == stretch.line) return each;
      return LineResult{};
    }();
    labels.add(line_text(stretch.line, result.used), stretch.line, line.starts, line.planned,
               stretch.corners);
  }
  return labels.text();
}

std::string heading(const RunResult& result, double total) {
  const std::string name = result.file.substr(result.file.rfind('/') + 1);
  return fmt::format(
      "<text x=\"{}\" y=\"26\" font-size=\"15\" font-weight=\"600\">{}</text>\n"
      "<text x=\"{}\" y=\"26\" text-anchor=\"end\" fill=\"#6b7280\">{}, law {}: {:.2f} s</text>\n",
      kMargin, markup(name), kWidth - kMargin, markup(result.robot), result.law, total);
}

}  // namespace

std::string path_svg(const RunResult& result, const motion::RobotModel& robot, const ToolWay& way) {
  const std::vector<Stretch> stretches = with_short_lines(result, way);
  std::string content;
  double bottom = kHeading;
  for (const PathView& view : views_of(robot, stretches)) {
    const double scale = scale_for(view);
    const Sheet sheet{view, bottom + 24, scale, (kWidth - view.width() * scale) / 2};
    content += grid(sheet) + paths(result, sheet, stretches) + zones(result, sheet, way) +
               labels(result, sheet, stretches);
    bottom = sheet.top + sheet.height() + 40;
  }
  return fmt::format(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" "
             "width=\"{0:.0f}\" height=\"{1:.0f}\" font-family=\"system-ui, sans-serif\" "
             "font-size=\"13\" fill=\"#111827\">\n"
             "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n",
             kWidth, bottom) +
         heading(result, result.planned) + content + "</svg>\n";
}

}  // namespace rob::runtime
