#include "runtime/pictures/report_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "runtime/files/text_lines.h"
#include "runtime/pictures/body_lines.h"
#include "runtime/pictures/markup.h"
#include "runtime/pictures/report_template.h"
#include "runtime/run/json_report.h"
#include "runtime/run/line_text.h"
#include "runtime/words/units.h"

namespace rob::runtime {

namespace {

using Json = nlohmann::ordered_json;
using Rows = std::vector<RunCurves::Row>;
using Texts = std::map<std::string_view, std::string>;

/// Each {name} of the template that has a text is replaced by it, once.
std::string filled(std::string_view page, const Texts& texts) {
  std::string result;
  for (std::size_t at = 0; at < page.size();) {
    const std::size_t end = page[at] == '{' ? page.find('}', at) : std::string_view::npos;
    const auto text =
        end == std::string_view::npos ? texts.end() : texts.find(page.substr(at + 1, end - at - 1));
    if (text == texts.end()) {
      result += page[at++];
    } else {
      result += text->second;
      at = end + 1;
    }
  }
  return result;
}

/// A document inside a page: nothing in it may look like the end of its element.
std::string inside_page(std::string_view document) {
  std::string result;
  for (const char c : document) {
    if (c == '<') {
      result += "\\u003c";
    } else {
      result += c;
    }
  }
  return result;
}

/// "'sha256-…'", for a Content-Security-Policy: base64 (RFC 4648) of what CMake gives as hex.
std::string script_hash() {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const std::string hex(report_script_sha256());
  std::string bits;
  for (const char c : hex) {
    const int value = c <= '9' ? c - '0' : c - 'a' + 10;
    for (int bit = 3; bit >= 0; --bit) bits += (value >> bit) % 2 == 1 ? '1' : '0';
  }
  while (bits.size() % 6 != 0) bits += '0';
  std::string text;
  for (std::size_t at = 0; at < bits.size(); at += 6) {
    std::size_t value = 0;
    for (std::size_t bit = 0; bit < 6; ++bit) value = 2 * value + (bits[at + bit] == '1' ? 1 : 0);
    text += kDigits[value];
  }
  while (text.size() % 4 != 0) text += '=';
  return "'sha256-" + text + "'";
}

double rounded(double value, int decimals) {
  const double scale = std::pow(10, decimals);
  const double result = std::round(value * scale) / scale;
  return result == 0 ? 0 : result;
}

/// value(row) of each row.
template <typename Value>
Json column(const Rows& rows, int decimals, Value&& value) {
  Json values = Json::array();
  for (const RunCurves::Row& row : rows) values.push_back(rounded(value(row), decimals));
  return values;
}

/// For each axis a column of one of the vectors of a row, mm or deg.
template <typename Vector>
Json axis_columns(const motion::RobotModel& robot, const Rows& rows, Vector&& vector) {
  Json columns = Json::array();
  for (int i = 0; i < robot.axis_count(); ++i) {
    const double scale = shown_per_si(axis_of(robot, i).kind);
    columns.push_back(
        column(rows, 3, [&](const RunCurves::Row& row) { return vector(row)[i] * scale; }));
  }
  return columns;
}

/// x, y, z as columns.
template <typename Vector>
Json place_columns(const Rows& rows, double scale, Vector&& vector) {
  Json columns = Json::array();
  for (int i = 0; i < 3; ++i)
    columns.push_back(
        column(rows, 3, [&](const RunCurves::Row& row) { return vector(row)[i] * scale; }));
  return columns;
}

Json axes_json(const motion::RobotModel& robot) {
  Json axes = Json::array();
  for (const motion::Axis& axis : robot.axes) {
    const double scale = shown_per_si(axis.kind);
    axes.push_back({{"name", axis.name},
                    {"unit", unit_name(axis.kind)},
                    {"min", axis.min * scale},
                    {"max", axis.max * scale},
                    {"v_max", axis.v_max * scale},
                    {"a_max", axis.a_max * scale},
                    {"j_max", std::isfinite(axis.j_max) ? Json(axis.j_max * scale) : Json()}});
  }
  return axes;
}

Json lines_json(const std::vector<BodyLine>& lines) {
  Json values = Json::array();
  for (const BodyLine& line : lines)
    for (const Eigen::Vector3d& end : {line.from, line.to})
      for (int i = 0; i < 3; ++i) values.push_back(rounded(end[i] * kMillimetresPerMetre, 1));
  return values;
}

Json radii_json(const std::vector<BodyLine>& lines) {
  Json values = Json::array();
  for (const BodyLine& line : lines)
    values.push_back(rounded(line.radius * kMillimetresPerMetre, 2));
  return values;
}

/// The robot's bodies at some of the rows.
void put_bodies(Json& json, const motion::RobotModel& robot, const Rows& rows) {
  constexpr std::size_t kPostures = 400;  // [choice] more than a slider shows
  const std::size_t every = std::max<std::size_t>(1, rows.size() / kPostures);
  json["shape_t"] = Json::array();
  json["shapes"] = Json::array();
  json["radii"] = radii_json(lines_of_robot(robot, robot.start));
  for (std::size_t i = 0; i < rows.size(); i += every) {
    json["shape_t"].push_back(rounded(rows[i].reference.time, 4));
    json["shapes"].push_back(lines_json(lines_of_robot(robot, rows[i].reference.q)));
  }
  json["obstacles"] = Json::array();
  for (const motion::Obstacle& obstacle : robot.collision.obstacles) {
    const std::vector<BodyLine> lines = lines_of_obstacle(obstacle);
    json["obstacles"].push_back(
        {{"name", obstacle.name}, {"segments", lines_json(lines)}, {"radii", radii_json(lines)}});
  }
}

/// The lines of the rows, as numbers in a list of names.
void put_line_names(Json& json, const RunResult& result, const Rows& rows) {
  std::map<int, std::size_t> numbers;
  json["line"] = Json::array();
  json["line_names"] = Json::array();
  for (const RunCurves::Row& row : rows) {
    const auto [entry, added] = numbers.emplace(row.line, numbers.size());
    if (added) json["line_names"].push_back(line_text(row.line, result.used));
    json["line"].push_back(entry->second);
  }
}

std::string motion_json(const RunResult& result, const motion::RobotModel& robot,
                        const Rows& rows) {
  using Row = RunCurves::Row;
  Json json;
  json["axes"] = axes_json(robot);
  json["t"] = column(rows, 4, [](const Row& row) { return row.reference.time; });
  put_line_names(json, result, rows);
  json["q"] = axis_columns(robot, rows, [](const Row& row) { return row.reference.q; });
  json["qd"] = axis_columns(robot, rows, [](const Row& row) { return row.reference.qd; });
  json["qdd"] = axis_columns(robot, rows, [](const Row& row) { return row.reference.qdd; });
  json["tool"] = place_columns(rows, kMillimetresPerMetre, [](const Row& row) { return row.tool; });
  json["measured"] =
      place_columns(rows, kMillimetresPerMetre, [](const Row& row) { return row.tool_measured; });
  json["speed"] = column(rows, 2, [](const Row& row) { return row.speed * kMillimetresPerMetre; });
  json["late_us"] = column(rows, 1, [](const Row& row) { return row.lateness * 1e6; });
  json["force"] = nullptr;
  if (robot.force_sensor)
    json["force"] = place_columns(rows, 1, [](const Row& row) { return row.wrench.force; });
  put_bodies(json, robot, rows);
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string cell(const std::optional<double>& value, int decimals) {
  return "<td>" + (value ? fixed(*value, decimals) : "") + "</td>";
}

/// The table's rows, one for each line of the document.
std::string line_rows(const RunResult& result, const ReportAbout& about) {
  const std::vector<std::string> source = split_lines(about.source);
  std::string rows;
  for (const LineResult& line : result.lines) {
    const lang::Place place = lang::tagged_place(line.line);
    const std::string name = markup(line_text(line.line, result.used));
    rows += fmt::format("<tr data-line=\"{0}\"><td>{0}</td>", name) + cell(line.starts, 2) +
            cell(line.foretold ? std::optional(line.planned) : std::nullopt, 2);
    if (about.measured) rows += cell(line.measured, 2);
    rows += cell(line.miss_planned, 2);
    if (about.measured) rows += cell(line.miss_measured, 2);
    const bool shown_here = place.file == 0 && place.line >= 1 && place.line <= source.size();
    rows +=
        "<td class=\"code\">" + (shown_here ? markup(source[place.line - 1]) : "") + "</td></tr>\n";
  }
  return rows;
}

std::string findings(const RunResult& result) {
  if (result.findings.empty() && !result.error) return "<p class=\"note\">None.</p>\n";
  std::string items;
  const auto add = [&](bool error, const lang::Place& place, const std::string& code,
                       const std::string& message, const std::string& help) {
    items += fmt::format("<li{}>", error ? " class=\"error\"" : "");
    if (place.line > 0) items += fmt::format("line {}: ", place.line);
    items += fmt::format("{} ({})", markup(message), markup(code));
    if (!help.empty()) items += "<br><span class=\"note\">" + markup(help) + "</span>";
    items += "</li>\n";
  };
  if (result.error) {
    const Problem& error = *result.error;
    add(true, error.place, error.code, error.message, error.help);
  }
  for (const lang::Diagnostic& finding : result.findings)
    if (finding.severity != lang::Severity::Error || !result.error)
      add(finding.severity == lang::Severity::Error, finding.place, finding.code, finding.message,
          finding.help);
  return "<ul>\n" + items + "</ul>\n";
}

std::string summary(const RunResult& result, const motion::RobotModel& robot,
                    const ReportAbout& about) {
  std::string text = fmt::format("robot {}, law {}, ", markup(robot.name), result.law);
  if (about.measured) {
    text += fmt::format("{}, measured {:.2f} s", markup(result.status), result.measured);
    if (result.foretold) text += fmt::format(", planned {:.2f} s", result.planned);
    text += fmt::format(", {} clock", result.clock);
  } else {
    text += fmt::format("foretold {:.2f} s", result.planned);
  }
  return text + fmt::format(", seed {}, {}", about.seed, markup(about.version));
}

}  // namespace

std::string report_page(const RunResult& result, const motion::RobotModel& robot,
                        const RunCurves& curves, const ReportAbout& about) {
  const Rows rows = curves.rows();
  std::string document;
  const auto put = [&](std::string_view piece) { document += piece; };
  if (about.measured) {
    put_run_json(result, 0, put);
  } else {
    put_check_json(result, 0, put);
  }
  const std::string name = result.file.substr(result.file.rfind('/') + 1);
  const std::string thinned =
      curves.every() == 1
          ? "The curves show every reference period."
          : fmt::format("The curves show one of {} reference periods.", curves.every());
  return filled(report_template(), {{"script_hash", script_hash()},
                                    {"title", markup(name)},
                                    {"about", summary(result, robot, about)},
                                    {"findings", findings(result)},
                                    {"reference_word", about.measured ? "reference" : "foretold"},
                                    {"decimated", thinned},
                                    {"measured_heads", about.measured ? "<th>measured</th>" : ""},
                                    {"miss_heads", about.measured ? "<th>measured</th>" : ""},
                                    {"rows", line_rows(result, about)},
                                    {"document", inside_page(document)},
                                    {"motion", inside_page(motion_json(result, robot, rows))},
                                    {"script", std::string(report_script())}});
}

}  // namespace rob::runtime
