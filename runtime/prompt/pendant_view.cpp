#include "runtime/prompt/pendant_view.h"

#include <fmt/format.h>

#include <vector>

#include "lang/text/visible.h"
#include "motion/generate/limit_numbers.h"
#include "runtime/command/signal_access.h"
#include "runtime/words/signature.h"
#include "runtime/words/units.h"

namespace rob::runtime {

namespace {

using lang::JogFrame;
using Lines = std::vector<std::string>;

const char* name_of(JogFrame frame) {
  return frame == JogFrame::Joint ? "joint" : frame == JogFrame::World ? "world" : "tool";
}

const char* name_of(Pendant::Style style) {
  switch (style) {
    case Pendant::Style::Hold:
      return "a key that is held moves";
    case Pendant::Style::Pulse:
      return "a key moves for 0.3 s, repeats prolong it, any other key stops";
    case Pendant::Style::Step:
      break;
  }
  return "a key is a step";
}

/// What holds the robot, in words; empty: nothing that a person must know.
std::string limit_text(int limit, const motion::RobotModel& robot) {
  using namespace motion::limit_number;
  const auto axis = [&](int first) { return axis_of(robot, limit - first).name; };
  const int axes = robot.axis_count();
  if (limit >= kEndOfAxis && limit < kEndOfAxis + axes)
    return fmt::format("axis {} is at its limit", axis(kEndOfAxis));
  if (limit == kReach) return "the arm reaches no further";
  if (limit >= kSpeed && limit < kSpeed + axes)
    return fmt::format("axis {} goes as fast as it can", axis(kSpeed));
  return "";
}

/// One a line: the chosen one is marked.
void add_axes(const Pendant& pendant, const Snapshot& snapshot, Lines& lines) {
  const motion::RobotModel& robot = pendant.session().robot().robot();
  const bool joint = pendant.frame() == JogFrame::Joint;
  for (int i = 0; i < robot.axis_count(); ++i) {
    const motion::Axis& axis = axis_of(robot, i);
    const bool chosen = joint && static_cast<std::size_t>(i) == pendant.chosen();
    const double per_si = shown_per_si(axis.kind);
    lines.push_back(fmt::format("{} {:<8}{:>12.3f} {:<4} of {:g} … {:g}", chosen ? ">" : " ",
                                axis.name, snapshot.measured[i] * per_si + 0.0,
                                unit_name(axis.kind), axis.min * per_si, axis.max * per_si));
  }
}

void add_pose(const Pendant& pendant, const Snapshot& snapshot, Lines& lines) {
  const motion::RobotModel& robot = pendant.session().robot().robot();
  const std::vector<double> pose = shown_pose(robot.kinematics->forward(snapshot.measured));
  lines.push_back(
      fmt::format("  tool   x {:.2f}  y {:.2f}  z {:.2f} mm   a {:.2f}  b {:.2f}  c {:.2f} deg",
                  pose[0] + 0.0, pose[1] + 0.0, pose[2] + 0.0, pose[3], pose[4], pose[5]));
}

/// Those with a name: outputs, then inputs.
void add_signals(const Pendant& pendant, Lines& lines) {
  const Channels& channels = pendant.session().robot().channels();
  for (const bool output : {true, false}) {
    std::string text = output ? "  out " : "  in  ";
    for (const auto& signal : signature_of(pendant.session().robot().robot()).signals) {
      if (signal.name.empty() || signal.analog || signal.output != output) continue;
      text += fmt::format("  {} {}", signal.name, digital_value(channels, signal) ? "ON" : "off");
    }
    if (text.size() > 6) lines.push_back(text);
  }
}

void add_mode(const Pendant& pendant, Lines& lines) {
  std::string names;
  const std::vector<std::string> coordinates = pendant.coordinates();
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    const bool chosen = i == pendant.chosen();
    names +=
        fmt::format("{}{} {}{}", chosen ? " [" : "  ", i + 1, coordinates[i], chosen ? "]" : " ");
  }
  lines.push_back(fmt::format("  {} frame  {}", name_of(pendant.frame()), names));
  lines.push_back(fmt::format("  speed {:g} %   step {:g} mm or deg   {}", pendant.share() * 100,
                              pendant.step(), name_of(pendant.style())));
}

constexpr const char* kKeys[] = {
    "  ← → ↓ ↑ PgDn PgUp  the first three −/+     1…9 choose   + − move the chosen",
    "  j joint  w world  t tool    [ ] speed    , . step    m steps, or hold",
    "  l lift  g gripper  o 1…9 output   p teach   space stop   Esc leave",
};

/// At most so many characters of UTF-8.
std::string cut(const std::string& line, int columns) {
  std::size_t end = 0;
  for (int count = 0; end < line.size() && count < columns; ++count) {
    ++end;
    while (end < line.size() && (line[end] & 0xC0) == 0x80) ++end;
  }
  return line.substr(0, end);
}

}  // namespace

std::string pendant_view(const Pendant& pendant, const std::string& told, int columns, int rows) {
  Lines lines;
  lines.push_back("  " + pendant.session().state_text());
  lines.emplace_back();
  if (const auto& last = pendant.session().robot().reports().last()) {
    add_axes(pendant, *last, lines);
    add_pose(pendant, *last, lines);
    add_signals(pendant, lines);
    lines.emplace_back();
    add_mode(pendant, lines);
    lines.push_back("  " + limit_text(last->sample.limit, pendant.session().robot().robot()));
  }
  lines.push_back("  " + told);
  if (pendant.naming()) lines.push_back("  teach the point: " + *pendant.naming() + "_");
  lines.emplace_back();
  for (const char* const keys : kKeys) lines.emplace_back(keys);
  std::string text;
  for (std::size_t i = 0; i < lines.size() && i < static_cast<std::size_t>(rows); ++i) {
    if (i > 0) text += "\n";
    text += cut(lang::visible(lines[i]), columns);
  }
  return text;
}

}  // namespace rob::runtime
