#include "tests/emulators/grbl_emulator.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <utility>

namespace rob::test {

namespace {

constexpr std::size_t kPlanner = 15;
constexpr int kReceiveBuffer = 128;

std::string fixed(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3f", value);
  return text;
}

}  // namespace

GrblEmulator::GrblEmulator() {
  settings = {{0, 10}, {10, 1}, {11, 0.010}, {13, 0}, {20, 0}, {21, 0}, {22, 1}};
  for (int axis = 0; axis < kAxes; ++axis) {
    settings[100 + axis] = 250;
    settings[110 + axis] = 6000;
    settings[120 + axis] = 500;
    settings[130 + axis] = 400;
  }
}

void GrblEmulator::stand_at(double x, double y, double z) {
  const std::lock_guard lock(mutex_);
  here_ = planned_ = {x, y, z};
}

void GrblEmulator::raise_alarm(int number) {
  const std::lock_guard lock(mutex_);
  blocks_.clear();
  running_ = false;
  alarm_ = true;
  say("ALARM:" + std::to_string(number));
}

void GrblEmulator::restart() {
  const std::lock_guard lock(mutex_);
  reset();
}

std::array<double, GrblEmulator::kAxes> GrblEmulator::position() const {
  const std::lock_guard lock(mutex_);
  return here_;
}

double GrblEmulator::moved_for() const {
  const std::lock_guard lock(mutex_);
  return last_move_ - first_move_;
}

void GrblEmulator::set_offset(const std::array<double, kAxes>& now) {
  const std::lock_guard lock(mutex_);
  offset = now;
}

void GrblEmulator::hold() {
  const std::lock_guard lock(mutex_);
  held_ = !blocks_.empty();
}

void GrblEmulator::open_door() {
  const std::lock_guard lock(mutex_);
  door_ = held_ = true;
}

void GrblEmulator::override_feed(int percent) {
  const std::lock_guard lock(mutex_);
  override_ = percent;
  tell_override_ = true;
}

void GrblEmulator::take_foreign(const std::string& line) {
  const std::lock_guard lock(mutex_);
  foreign_ = true;
  carry_out(line);
  foreign_ = false;
}

bool GrblEmulator::idle() const {
  const std::lock_guard lock(mutex_);
  return blocks_.empty();
}

void GrblEmulator::say(const std::string& line) {
  if (foreign_) return;
  const std::string whole = line + "\r\n";
  answer(Octets(whole.begin(), whole.end()));
}

void GrblEmulator::ok() {
  if (!foreign_ && lost_oks > 0) {
    --lost_oks;
    return;
  }
  say("ok");
}

void GrblEmulator::reset() {
  if (!blocks_.empty() && pace_ > 0) alarm_ = true;  // in motion: the position is lost
  blocks_.clear();
  lines_.clear();
  line_.clear();
  buffered_ = 0;
  running_ = false;
  held_ = door_ = opens_door;
  pace_ = 1;
  override_ = 100;
  started_ = now() + starts_for;
  relative_ = inverse_time_ = false;
  planned_ = here_;
  reports_ = 0;
  alarm_ = alarm_ || locked;
  greets_ = true;
  if (starts_for == 0) greet();
}

void GrblEmulator::greet() {
  greets_ = false;
  say("");
  say(banner);
  if (alarm_) say("[MSG:'$H'|'$X' to unlock]");
}

void GrblEmulator::real_time(std::uint8_t byte) {
  switch (byte) {
    case '?':
      return report();
    case '!':
      held_ = held_ || !blocks_.empty();
      return;
    case '~':
      held_ = false;
      return;
    case 0x18:
      ++resets_;
      return reset();
    case 0x90:
      override_ = 100;
      return;
    case 0x85:
      std::erase_if(blocks_, [](const Block& block) { return block.jog; });
      return;
    default:
      return;  // overrides
  }
}

std::string GrblEmulator::state() const {
  if (alarm_) return "Alarm";
  if (door_) return "Door:1";
  if (held_) return pace_ > 0 ? "Hold:1" : "Hold:0";
  if (blocks_.empty()) return "Idle";
  return blocks_.front().jog ? "Jog" : "Run";
}

void GrblEmulator::report() {
  std::string text = "<" + state() + "|MPos:";
  for (int i = 0; i < kAxes; ++i)
    text += (i > 0 ? "," : "") + fixed(here_[static_cast<std::size_t>(i)]);
  text += "|Bf:" + std::to_string(kPlanner - blocks_.size()) + "," +
          std::to_string(kReceiveBuffer - buffered_) + "|FS:0,0";
  ++reports_;
  if (std::exchange(tell_override_, false) || reports_ % 20 == 0)
    text += "|Ov:" + std::to_string(override_) + ",100,100";
  if (offset_in_report > 0 && reports_ % 10 == offset_in_report) {
    text += "|WCO:";
    for (int i = 0; i < kAxes; ++i)
      text += (i > 0 ? "," : "") + fixed(offset[static_cast<std::size_t>(i)]);
  }
  say(text + ">");
}

void GrblEmulator::take(std::uint8_t byte) {
  if (now() < started_ && byte != 0x18) return;
  if (byte == '?' || byte == '!' || byte == '~' || byte == 0x18 || byte >= 0x80)
    return real_time(byte);
  if (++buffered_ > kReceiveBuffer) ++overflows_;
  if (byte != '\n') {
    line_ += static_cast<char>(byte);
    return;
  }
  lines_.push_back(line_);
  line_.clear();
  pass(now());
}

void GrblEmulator::carry_out(const std::string& line) {
  if (line.size() > 79) return say("error:11");
  if (error_next > 0) return say("error:" + std::to_string(error_next.exchange(0)));
  if (line.starts_with("$J=")) return g_code(line.substr(3), true);
  if (line.starts_with("$")) return system_command(line);
  if (alarm_) return say("error:9");
  g_code(line, false);
}

void GrblEmulator::system_command(const std::string& line) {
  if (line == "$$") {
    for (const auto& [number, value] : settings)
      say("$" + std::to_string(number) + "=" + fixed(value));
    return ok();
  }
  if (line == "$#") return list_parameters();
  if (line == "$G") {
    say("[GC:G0 G54 G17 G21 G90 G94 M5 M9 T0 F0 S0]");
    return ok();
  }
  if (line == "$X") {
    alarm_ = false;
    return ok();
  }
  if (line == "$H") {
    ++homing_;
    if (settings[22] == 0) return say("error:5");
    if (homes_on) return;
    alarm_ = locked = false;
    here_ = planned_ = {};
    return ok();
  }
  say("error:3");
}

/// The work offset is the sum of G54, G92 and, along Z, the tool's length.
void GrblEmulator::list_parameters() {
  constexpr double kOfG92 = 1;
  constexpr double kTool = 2;
  std::array<double, kAxes> g54 = offset;
  g54[0] -= kOfG92;
  g54[2] -= kTool;
  const auto list = [](const std::array<double, kAxes>& values) {
    return fixed(values[0]) + "," + fixed(values[1]) + "," + fixed(values[2]) + "]";
  };
  say("[G54:" + list(g54));
  say("[G55:" + list({50, 50, 50}));
  say("[G28:" + list({}));
  say("[G92:" + list({kOfG92, 0, 0}));
  say("[TLO:" + fixed(kTool) + "]");
  say("[PRB:0.000,0.000,0.000:0]");
  ok();
}

void GrblEmulator::g_code(const std::string& line, bool jog) {
  bool relative = relative_;
  bool inverse = inverse_time_;
  bool moves = false;
  bool has_feed = false;
  std::array<double, kAxes> target = planned_;
  for (std::size_t at = 0; at < line.size();) {
    const char letter = line[at];
    char* end = nullptr;
    const double value = std::strtod(line.c_str() + at + 1, &end);
    at = static_cast<std::size_t>(end - line.c_str());
    while (at < line.size() && line[at] == ' ') ++at;
    if (letter == 'G' && (value == 90 || value == 91)) relative = value == 91;
    if (letter == 'G' && (value == 93 || value == 94)) inverse = value == 93;
    if (letter == 'F') {
      feed_ = value;
      has_feed = true;
    }
    if (letter < 'X' || letter > 'Z') continue;
    const auto axis = static_cast<std::size_t>(letter - 'X');
    target[axis] = relative ? planned_[axis] + value : value + offset[axis];
    moves = true;
  }
  if (!jog) {
    relative_ = relative;
    inverse_time_ = inverse;
  }
  if (!moves) return ok();
  if ((inverse || jog) && !has_feed) return say("error:22");
  double way = 0;
  for (std::size_t i = 0; i < kAxes; ++i) way = std::hypot(way, target[i] - planned_[i]);
  // Nothing shorter than a step is planned.
  if (way * settings[100] >= 0.5) {
    blocks_.push_back({target, inverse && !jog ? 60 / feed_ : 60 * way / feed_, jog});
    planned_ = target;
    ++moves_;
  }
  ok();
}

void GrblEmulator::pass(double now) {
  if (last_ == 0 && starts_for > 0) say(banner);
  if (greets_ && now >= started_) greet();
  while (!lines_.empty() && blocks_.size() < kPlanner) {
    const std::string line = lines_.front();
    lines_.pop_front();
    buffered_ -= static_cast<int>(line.size()) + 1;
    carry_out(line);
  }
  run(now - last_);
  last_ = now;
}

/// A hold brakes, an override changes how fast the moves go.
void GrblEmulator::run(double seconds) {
  const double change = seconds / kBraking;
  pace_ = std::clamp(pace_ + (held_ ? -change : change), 0.0, 1.0);
  machine_time_ += pace_ * seconds * override_ / 100;
  while (!blocks_.empty()) {
    if (!running_) {
      running_ = true;
      from_ = here_;
      begun_ = machine_time_;
      if (first_move_ < 0) first_move_ = machine_time_;
    }
    const Block& block = blocks_.front();
    const double share = std::min((machine_time_ - begun_) / block.seconds, 1.0);
    for (std::size_t i = 0; i < kAxes; ++i)
      here_[i] = jammed ? here_[i] : from_[i] + share * (block.target[i] - from_[i]);
    if (share < 1) return;
    begun_ += block.seconds;
    from_ = block.target;
    last_move_ = begun_;
    blocks_.pop_front();
    running_ = !blocks_.empty();
  }
}

}  // namespace rob::test
