#include "drivers/link/servo_link.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "drivers/link/dynamixel_dialect.h"
#include "drivers/link/feetech_dialect.h"

namespace rob::drivers {

using motion::DriverError;
using motion::DriverStatus;

namespace {

constexpr double kServoAnswerTime = 0.05;   // s [choice] when nothing moves yet; a servo takes 1 ms
constexpr int kTries = 3;                   // likewise
constexpr double kEchoTime = 0.02;          // s [choice] an adapter echoes while it sends
constexpr std::uint8_t kNobody = 253;       // no servo of a robot file can have this ID
constexpr std::uint32_t kHealthEvery = 10;  // cycles
constexpr double kChainShare = 0.5;         // of a cycle, at least, for the sync read
constexpr double kShare = 0.8;              // of a cycle, for all that is said in it (WireBackend)
constexpr double kBitsPerByte = 10;         // start, 8 data bits, stop
constexpr double kTurnaround = 1e-3;  // s, of USB adapter and computer, for a turn of the line
// A goal's own speed limit: the axis' speed and a half, so that it never shapes the references.
constexpr double kSpeedMargin = 1.5;
// A servo stands if it moves by less, ticks, while its goal is farther away. [choice] More than the
// noise of an encoder; much less than what E503 is raised for.
constexpr double kStands = 1;
constexpr double kAway = 10;

}  // namespace

template <typename Dialect>
ServoLink<Dialect>::ServoLink(const std::vector<WireAxis>& axes, int baud)
    : axes_(axes), baud_(baud), answered_(axes.size(), true) {
  for (const WireAxis& axis : axes) ids_.push_back(static_cast<std::uint8_t>(axis.address));
}

template <typename Dialect>
std::string ServoLink<Dialect>::servo(std::size_t i) const {
  return "servo " + std::to_string(ids_[i]) + " (axis " + axes_[i].name + ")";
}

template <typename Dialect>
double ServoLink<Dialect>::time_of(double bytes) const noexcept {
  return bytes * kBitsPerByte / baud_;
}

/// s from the goals to the last answer of the sync read; where there is none, all the single ones.
template <typename Dialect>
double ServoLink<Dialect>::chain_time() const noexcept {
  const auto count = static_cast<double>(axes_.size());
  const double goals = Dialect::kFrameBytes + count * Dialect::kGoalBytes;
  if (!Dialect::kHasSyncRead) return time_of(goals) + count * question_time(reading_bytes());
  const double question = Dialect::kFrameBytes + count;
  return time_of(goals + question + count * reading_bytes()) + kTurnaround;
}

/// The size of a status with a reading of this turn.
template <typename Dialect>
int ServoLink<Dialect>::reading_bytes() const noexcept {
  return Dialect::kReadingBytes + Dialect::reading_size(turns_.turn()) - Dialect::reading_size(0);
}

/// s from a question to one servo to its answer of so many bytes.
template <typename Dialect>
double ServoLink<Dialect>::question_time(int answer) const noexcept {
  return time_of(Dialect::kQuestionBytes + answer) + kTurnaround;
}

template <typename Dialect>
double ServoLink<Dialect>::least_period() const {
  return (chain_time() + time_of(Dialect::kQuestionBytes + Dialect::kHealthBytes)) / kShare;
}

/// Waits for the answer of this servo that is `wanted`, and ignores late answers to other
/// questions. The time limit counts from the question: a thread that did not run has not asked.
template <typename Dialect>
template <typename Wanted>
auto ServoLink<Dialect>::ask(std::size_t i, const typename Dialect::Wire& question, Frame& answer,
                             double deadline, const Wanted& wanted) noexcept -> Result {
  Result result = packets_.ask(question.view(), deadline);
  deadline = std::max(deadline, wire_time() + question_time(reading_bytes()));
  while (result == Result::Ok) {
    result = packets_.receive(answer, deadline);
    if (result != Result::Ok) return result;
    if (sender_of(answer) == i && wanted(answer)) return result;
    note_late(answer);
  }
  return result;
}

/// kNone if it is no answer, or of no servo of this robot.
template <typename Dialect>
std::size_t ServoLink<Dialect>::sender_of(const Frame& frame) const noexcept {
  if (!Dialect::is_status(frame)) return kNone;
  const auto found = std::ranges::find(ids_, Dialect::id_of(frame));
  return found == ids_.end() ? kNone : static_cast<std::size_t>(found - ids_.begin());
}

/// A reading of another turn is the answer to a question of an earlier cycle.
template <typename Dialect>
void ServoLink<Dialect>::note_late(const Frame& frame) noexcept {
  const std::size_t i = sender_of(frame);
  ServoReading reading;
  for (int turn = 0; i != kNone && turn < kTurns; ++turn)
    if (turn != turns_.turn() && Dialect::parse_reading(frame, turn, reading)) turns_.hear_late(i);
}

/// Receives the answers to earlier questions, until nothing has come by `deadline`.
template <typename Dialect>
void ServoLink<Dialect>::hear_out(double deadline) noexcept {
  Frame frame;
  while (packets_.receive(frame, deadline) == Result::Ok)
    if (const std::size_t i = sender_of(frame); i != kNone) turns_.hear_late(i);
}

template <typename Dialect>
auto ServoLink<Dialect>::must_ask(std::size_t i, const typename Dialect::Wire& question) -> Frame {
  Frame answer;
  for (int tries = 0; tries < kTries; ++tries) {
    const Result result =
        ask(i, question, answer, wire_time() + kServoAnswerTime + question_time(reading_bytes()),
            [](const Frame&) { return true; });
    // This may answer the first try. An answer to another try must not answer the next question.
    if (result == Result::Ok && tries > 0) hear_out(wire_time() + tries * 2 * kServoAnswerTime);
    if (result == Result::Ok) return answer;
    if (result == Result::Gone) {
      lost(packets_.port());
      throw DriverError(trouble());
    }
  }
  throw DriverError(servo(i) + " on " + packets_.port().path() + " does not answer at " +
                    std::to_string(baud_) +
                    " baud; check its power, its cable, its ID and its baud rate ([wire] baud and"
                    " [axis.wire] id in the robot file)");
}

template <typename Dialect>
void ServoLink<Dialect>::connect(WirePort& port) {
  packets_.attach(port);
  enabled_ = false;
  turns_ = {};
  stalled_ = kNone;
  const typename Dialect::Wire question = Dialect::ping(kNobody);
  packets_.find_echo(question.view(), wire_time() + kEchoTime + time_of(Dialect::kQuestionBytes));
  for (std::size_t i = 0; i < ids_.size(); ++i) {
    must_ask(i, Dialect::ping(ids_[i]));
    configure(i);
  }
}

template <typename Dialect>
void ServoLink<Dialect>::check_mode(std::size_t i) {
  const std::uint32_t mode =
      Dialect::value_of(must_ask(i, Dialect::read(ids_[i], Dialect::kModeAddress, 1)));
  if (mode != Dialect::kMode)
    throw DriverError(servo(i) + " is in mode " + std::to_string(mode) + "; it needs " +
                      Dialect::kModeHelp + ", written with the maker's tool");
}

template <typename Dialect>
void ServoLink<Dialect>::configure(std::size_t i) {
  if constexpr (Dialect::kModeAddress != 0) check_mode(i);
  for (const ServoSetting& setting : Dialect::settings()) write_setting(i, setting);
  const auto limit = [&](int address) {
    return static_cast<double>(static_cast<std::int32_t>(
        Dialect::value_of(must_ask(i, Dialect::read(ids_[i], address, Dialect::kLimitSize)))));
  };
  const double least = limit(Dialect::kLeastAddress);
  const double most = limit(Dialect::kMostAddress);
  if (least >= most && Dialect::kModeAddress == 0)
    throw DriverError(servo(i) + " turns as a wheel; it needs " + Dialect::kModeHelp +
                      ", written with the maker's tool");
  if (least >= most) return;  // 0 and 0: no limits
  limits_.min[i] = least;
  limits_.max[i] = most;
}

/// Another program may have left the torque on, which locks some registers.
template <typename Dialect>
void ServoLink<Dialect>::release_torque(std::size_t i) {
  must_ask(i, Dialect::write(ids_[i], Dialect::torque_setting(false)));
}

/// Writes the register only if its value differs: some registers wear out.
template <typename Dialect>
void ServoLink<Dialect>::write_setting(std::size_t i, const ServoSetting& setting) {
  const Frame now = must_ask(i, Dialect::read(ids_[i], setting.address, setting.size));
  if (Dialect::value_of(now) == setting.value) return;
  release_torque(i);
  const Frame done = must_ask(i, Dialect::write(ids_[i], setting));
  if (const std::string complaint = Dialect::complaint(done); !complaint.empty())
    throw DriverError(servo(i) + " does not take register " + std::to_string(setting.address) +
                      ": " + complaint + "; look up the register in the servo's manual");
}

template <typename Dialect>
DriverStatus ServoLink<Dialect>::enable() noexcept {
  const double deadline = wire_time() + kServoAnswerTime;
  // The first goal is the current position, sent before the drives get force: so nothing jumps.
  Result result = send_goals(last_, deadline);
  for (const ServoSetting& setting : Dialect::watchdog(true))
    if (result == Result::Ok)
      result = packets_.send(Dialect::write_all(ids_, setting).view(), deadline);
  if (result == Result::Ok) result = packets_.send(Dialect::torque(ids_, true).view(), deadline);
  enabled_ = result == Result::Ok;
  if (result == Result::Gone) return lost(packets_.port());
  if (enabled_) return DriverStatus::Ok;
  return fail(DriverStatus::Silent, packets_.port().path() + " takes no more bytes",
              "check the adapter and its driver");
}

template <typename Dialect>
void ServoLink<Dialect>::disable() noexcept {
  const double deadline = wire_time() + kServoAnswerTime;
  // Twice: a broadcast is not answered, so a bad frame would not be noticed.
  for (int turn = 0; turn < 2; ++turn) packets_.send(Dialect::torque(ids_, false).view(), deadline);
  for (const ServoSetting& setting : Dialect::watchdog(false))
    packets_.send(Dialect::write_all(ids_, setting).view(), deadline);
  enabled_ = false;
}

template <typename Dialect>
auto ServoLink<Dialect>::send_goals(const WireVector& position, double deadline) noexcept
    -> Result {
  std::array<ServoGoal, motion::kMaxJoints> goals;
  for (std::size_t i = 0; i < ids_.size(); ++i)
    goals[i] = {ids_[i], static_cast<int>(std::lround(position[i])),
                static_cast<int>(std::lround(kSpeedMargin * axes_[i].most_step))};
  return packets_.ask(Dialect::goals({goals.data(), ids_.size()}).view(), deadline);
}

template <typename Dialect>
bool ServoLink<Dialect>::take(std::size_t i, const Frame& frame, WireAnswer& answer) noexcept {
  ServoReading reading;
  if (!Dialect::parse_reading(frame, turns_.turn(), reading)) return false;
  answer.position[i] = last_[i] = reading.position;
  answer.velocity[i] = reading.velocity;
  answered_[i] = true;
  if (const std::string complaint = Dialect::complaint(frame); !complaint.empty())
    complaint_ = servo(i) + ": " + complaint;
  return true;
}

template <typename Dialect>
auto ServoLink<Dialect>::read_all(double deadline, WireAnswer& answer) noexcept -> Result {
  if (!Dialect::kHasSyncRead) return read_each(deadline, answer);
  Result result = packets_.send(Dialect::ask_readings(ids_, turns_.turn()).view(), deadline);
  Frame frame;
  std::size_t left = ids_.size();
  while (result == Result::Ok && left > 0) {
    result = packets_.receive(frame, deadline);
    if (result != Result::Ok) continue;
    const std::size_t i = sender_of(frame);
    if (i == kNone || answered_[i]) continue;
    if (take(i, frame, answer)) {
      --left;
    } else {
      note_late(frame);
    }
  }
  return result;
}

/// Asks each servo that has not answered yet.
template <typename Dialect>
auto ServoLink<Dialect>::read_each(double deadline, WireAnswer& answer) noexcept -> Result {
  auto missing = std::ranges::count(answered_, false);
  for (std::size_t i = 0; i < ids_.size(); ++i) {
    if (answered_[i]) continue;
    const double share = (deadline - wire_time()) / static_cast<double>(missing--);
    Frame frame;
    const Result result = ask(i, Dialect::ask_reading(ids_[i], turns_.turn()), frame,
                              wire_time() + std::max(share, 0.0),
                              [&](const Frame& got) { return take(i, got, answer); });
    if (result == Result::Gone) return result;
  }
  return Result::Ok;
}

template <typename Dialect>
DriverStatus ServoLink<Dialect>::exchange(const WireCommand* command, double deadline,
                                          WireAnswer& answer) noexcept {
  const double begun = wire_time();
  const WireAnswer before = answer;
  hear_out(begun);
  turns_.begin();
  answered_.assign(ids_.size(), false);
  complaint_.clear();
  Result result =
      command != nullptr ? send_goals(command->position, deadline) : packets_.ask({}, deadline);
  // If the cycle is too short to ask again, the chain may take all of it.
  const double half = begun + kChainShare * (deadline - begun);
  const double needed = wire_time() + chain_time();
  const double chain = needed <= half ? half : std::max(needed, deadline);
  if (result == Result::Ok) result = read_all(chain, answer);
  const bool whole = std::ranges::find(answered_, false) == answered_.end();
  turns_.end(whole);
  errors_ += whole ? 0 : 1;
  // After the time of the cycle, questions would only keep the bus busy in the next one.
  if (result != Result::Gone && wire_time() < deadline) result = read_each(deadline, answer);
  if (result == Result::Ok && std::ranges::find(answered_, false) == answered_.end()) {
    answer.seen = wire_time();
    answer.spread = (answer.seen - begun) / 2;
    answer.time = begun + answer.spread;
    watch_stalls(command, before, answer);
  }
  return judge(result, deadline);
}

/// Finds a servo that stands while its goal moves away, because it restarted or is blocked, and
/// asks for its health at once.
template <typename Dialect>
void ServoLink<Dialect>::watch_stalls(const WireCommand* command, const WireAnswer& before,
                                      const WireAnswer& answer) noexcept {
  stalled_ = kNone;
  double farthest = kAway;
  for (std::size_t i = 0; command != nullptr && i < ids_.size(); ++i) {
    const double away = std::abs(command->position[i] - answer.position[i]);
    const bool stands = std::abs(answer.position[i] - before.position[i]) < kStands;
    if (!stands || away <= farthest) continue;
    farthest = away;
    stalled_ = i;
  }
}

template <typename Dialect>
DriverStatus ServoLink<Dialect>::judge(Result result, double deadline) noexcept {
  if (result == Result::Gone) return lost(packets_.port());
  if (!complaint_.empty())
    return fail(DriverStatus::Alarm, complaint_,
                "check what is loading it, then switch its power off and on");
  if (std::ranges::find(answered_, false) != answered_.end()) return no_answer();
  if (!enabled_) return DriverStatus::Ok;
  ++cycle_;
  if (stalled_ != kNone) return check_health(stalled_, deadline);
  if (cycle_ % kHealthEvery != 0) return DriverStatus::Ok;
  return check_health(cycle_ / kHealthEvery % ids_.size(), deadline);
}

template <typename Dialect>
DriverStatus ServoLink<Dialect>::no_answer() noexcept {
  const auto mute = std::ranges::find(answered_, false);
  const auto i = static_cast<std::size_t>(mute - answered_.begin());
  const auto count = std::ranges::count(answered_, false);
  const bool all = count > 1 && count == static_cast<std::ptrdiff_t>(ids_.size());
  if (all ? turns_.any_late() : turns_.late(i))
    return fail(
        DriverStatus::Silent,
        (all ? "the servos on " + packets_.port().path() + " answer" : servo(i) + " answers") +
            ", but later than the cycle permits",
        "raise period in [wire] of the robot file, or the baud rate, or lower the latency"
        " timer of the adapter (docs/drivers.md)");
  return fail(
      DriverStatus::Silent,
      all ? "no servo on " + packets_.port().path() + " answers" : servo(i) + " does not answer",
      "check its power and its cable");
}

template <typename Dialect>
DriverStatus ServoLink<Dialect>::check_health(std::size_t i, double deadline) noexcept {
  Frame frame;
  ServoHealth health;
  const Result result = ask(i, Dialect::ask_health(ids_[i]), frame, deadline,
                            [&](const Frame& got) { return Dialect::parse_health(got, health); });
  if (result == Result::Gone) return lost(packets_.port());
  // Its position is known; its health is asked for again in its turn.
  if (result != Result::Ok) return DriverStatus::Ok;
  if (!health.trouble.empty())
    return fail(DriverStatus::Alarm, servo(i) + ": " + health.trouble,
                "check what is loading it, then switch its power off and on");
  if (!health.torque)
    return fail(DriverStatus::Alarm, servo(i) + " has restarted, or its torque was switched off",
                "check its supply, and where the arm stands");
  return i == stalled_ ? check_watchdog(i, deadline) : DriverStatus::Ok;
}

/// A servo that its bus watchdog has stopped no longer accepts goals.
template <typename Dialect>
DriverStatus ServoLink<Dialect>::check_watchdog(std::size_t i, double deadline) noexcept {
  if (Dialect::kWatchdogAddress == 0) return DriverStatus::Ok;
  Frame frame;
  const Result result = ask(i, Dialect::read(ids_[i], Dialect::kWatchdogAddress, 1), frame,
                            deadline, [](const Frame& got) { return got.parameters.size() == 1; });
  if (result == Result::Gone) return lost(packets_.port());
  if (result != Result::Ok || Dialect::value_of(frame) != Dialect::kTripped)
    return DriverStatus::Ok;
  return fail(DriverStatus::Alarm,
              "the bus watchdog of " + servo(i) + " has stopped it: this computer was late",
              "close what loads the computer, and see docs/realtime.md if it happens often");
}

template class ServoLink<DynamixelDialect>;
template class ServoLink<FeetechDialect>;
template class ServoLink<FeetechScsDialect>;

}  // namespace rob::drivers
