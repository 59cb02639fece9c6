#include "drivers/link/grbl_setup.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include "drivers/link/grbl_stream.h"

namespace rob::drivers {

using grbl::Line;
using motion::DriverError;

namespace {

constexpr double kBannerTime = 2;  // s: a board that its port has reset starts for 1.6 s
constexpr int kResets = 3;
constexpr double kSettingsTime = 5;  // s in all
constexpr double kAskAgain = 0.5;    // s [choice] without a line, until $$ is asked for again
constexpr double kQuiet = 0.1;       // s [choice] until no answer to a former $$ can come any more
constexpr double kGlance = 0.05;     // s [choice] between two looks at whether it is given up
constexpr int kReports = 5;          // [choice] grblHAL's second report after a reset has WCO
constexpr double kReportTime = 0.2;  // s for a report
constexpr double kQueryTime = 2;     // s for $# and $G
constexpr int kLeastVersion = 101;   // 1.1: real-time commands, G93 with jogging beside it

constexpr int kSoftLimits = 20;
constexpr int kInches = 13;
constexpr int kSteps = 100;
constexpr int kMostRate = 110;  // mm/min
constexpr int kAccelerationSetting = 120;
constexpr int kTravel = 130;

std::string numbered(int number, double value) {
  char text[48];
  std::snprintf(text, sizeof text, "$%d=%.3f", number, value);
  return text;
}

[[noreturn]] void fail_gone(const GrblPort& port) {
  throw DriverError("the machine on " + port.path() + " is gone; check its power and its cable");
}

std::string refusal_of(const Line& line) {
  const bool error = line.kind == Line::Kind::Error;
  const char* const words = error ? grbl::error_text(line.number) : grbl::alarm_text(line.number);
  return (error ? "grbl error:" : "grbl ALARM:") + std::to_string(line.number) +
         (*words != '\0' ? " (" + std::string(words) + ")" : "");
}

bool refuses(const Line& line) {
  return line.kind == Line::Kind::Error || line.kind == Line::Kind::Alarm;
}

/// The lines of one answer up to its "ok"; none if nothing comes for `quiet` s, or grbl refuses.
template <typename Take>
bool take_answer(GrblPort& port, double quiet, double end, const Take& take) {
  Line line;
  double last = wire_time();
  while (!port.gone() && wire_time() < end && wire_time() - last < quiet) {
    if (!port.next_line(line, std::min({end, last + quiet, wire_time() + kGlance}))) continue;
    last = wire_time();
    if (line.kind == Line::Kind::Ok) return true;
    if (refuses(line)) return false;
    take(line);
  }
  if (port.gone()) fail_gone(port);
  return false;
}

/// WCO of a status report; none if no report has one.
std::optional<grbl_setup::Offset> reported_offset(GrblPort& port) {
  for (int i = 0; i < kReports; ++i) {
    port.send_byte(grbl::kStatusQuery);
    const double end = wire_time() + kReportTime;
    Line line;
    while (port.next_line(line, end)) {
      if (line.kind != Line::Kind::Status) continue;
      if (line.status.has_offset) return line.status.offset;
      break;
    }
    if (port.gone()) fail_gone(port);
  }
  return std::nullopt;
}

}  // namespace

// ---- settings

double GrblSettings::value_or(int number, double other) const {
  const auto found = values_.find(number);
  return found == values_.end() ? other : found->second;
}

double GrblSettings::braking_time(const std::vector<WireAxis>& axes) const {
  double longest = 0;
  for (const WireAxis& axis : axes)
    longest = std::max(longest, values_.at(kMostRate + axis.address) / 60 /
                                    values_.at(kAccelerationSetting + axis.address));
  return longest;
}

/// grbl plans to stand at the end of what it has: in a look-ahead of T it reaches 2·a·T.
void GrblSettings::check(const std::vector<WireAxis>& axes, const std::string& path) const {
  if (value_or(kInches, 0) != 0) throw DriverError("grbl reports in inches; write $13=0");
  std::string slow;
  std::string needs;
  for (const WireAxis& axis : axes) {
    for (const int number : {kSteps, kMostRate, kAccelerationSetting, kTravel})
      if (!values_.contains(number + axis.address))
        throw DriverError("grbl on " + path + " has no setting $" +
                          std::to_string(number + axis.address) +
                          "; it has fewer axes than the robot file, or is another firmware");
    if (steps(axis.address) <= 0)
      throw DriverError("grbl's " + numbered(kSteps + axis.address, steps(axis.address)) +
                        " is no number of steps per mm; write that of the machine");
    const double acceleration = values_.at(kAccelerationSetting + axis.address);
    const double speed = std::min(axis.most_step, values_.at(kMostRate + axis.address) / 60);
    const double needed = speed / (2 * GrblStream::kAhead * GrblStream::kPeriod);
    if (acceleration >= needed) continue;
    const std::string comma = slow.empty() ? "" : ", ";
    slow += comma + numbered(kAccelerationSetting + axis.address, acceleration) + " (axis " +
            axis.name + ")";
    needs += comma + numbered(kAccelerationSetting + axis.address, std::ceil(needed));
  }
  if (!slow.empty())
    throw DriverError(
        "grbl's accelerations are too low to follow the speed of the robot file: " + slow +
        " mm/s^2; write " + needs + ", if the machine can, or lower v_max in the robot file");
}

WireLimits GrblSettings::limits(const std::vector<WireAxis>& axes, const WireVector& offset) const {
  WireLimits limits;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const int letter = axes[i].address;
    limits.speed[i] = values_.at(kMostRate + letter) / 60;
    limits.acceleration[i] = values_.at(kAccelerationSetting + letter);
    if (value_or(kSoftLimits, 0) == 0) continue;
    limits.min[i] = -values_.at(kTravel + letter) - offset[i];
    limits.max[i] = -offset[i];
  }
  return limits;
}

// ---- conversation

namespace grbl_setup {

void greet(GrblPort& port) {
  for (int i = 0; i < kResets && !port.gone(); ++i) {
    port.send_byte(grbl::kReset);
    const double end = wire_time() + kBannerTime;
    Line line;
    while (port.next_line(line, end)) {
      if (line.kind != Line::Kind::Banner) continue;
      if (line.version >= kLeastVersion) return;
      throw DriverError("the firmware on " + port.path() + " is '" + std::string(line.text) +
                        "'; Rob needs grbl 1.1 or grblHAL");
    }
  }
  if (port.gone()) fail_gone(port);
  throw DriverError("nothing on " + port.path() +
                    " answers as grbl does; check power, cable and"
                    " baud rate (115200, or [wire] baud in the robot file)");
}

GrblSettings read_settings(GrblPort& port) {
  const double end = wire_time() + kSettingsTime;
  std::string refused;
  for (bool first = true; wire_time() < end; first = false) {
    std::map<int, double> values;
    port.send("$$\n");
    const bool whole = take_answer(port, kAskAgain, end, [&](const Line& line) {
      if (line.kind == Line::Kind::Setting) values[line.number] = line.value;
    });
    if (!whole || values.empty()) continue;
    if (!first) {  // nor is an answer to a former $$ taken for that of what comes next
      Line line;
      for (double last = wire_time(); port.next_line(line, last + kQuiet);) last = wire_time();
    }
    return GrblSettings(std::move(values));
  }
  throw DriverError("grbl on " + port.path() +
                    " does not list its settings ($$); check its power and its cable, and that no"
                    " other program uses it");
}

namespace {

/// The values of a parameter by axis. grbl's tool length is one number, along Z.
Offset along_axes(const Line& line) {
  if (line.name != "TLO" || line.values > 1) return line.parameter;
  return {0, 0, line.parameter[0]};
}

}  // namespace

Offset read_offset(GrblPort& port) {
  if (const auto reported = reported_offset(port)) return *reported;
  std::map<std::string, Offset, std::less<>> known;
  std::string modes;
  for (const char* const question : {"$#\n", "$G\n"}) {
    port.send(question);
    const double end = wire_time() + kQueryTime;
    const bool whole = take_answer(port, kQueryTime, end, [&](const Line& line) {
      if (line.kind == Line::Kind::Parameter) known[std::string(line.name)] = along_axes(line);
      if (line.kind == Line::Kind::Message && line.text.starts_with("[GC:")) modes = line.text;
    });
    if (!whole)
      throw DriverError("grbl on " + port.path() +
                        " does not give its work offset, neither in its reports nor by $#; set"
                        " $10 so that reports have WCO");
  }
  std::string active = "G54";
  for (const auto& [name, values] : known)
    if (name.starts_with("G5") && modes.find(name) != std::string::npos) active = name;
  Offset offset{};
  for (std::size_t i = 0; i < offset.size(); ++i)
    offset[i] = known[active][i] + known["G92"][i] + known["TLO"][i];
  return offset;
}

void carry_out(GrblPort& port, const std::string& text, double seconds, const std::string& what,
               const std::function<bool()>& given_up) {
  port.send(text + "\n");
  const double end = wire_time() + seconds;
  Line line;
  while (!port.gone() && wire_time() < end) {
    if (given_up && given_up()) {
      port.send_byte(grbl::kReset);
      throw DriverError(what +
                        " was given up: the machine has stopped, and its position is not known"
                        "; home it before it moves again");
    }
    if (!port.next_line(line, std::min(end, wire_time() + kGlance))) continue;
    if (line.kind == Line::Kind::Ok) return;
    if (refuses(line)) throw DriverError(what + " failed: " + refusal_of(line));
  }
  if (port.gone()) fail_gone(port);
  throw DriverError(what + " failed: grbl on " + port.path() + " gives no answer");
}

}  // namespace grbl_setup

}  // namespace rob::drivers
