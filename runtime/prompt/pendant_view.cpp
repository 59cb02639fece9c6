#include "runtime/prompt/pendant_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>
#include <vector>

#include "lang/text/visible.h"
#include "motion/generate/limit_numbers.h"
#include "runtime/command/signal_access.h"
#include "runtime/prompt/pendant_keys.h"
#include "runtime/words/signature.h"
#include "runtime/words/units.h"

namespace rob::runtime {

namespace {

using lang::JogFrame;
using Lines = std::vector<std::string>;

constexpr int kLeastColumns = 40;
constexpr int kLeastRows = 12;

/// Lines that stay together. Where the rows do not suffice those of the highest rank go first, and
/// those of rank 0 stay.
struct Section {
  int rank = 0;
  Lines lines;
};
using Sections = std::vector<Section>;

/// The picture, and how much room there is.
struct Picture {
  const Pendant& pendant;
  const Snapshot& snapshot;
  bool wide = false;

  const motion::RobotModel& robot() const { return pendant.session().robot().robot(); }
  bool joint() const { return pendant.frame() == JogFrame::Joint; }
  /// '>' before what the keys + and - move.
  char mark(bool in_axes, int coordinate) const {
    const bool chosen = static_cast<std::size_t>(coordinate) == pendant.chosen();
    return chosen && in_axes == joint() ? '>' : ' ';
  }
};

const char* name_of(JogFrame frame) {
  return frame == JogFrame::Joint ? "joint" : frame == JogFrame::World ? "world" : "tool";
}

std::string head(const Picture& picture) {
  std::string text = picture.pendant.session().state_text();
  if (!picture.wide) text = text.substr(0, text.rfind(" ("));
  if (picture.pendant.has(JogFrame::Tool))
    text += fmt::format(", {} frame", name_of(picture.pendant.frame()));
  return "  " + text;
}

/// One a line with its range, or two a line.
Lines axes(const Picture& picture) {
  Lines lines;
  for (int i = 0; i < picture.robot().axis_count(); ++i) {
    const motion::Axis& axis = axis_of(picture.robot(), i);
    const double measured = picture.snapshot.measured[i] * shown_per_si(axis.kind);
    const char mark = picture.mark(true, i);
    if (picture.wide) {
      lines.push_back(fmt::format("{} {:<8}{:>12} {:<4} of {} to {}", mark, axis.name,
                                  fixed(measured, 3), unit_name(axis.kind),
                                  shown(axis.min * shown_per_si(axis.kind), 3),
                                  shown(axis.max * shown_per_si(axis.kind), 3)));
      continue;
    }
    if (i % 2 == 0) lines.emplace_back();
    lines.back() += fmt::format("{}{:<7.7}{:>8} {:<3}", mark, axis.name, fixed(measured, 2),
                                unit_name(axis.kind));
  }
  return lines;
}

/// In mm, or an angle of a pose in deg: -180 is written as 180, as HERE writes it.
std::string coordinate(const std::vector<double>& pose, std::size_t which) {
  const std::string text = fixed(pose[which], 2);
  return which >= 3 && text == "-180.00" ? text.substr(1) : text;
}

Lines tool(const Picture& picture) {
  const std::vector<double> pose =
      shown_pose(picture.robot().kinematics->forward(picture.snapshot.measured));
  constexpr std::string_view kNames = "xyzabc";
  Lines lines(2);
  for (int i = 0; i < 6; ++i)
    lines[i / 3] +=
        fmt::format("{}{}{:>9}", picture.mark(false, i), kNames[static_cast<std::size_t>(i)],
                    coordinate(pose, static_cast<std::size_t>(i)));
  lines[0] += " mm";
  lines[1] += " deg";
  return lines;
}

/// Those with a name: outputs, then inputs; where there is little room, those that are on.
Lines signals(const Picture& picture) {
  const Channels& channels = picture.pendant.session().robot().channels();
  std::array<std::string, 2> all{"  in ", "  out"};
  std::string on = "  on:";
  for (const auto& signal : signature_of(picture.robot()).signals) {
    if (signal.name.empty() || signal.analog) continue;
    const bool value = digital_value(channels, signal);
    all[signal.output ? 1 : 0] += fmt::format("  {} {}", signal.name, value ? "ON" : "off");
    if (value) on += " " + signal.name;
  }
  if (!picture.wide) return {on};
  Lines lines;
  for (const std::size_t kind : {1, 0})
    if (all[kind].size() > 5) lines.push_back(all[kind]);
  return lines;
}

std::string speed(const Pendant& pendant) {
  std::string text = fmt::format("  speed {:g} %  ", pendant.share() * 100);
  switch (pendant.style()) {
    case Pendant::Style::Hold:
      return text + "a key moves while held";
    case Pendant::Style::Pulse:
      return text + "a key moves for 0.3 s";
    case Pendant::Style::Step:
      break;
  }
  return text + fmt::format("a key steps {:g} mm or deg", pendant.step());
}

/// How what moves is stopped, and what bounds its speed.
std::string of_motion(const Picture& picture) {
  using motion::limit_number::kSpeed;
  if (!picture.pendant.moving()) return "";
  const bool pulse = picture.pendant.style() == Pendant::Style::Pulse;
  const std::string text = pulse ? "any other key stops" : "space stops";
  if (picture.snapshot.sample.limit == motion::limit_number::kBody)
    return text + "; it holds short of a body";
  const int axis = picture.snapshot.sample.limit - kSpeed;
  if (axis < 0 || axis >= picture.robot().axis_count()) return text;
  return fmt::format("{}; {} is at its top speed", text, axis_of(picture.robot(), axis).name);
}

/// Characters of UTF-8.
std::size_t width(std::string_view text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}

/// Pieces in as few lines as they fit in, each line after two blanks.
Lines filled(const Lines& pieces, std::string_view gap, int columns) {
  Lines lines;
  for (const std::string& piece : pieces) {
    const bool fits = !lines.empty() && width(lines.back()) + width(gap) + width(piece) <=
                                            static_cast<std::size_t>(columns);
    if (fits) {
      lines.back().append(gap).append(piece);
    } else {
      lines.push_back("  " + piece);
    }
  }
  return lines;
}

Lines words_of(std::string_view text) {
  Lines words;
  while (!text.empty()) {
    const std::size_t end = text.find(' ');
    if (end != 0) words.emplace_back(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return words;
}

/// A message in two lines at most.
Lines message(const Pendant& pendant, const std::string& told, int columns) {
  if (pendant.naming()) return {"  teach the point: " + *pendant.naming() + "_"};
  Lines lines = filled(words_of(told), " ", columns);
  lines.resize(std::clamp<std::size_t>(lines.size(), 1, 2));
  return lines;
}

/// At most so many characters.
std::string cut(const std::string& line, int columns) {
  std::size_t end = 0;
  for (int count = 0; end < line.size() && count < columns; ++count) {
    ++end;
    while (end < line.size() && (line[end] & 0xC0) == 0x80) ++end;
  }
  return line.substr(0, end);
}

Lines too_small(int columns, int rows) {
  const Lines words = words_of(
      fmt::format("the pendant needs {}x{} characters; this terminal has {}x{}. Esc leaves",
                  kLeastColumns, kLeastRows, columns, rows));
  return filled(words, " ", columns);
}

std::size_t size(const Sections& sections) {
  std::size_t lines = 0;
  for (const Section& section : sections) lines += section.lines.size();
  return lines;
}

Lines fitted(Sections sections, int rows) {
  while (size(sections) > static_cast<std::size_t>(rows)) {
    const auto least = std::ranges::max_element(sections, {}, &Section::rank);
    if (least->rank == 0) break;
    sections.erase(least);
  }
  Lines lines;
  for (Section& section : sections) std::ranges::move(section.lines, std::back_inserter(lines));
  return lines;
}

Sections drawn(const Picture& picture, const std::string& told, int columns, bool utf8) {
  Lines keys = acting_keys(picture.pendant);
  if (!utf8) std::ranges::transform(keys, keys.begin(), lang::in_ascii);
  const Section blank{4, {""}};
  return {{0, {head(picture)}},
          blank,
          {picture.joint() ? 0 : 2, axes(picture)},
          {picture.joint() ? 2 : 0, tool(picture)},
          {3, signals(picture)},
          blank,
          {0, {speed(picture.pendant)}},
          {0, message(picture.pendant, told.empty() ? of_motion(picture) : told, columns)},
          blank,
          {0, filled(keys, "  ", columns)}};
}

}  // namespace

bool fits_pendant(int columns, int rows) { return columns >= kLeastColumns && rows >= kLeastRows; }

std::string pendant_view(const Pendant& pendant, const std::string& told, int columns, int rows,
                         bool utf8) {
  Lines lines{"  " + pendant.session().state_text()};
  if (const auto& last = pendant.session().robot().reports().last()) {
    const Picture picture{pendant, *last, columns >= 80 && rows >= 24};
    lines = fitted(drawn(picture, told, columns, utf8), rows);
  }
  if (!fits_pendant(columns, rows)) lines = too_small(columns, rows);
  std::string text;
  for (std::size_t i = 0; i < lines.size() && i < static_cast<std::size_t>(rows); ++i) {
    const std::string line = lang::visible(lines[i]);
    if (i > 0) text += "\n";
    text += cut(utf8 ? line : lang::in_ascii(line), columns);
  }
  return text;
}

}  // namespace rob::runtime
