#include "drivers/link/grbl_link.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace rob::drivers {

using grbl::Line;
using grbl::Machine;
using motion::DriverStatus;

namespace {

constexpr double kQueryPeriod = 0.1;  // s: the wiki advises 5 to 10 Hz
constexpr double kAnswerTime = 0.5;   // s [choice] for "ok" and for a report; five queries
constexpr double kQueueTime = 2;      // s until what was streamed has been carried out
constexpr double kLookAgain = 0.05;   // s
// s behind the references within which it may be anywhere on its path: when exactly its moves have
// begun is not known. [choice] the look-ahead, and a computer that is late by as much again
constexpr double kWindow = 0.2;

const char* name_of(Machine machine) {
  switch (machine) {
    case Machine::Hold:
      return "it was held at the machine";
    case Machine::Door:
      return "its safety door is open";
    case Machine::Check:
      return "it is in check mode ($C)";
    case Machine::Sleep:
      return "it sleeps";
    case Machine::Home:
      return "it is homing";
    default:
      return "";
  }
}

std::string with_words(const char* what, int number, const char* words) {
  std::string text = what + std::to_string(number);
  if (*words != '\0') text += std::string(": ") + words;
  return text;
}

}  // namespace

GrblLink::GrblLink(const std::vector<WireAxis>& axes) : axes_(axes) {}

bool GrblLink::send(std::string_view text) noexcept {
  const auto* first = reinterpret_cast<const std::uint8_t*>(text.data());
  const WireIo io = port_->write({first, text.size()}, wire_time() + kAnswerTime);
  gone_ = gone_ || io.status == WireIo::Status::Gone;
  return io.status == WireIo::Status::Ok;
}

bool GrblLink::send_byte(std::uint8_t byte) noexcept {
  const char text = static_cast<char>(byte);
  return send({&text, 1});
}

bool GrblLink::next_line(Line& line, double deadline) noexcept {
  for (;;) {
    std::string_view text;
    while (reader_.next(unread_, text))
      if (grbl::parse(text, line)) return true;
    const WireIo io = port_->read(bytes_, deadline);
    gone_ = gone_ || io.status == WireIo::Status::Gone;
    if (io.status != WireIo::Status::Ok) return false;
    unread_ = {bytes_.data(), io.bytes};
  }
}

void GrblLink::query(double now) noexcept {
  if (now - asked_ < kQueryPeriod) return;
  asked_ = now;
  send_byte(grbl::kStatusQuery);
}

DriverStatus GrblLink::enable() noexcept {
  stream_.stand_at(position_);
  told_.clear();
  send_byte(grbl::kFeedAt100);
  enabled_ = true;
  return gone_ ? lost(*port_) : DriverStatus::Ok;
}

/// What is on its way is carried out; after an error it is braked and dropped.
void GrblLink::disable() noexcept {
  enabled_ = false;
  stream_.flush();
  const double end = wire_time() + kQueueTime;
  while (!stopped_ && !gone_ && stream_.open_lines() > 0 && wire_time() < end) {
    stream(nullptr);
    Line line;
    if (next_line(line, wire_time() + kLookAgain)) take(line);
  }
  if (!stopped_ && wait_for(Machine::Idle, kQueueTime)) return;
  if (gone_ || machine_ == Machine::Alarm) return;
  send_byte(grbl::kFeedHold);
  wait_for(Machine::Hold, kAnswerTime);
  send_byte(grbl::kReset);  // it stands: the position is kept, the rest of the moves is not
}

bool GrblLink::wait_for(Machine machine, double seconds) noexcept {
  const double end = wire_time() + seconds;
  machine_ = Machine::Unknown;
  while (!gone_ && machine_ != machine && machine_ != Machine::Alarm && wire_time() < end) {
    send_byte(grbl::kStatusQuery);
    Line line;
    const double look = wire_time() + kLookAgain;
    while (machine_ != machine && next_line(line, look))
      if (line.kind == Line::Kind::Status) take_status(line.status);
  }
  return machine_ == machine;
}

DriverStatus GrblLink::exchange(const WireCommand* command, double deadline,
                                WireAnswer& answer) noexcept {
  DriverStatus status = DriverStatus::Ok;
  const double reported = reported_;
  query(wire_time());
  Line line;
  const bool first = reported_ == 0;
  while (status == DriverStatus::Ok && next_line(line, first && reported_ == 0 ? deadline : 0))
    status = take(line);
  if (status == DriverStatus::Ok) status = stream(command);
  if (gone_) return lost(*port_);
  if (status == DriverStatus::Ok) status = check_answers(wire_time());
  if (status != DriverStatus::Ok || reported == reported_) return status;
  if (first) take_limits();
  const double time = std::max(instant_of_report(), answer.time);
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    const double since = std::max(time - answer.time, kPeriod);
    answer.velocity[i] =
        first || stream_.standing() ? 0 : (position_[i] - answer.position[i]) / since;
    answer.position[i] = position_[i];
  }
  answer.time = time;
  return DriverStatus::Ok;
}

/// When the references were nearest to what it reports: the path counts, and that it is not more
/// than kWindow behind.
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
  // At standstill its own account of where it is counts: grbl adds up numbers of seven digits.
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
    machine_ = Machine::Run;  // until it says something else
    if (!send(text)) break;
  }
  return DriverStatus::Ok;
}

DriverStatus GrblLink::check_answers(double now) noexcept {
  if (reported_ == 0 || now - reported_ > kAnswerTime)
    return fail(DriverStatus::Silent,
                "grbl on " + port_->path() + " does not answer; check its power and its cable");
  if (stream_.open_lines() > 0 && now - stream_.open_since() > kAnswerTime)
    return stop_streaming(
        "grbl has not acknowledged a line: what it has taken is not certain; check the cable, and"
        " look where the machine stands");
  return DriverStatus::Ok;
}

DriverStatus GrblLink::stop_streaming(std::string trouble) noexcept {
  if (!stopped_) send_byte(grbl::kFeedHold);
  stopped_ = true;
  return fail(DriverStatus::Alarm, std::move(trouble));
}

DriverStatus GrblLink::alarm(int number) noexcept {
  std::string text = with_words("grbl ALARM:", number, grbl::alarm_text(number));
  text += grbl::loses_position(number)
              ? "; its position is not known any more: home it (--home, or :home at the prompt)"
              : "; unlock it with $X, or home it";
  stopped_ = true;
  machine_ = Machine::Alarm;
  return fail(DriverStatus::Alarm, std::move(text));
}

DriverStatus GrblLink::take(const Line& line) noexcept {
  switch (line.kind) {
    case Line::Kind::Ok:
      stream_.acknowledged();
      return DriverStatus::Ok;
    case Line::Kind::Error:
      stream_.acknowledged();
      return stop_streaming(with_words("grbl error:", line.number, grbl::error_text(line.number)) +
                            "; the run has ended there");
    case Line::Kind::Alarm:
      return alarm(line.number);
    case Line::Kind::Banner:
      stopped_ = true;
      return fail(DriverStatus::Alarm,
                  "grbl has restarted: its position is not to be trusted; check its supply, and"
                  " home it (--home, or :home at the prompt)");
    case Line::Kind::Status:
      return take_status(line.status);
    default:
      return DriverStatus::Ok;
  }
}

DriverStatus GrblLink::take_status(const grbl::Status& status) noexcept {
  machine_ = status.machine;
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    const auto letter = static_cast<std::size_t>(axes_[i].address);
    if (status.has_offset) offset_[i] = status.offset[letter];
    position_[i] = status.position[letter] - (status.of_work ? 0 : offset_[i]);
  }
  if (status.axes <= 0) return DriverStatus::Ok;
  reported_ = wire_time();
  if (machine_ == Machine::Alarm && !stopped_) {
    stopped_ = true;
    return fail(DriverStatus::Alarm,
                "grbl is locked (ALARM); home it (--home, or :home at the prompt), or unlock it"
                " with $X where its position is known");
  }
  const std::string why = name_of(machine_);
  if (enabled_ && !stopped_ && !why.empty()) return stop_streaming("grbl has stopped: " + why);
  return DriverStatus::Ok;
}

std::unique_ptr<WireLink> grbl_link(const std::vector<WireAxis>& axes) {
  return std::make_unique<GrblLink>(axes);
}

}  // namespace rob::drivers
