#include "drivers/link/grbl_link.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace rob::drivers {

using grbl::Line;
using grbl::Machine;
using motion::DriverError;
using motion::DriverStatus;

namespace {

constexpr double kQueryPeriod = 0.1;  // s: the wiki advises 5 to 10 Hz
constexpr double kLookPeriod = 0.05;  // s [choice] while its buffer is full, or Rob waits for it
constexpr double kAnswerTime = 0.5;   // s [choice] for "ok" and for a report; five queries
constexpr double kTravelTime = 0.06;  // s [choice] for a line to grbl and its "ok" back
constexpr double kQueueTime = 2;      // s for grbl to execute the moves it has received
constexpr double kHomingTime = 120;   // s [choice] for a large table at its seek rate
constexpr double kSameOffset = 2e-3;  // mm: two units of the last place of a report
constexpr double kCatchUp = 1.1;      // of v_max: the speed limit while a late thread catches up
constexpr int kBitsPerByte = 10;
constexpr int kBytesPerSecond = 4000;  // 50 lines of at most 80 bytes
// s by which grbl may lag the references: Rob does not know exactly when its moves began. [choice]
// twice the look-ahead, so that a computer may be late by as much
constexpr double kWindow = 0.2;

struct Interference {
  Machine machine;
  const char* what;
  const char* remedy;
};
constexpr Interference kInterferences[] = {
    {Machine::Hold, "it was put on hold at the machine (feed hold)",
     "release the hold there (cycle start or reset), then start again"},
    {Machine::Door, "its safety door is open", "close the door, then start again"},
    {Machine::Check, "it is in check mode", "end that with $C, then start again"},
    {Machine::Tool, "it waits for another tool", "change it, or reset grbl, then start again"},
    {Machine::Sleep, "it is asleep", "wake it with a reset, then start again"},
    {Machine::Home, "it is homing, which Rob did not ask for",
     "wait until it has ended, then start again"},
    {Machine::Jog, "it is jogged at the machine or by another program",
     "let nothing else move it while Rob does, then start again"}};

std::string with_words(const char* what, int number, const char* words) {
  std::string text = what + std::to_string(number);
  if (*words != '\0') text += std::string(": ") + words;
  return text;
}

}  // namespace

GrblLink::GrblLink(const std::vector<WireAxis>& axes, int baud) : axes_(axes), baud_(baud) {}

void GrblLink::connect(WirePort& port) {
  if (baud_ < kBytesPerSecond * kBitsPerByte)
    throw DriverError("at " + std::to_string(baud_) +
                      " baud the moves do not reach grbl in time; set 57600 baud or more, there"
                      " and in [wire] baud of the robot file");
  port_.attach(port);
  stopped_ = enabled_ = false;
  settled_ = true;
  reported_ = asked_ = waiting_ = sent_ = 0;
  grbl_setup::greet(port_);
  settings_ = grbl_setup::read_settings(port_);
  settings_.check(axes_, port_.path());
  const grbl_setup::Offset offset = grbl_setup::read_offset(port_);
  std::vector<int> letters;
  std::vector<double> steps;
  std::vector<double> speeds;
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    const int letter = axes_[i].address;
    offset_[i] = offset[static_cast<std::size_t>(letter)];
    letters.push_back(letter);
    steps.push_back(settings_.steps(letter));
  }
  limits_ = settings_.limits(axes_, offset_);
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    const double most = axes_[i].most_step;
    speeds.push_back(most > 0 ? std::min(most * kCatchUp, limits_.speed[i]) : limits_.speed[i]);
  }
  stream_.begin(letters, steps, kPeriod, speeds);
}

void GrblLink::home(const std::function<bool()>& given_up) {
  if (!settings_.homes())
    throw DriverError(
        "homing is switched off in grbl ($22=0); write $22=1 if the machine has"
        " homing switches, otherwise leave out --home");
  grbl_setup::carry_out(port_, "$H", kHomingTime, "homing", given_up);
  stopped_ = false;
}

DriverStatus GrblLink::enable() noexcept {
  stream_.stand_at(position_);
  told_.clear();
  port_.send_byte(grbl::kFeedAt100);
  remark("grbl counts its own steps, so no encoder and no blocked axis is the cause",
         "check for another program or pendant that moves the machine, for an override there, and"
         " for settings that are too slow ($110, $120)");
  enabled_ = true;
  return port_.gone() ? lost(port_.port()) : DriverStatus::Ok;
}

/// Waits until grbl has executed all moves. If an error has stopped the stream, or grbl does not
/// answer, brakes it and drops the remaining moves.
void GrblLink::disable() noexcept {
  enabled_ = false;
  stream_.flush();
  if (!stopped_ && run_dry()) return;
  if (!port_.gone() && machine_ != Machine::Alarm) brake();
}

/// Waits until grbl stands at the end of its moves. Returns false if it does not answer or takes
/// too long.
bool GrblLink::run_dry() noexcept {
  const double end = wire_time() + kQueueTime;
  machine_ = Machine::Unknown;
  while (!port_.gone() && !stopped_ && wire_time() < end) {
    if (machine_ == Machine::Idle && stream_.open_lines() == 0) return true;
    if (silence(wire_time()) > kAnswerTime) return false;
    query(kLookPeriod);
    stream(nullptr);
    Line line;
    while (!stopped_ && port_.next_line(line, wire_time() + kLookPeriod)) {
      take(line);
      if (line.kind == Line::Kind::Status) break;
    }
  }
  return false;
}

/// Resets grbl, which drops the remaining moves, only after it stands: so it keeps its position.
void GrblLink::brake() noexcept {
  port_.send_byte(grbl::kFeedHold);
  wait_for(Machine::Hold, settings_.braking_time(axes_) + kQueryPeriod);
  port_.send_byte(grbl::kReset);
}

bool GrblLink::wait_for(Machine machine, double seconds) noexcept {
  const double end = wire_time() + seconds;
  machine_ = Machine::Unknown;
  const auto reached = [&] { return machine_ == machine && phase_ == 0; };
  while (!port_.gone() && !reached() && machine_ != Machine::Alarm && wire_time() < end) {
    query(kLookPeriod);
    Line line;
    const double look = std::min(end, wire_time() + kLookPeriod);
    while (!reached() && port_.next_line(line, look))
      if (line.kind == Line::Kind::Status) take_status(line.status);
  }
  return reached();
}

DriverStatus GrblLink::exchange(const WireCommand* command, double deadline,
                                WireAnswer& answer) noexcept {
  DriverStatus status = DriverStatus::Ok;
  const double reported = reported_;
  const bool first = reported_ == 0;
  query(stream_.full() ? kLookPeriod : kQueryPeriod);
  Line line;
  while (port_.next_line(line, first && reported_ == 0 ? deadline : 0)) {
    const DriverStatus found = take(line);
    if (status == DriverStatus::Ok) status = found;
  }
  if (deserted(command)) stream_.drop_waiting();
  if (reported != reported_) fill(answer);
  if (status == DriverStatus::Ok) status = stream(command);
  if (port_.gone()) return lost(port_.port());
  return status == DriverStatus::Ok ? check_answers(wire_time()) : status;
}

/// Whether references have been missing for longer than grbl had moves: Rob then drops the waiting
/// lines.
bool GrblLink::deserted(const WireCommand* command) const noexcept {
  return enabled_ && command == nullptr && !told_.empty() &&
         wire_time() - told_.back().time > kWindow;
}

void GrblLink::fill(WireAnswer& answer) noexcept {
  if (deserted(nullptr)) {
    // grbl comes to rest by itself; the next motion begins there.
    if (machine_ != Machine::Idle) return;
    stream_.stand_at(position_);
    told_.clear();
  }
  const bool first = answer.seen == 0;
  const double time = std::max(instant_of_report(), answer.time);
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    const double since = std::max(time - answer.time, kPeriod);
    const bool held = machine_ == Machine::Hold && phase_ == 0;
    const bool stands = first || held || machine_ == Machine::Idle || stream_.standing();
    answer.velocity[i] = stands ? 0 : (position_[i] - answer.position[i]) / since;
    answer.position[i] = position_[i];
  }
  answer.time = time;
  answer.seen = reported_;
}

/// The instant at which the path of the references, within the last kWindow, was nearest to the
/// reported position.
double GrblLink::instant_of_report() const noexcept {
  if (!enabled_ || stream_.standing() || told_.empty()) return reported_;
  double best = reported_ - stream_.lag();
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k + 1 < told_.size(); ++k) {
    const WireCommand& a = told_[k];
    const WireCommand& b = told_[k + 1];
    double along = 0;
    double length = 0;
    for (std::size_t i = 0; i < axes_.size(); ++i) {
      const double way = b.position[i] - a.position[i];
      along += way * (position_[i] - a.position[i]);
      length += way * way;
    }
    const double share = length > 0 ? std::clamp(along / length, 0.0, 1.0) : 0;
    double distance = 0;
    for (std::size_t i = 0; i < axes_.size(); ++i)
      distance = std::hypot(distance,
                            a.position[i] + share * (b.position[i] - a.position[i]) - position_[i]);
    if (distance >= least) continue;
    least = distance;
    best = a.time + share * (b.time - a.time);
  }
  return best;
}

DriverStatus GrblLink::stream(const WireCommand* command) noexcept {
  if (stopped_) return DriverStatus::Alarm;
  // At standstill take over the position grbl reports: it adds up numbers of only seven digits.
  if (stream_.standing() && machine_ == Machine::Idle && !settled_) {
    stream_.stand_at(position_);
    settled_ = true;
  }
  if (command != nullptr) {
    stream_.push(*command);
    told_.push_back(*command);
    while (told_.front().time < command->time - kWindow) told_.pop_front();
  }
  for (std::string text; !(text = stream_.next_line(wire_time())).empty();) {
    settled_ = false;
    machine_ = Machine::Run;  // until grbl reports another state
    sent_ = wire_time();
    if (!port_.send(text)) break;
  }
  return DriverStatus::Ok;
}

void GrblLink::query(double period) noexcept {
  const double now = wire_time();
  if (now - asked_ < period) return;
  asked_ = now;
  if (waiting_ == 0) waiting_ = now;
  port_.send_byte(grbl::kStatusQuery);
}

/// s for which Rob has waited for a report, from its query on: a thread that did not run has not
/// asked.
double GrblLink::silence(double now) const noexcept { return waiting_ == 0 ? 0 : now - waiting_; }

DriverStatus GrblLink::check_answers(double now) noexcept {
  if (silence(now) > kAnswerTime)
    return fail(DriverStatus::Silent, "grbl on " + port_.path() + " does not answer",
                "check its power and its cable");
  const bool reports = now - reported_ < 2 * kQueryPeriod;  // otherwise grbl is silent
  if (reports && stream_.open_lines() > 0 && now - stream_.open_since() > kAnswerTime)
    return stop_streaming("answers of grbl were lost on the wire: it has not acknowledged " +
                              std::to_string(stream_.open_lines()) + " lines",
                          "check its cable, and where the machine stands");
  return DriverStatus::Ok;
}

DriverStatus GrblLink::stop_streaming(const std::string& what, const std::string& remedy) noexcept {
  if (!stopped_) port_.send_byte(grbl::kFeedHold);
  stopped_ = true;
  return fail(DriverStatus::Alarm, what, remedy);
}

DriverStatus GrblLink::alarm(int number) noexcept {
  stopped_ = true;
  machine_ = Machine::Alarm;
  const std::string text = with_words("grbl ALARM:", number, grbl::alarm_text(number));
  if (!grbl::loses_position(number))
    return fail(DriverStatus::Alarm, text, "unlock it with $X, or home it");
  return fail(DriverStatus::Alarm, text + "; its position is not known any more",
              "home it (--home, or :home at the prompt)");
}

DriverStatus GrblLink::take(const Line& line) noexcept {
  switch (line.kind) {
    case Line::Kind::Ok:
      if (!stream_.acknowledged() && enabled_)
        remark("grbl has acknowledged a line that Rob did not send",
               "let no other program or pendant send to it while Rob does");
      return DriverStatus::Ok;
    case Line::Kind::Error:
      stream_.acknowledged();
      return stop_streaming(with_words("grbl error:", line.number, grbl::error_text(line.number)),
                            "look up the error in grbl's manual; the run has ended there");
    case Line::Kind::Alarm:
      return alarm(line.number);
    case Line::Kind::Banner:
      stopped_ = true;
      return fail(DriverStatus::Alarm, "grbl has restarted: its position is not to be trusted",
                  "check its supply, and home it (--home, or :home at the prompt)");
    case Line::Kind::Status:
      return take_status(line.status);
    default:
      return DriverStatus::Ok;
  }
}

DriverStatus GrblLink::take_status(const grbl::Status& status) noexcept {
  machine_ = status.machine;
  phase_ = status.phase;
  bool moved = false;
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    const auto letter = static_cast<std::size_t>(axes_[i].address);
    if (status.has_offset) {
      moved = moved || std::abs(status.offset[letter] - offset_[i]) > kSameOffset;
      offset_[i] = status.offset[letter];
    }
    position_[i] = status.position[letter] - (status.of_work ? 0 : offset_[i]);
  }
  waiting_ = 0;
  reported_ = wire_time();
  if (stopped_) return DriverStatus::Alarm;
  if (machine_ == Machine::Alarm) {
    stopped_ = true;
    return fail(DriverStatus::Alarm, "grbl is locked (ALARM)",
                "home it (--home, or :home at the prompt), or unlock it with $X where its position"
                " is known");
  }
  if (moved)
    return stop_streaming(
        "the work offset of grbl was changed at the machine or by another program",
        "let nothing else use it while Rob does, then start again");
  return find_interference(status);
}

/// Whatever keeps grbl from carrying out its moves in their time.
DriverStatus GrblLink::find_interference(const grbl::Status& status) noexcept {
  for (const auto& [machine, what, remedy] : kInterferences)
    if (machine == machine_)
      return enabled_ ? stop_streaming(std::string("grbl has stopped: ") + what, remedy)
                      : fail(DriverStatus::Alarm, std::string("grbl cannot move: ") + what, remedy);
  if (!enabled_ && machine_ == Machine::Run)
    return fail(DriverStatus::Alarm, "grbl moves, though Rob has sent nothing",
                "let no other program or pendant move it, then start again");
  if (!enabled_) return DriverStatus::Ok;
  if (status.feed_override != 0 && status.feed_override != 100)
    return stop_streaming("the feed override of grbl is at " +
                              std::to_string(status.feed_override) +
                              " %: its moves no longer take their time",
                          "set it to 100 % at the machine; --override makes a run slower");
  // Idle, it has carried out whatever it has got; and what was acknowledged came before this.
  if (machine_ == Machine::Idle && stream_.open_lines() > 0 && sent_ < asked_ - kTravelTime)
    return stop_streaming(
        "answers of grbl were lost on the wire: it stands, and has not"
        " acknowledged " +
            std::to_string(stream_.open_lines()) + " lines",
        "check its cable, and where the machine stands");
  return DriverStatus::Ok;
}

std::unique_ptr<WireLink> grbl_link(const std::vector<WireAxis>& axes, int baud) {
  return std::make_unique<GrblLink>(axes, baud);
}

}  // namespace rob::drivers
