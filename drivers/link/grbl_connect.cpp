#include <algorithm>
#include <cmath>
#include <cstdio>

#include "drivers/link/grbl_link.h"

/// How grbl is found, what it tells of itself, and homing: everything that may take its time.
namespace rob::drivers {

using grbl::Line;
using motion::DriverError;

namespace {

constexpr double kBannerTime = 2;  // s: a board that its port has reset starts for 1.6 s
constexpr int kResets = 3;
constexpr double kSettingsTime = 2;  // s
constexpr double kGlance = 0.05;     // s [choice] between two looks at whether it is given up
constexpr double kHomingTime = 120;  // s [choice] for a large table at its seek rate
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

}  // namespace

void GrblLink::connect(SerialPort& port) {
  port_ = &port;
  reader_.clear();
  unread_ = {};
  gone_ = stopped_ = enabled_ = false;
  settled_ = true;
  reported_ = asked_ = 0;
  offset_ = {};
  greet();
  read_settings();
  check_settings();
  std::vector<int> letters;
  std::vector<double> steps;
  for (const WireAxis& axis : axes_) {
    letters.push_back(axis.address);
    steps.push_back(setting(kSteps + axis.address));
  }
  stream_.begin(letters, steps, kPeriod);
}

/// A reset, so that nothing of a former program is left in it.
void GrblLink::greet() {
  for (int i = 0; i < kResets; ++i) {
    send_byte(grbl::kReset);
    const double end = wire_time() + kBannerTime;
    Line line;
    while (next_line(line, end)) {
      if (line.kind != Line::Kind::Banner) continue;
      if (line.version >= kLeastVersion) return;
      throw DriverError("the firmware on " + port_->path() + " is '" + std::string(line.text) +
                        "'; Rob needs grbl 1.1 or grblHAL");
    }
    if (gone_) break;
  }
  if (gone_) {
    lost(*port_);
    throw DriverError(trouble());
  }
  throw DriverError("nothing on " + port_->path() +
                    " answers as grbl does; check power, cable and"
                    " baud rate (115200, or [wire] baud in the robot file)");
}

void GrblLink::carry_out(const std::string& text, double seconds, const std::string& what,
                         const std::function<bool()>& given_up) {
  send(text + "\n");
  const double end = wire_time() + seconds;
  Line line;
  while (!gone_ && wire_time() < end) {
    if (given_up && given_up()) {
      send_byte(grbl::kReset);
      throw DriverError(what +
                        " was given up: the machine has stopped, and its position is not known"
                        "; home it before it moves again");
    }
    if (!next_line(line, std::min(end, wire_time() + kGlance))) continue;
    if (line.kind == Line::Kind::Setting) settings_[line.number] = line.value;
    if (line.kind == Line::Kind::Ok) return;
    if (line.kind == Line::Kind::Error)
      throw DriverError(what + " failed: grbl error:" + std::to_string(line.number) + " " +
                        grbl::error_text(line.number));
    if (line.kind == Line::Kind::Alarm)
      throw DriverError(what + " failed: grbl ALARM:" + std::to_string(line.number) + " " +
                        grbl::alarm_text(line.number));
  }
  throw DriverError(what + " failed: grbl on " + port_->path() + " gives no answer");
}

void GrblLink::read_settings() {
  settings_.clear();
  carry_out("$$", kSettingsTime, "reading grbl's settings");
}

double GrblLink::setting(int number) const {
  const auto found = settings_.find(number);
  if (found == settings_.end())
    throw DriverError("grbl on " + port_->path() + " has no setting $" + std::to_string(number) +
                      "; it has fewer axes than the robot file, or is another firmware");
  return found->second;
}

/// grbl plans to stand at the end of what it has: in a look-ahead of T it reaches 2·a·T.
void GrblLink::check_settings() {
  if (const auto inches = settings_.find(kInches); inches != settings_.end() && inches->second != 0)
    throw DriverError("grbl reports in inches; write $13=0");
  for (const WireAxis& axis : axes_) {
    setting(kTravel + axis.address);
    if (setting(kSteps + axis.address) <= 0)
      throw DriverError("grbl's " + numbered(kSteps + axis.address, 0) +
                        " steps/mm is no number of"
                        " steps");
    const double speed = std::min(axis.most_step, setting(kMostRate + axis.address) / 60);
    const double acceleration = setting(kAccelerationSetting + axis.address);
    const double needed = speed / (2 * GrblStream::kAhead * kPeriod);
    if (acceleration >= needed) continue;
    throw DriverError("grbl's " + numbered(kAccelerationSetting + axis.address, acceleration) +
                      " mm/s^2 is too little for axis " + axis.name +
                      ": to follow at its speed takes " +
                      numbered(kAccelerationSetting + axis.address, std::ceil(needed)) +
                      "; write that, if the machine can, or lower v_max in the robot file");
  }
}

/// The travel counts where grbl holds to it itself, with its origin at the switches.
void GrblLink::take_limits() {
  limits_ = {};
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    const int letter = axes_[i].address;
    limits_.speed[i] = setting(kMostRate + letter) / 60;
    limits_.acceleration[i] = setting(kAccelerationSetting + letter);
    const auto soft = settings_.find(kSoftLimits);
    if (soft == settings_.end() || soft->second == 0) continue;
    limits_.min[i] = -setting(kTravel + letter) - offset_[i];
    limits_.max[i] = -offset_[i];
  }
}

void GrblLink::home(const std::function<bool()>& given_up) {
  carry_out("$H", kHomingTime, "homing", given_up);
  stopped_ = false;
}

}  // namespace rob::drivers
