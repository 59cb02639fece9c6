#include "drivers/link/servo_link.h"

#include <algorithm>
#include <cmath>

namespace rob::drivers {

using motion::DriverError;
using motion::DriverStatus;

namespace {

constexpr double kServoAnswerTime = 0.05;   // s [choice] when nothing moves yet; a servo takes 1 ms
constexpr int kTries = 3;                   // likewise
constexpr std::uint32_t kHealthEvery = 10;  // cycles
constexpr double kChainShare = 0.5;         // of a cycle, for the sync read
// The least period: bytes of 10 bits, and room for what a USB adapter and this computer take.
constexpr double kBits = 10;
constexpr double kRoom = 1.3;
constexpr double kTurnaround = 1e-3;  // s
constexpr double kQuestionBytes = 8;
// A goal's own speed limit: the axis' speed and a half, so that it never shapes the references.
constexpr double kSpeedMargin = 1.5;

}  // namespace

template <typename Dialect>
ServoLink<Dialect>::ServoLink(const std::vector<WireAxis>& axes, int baud)
    : axes_(axes), baud_(baud), answered_(axes.size()) {
  for (const WireAxis& axis : axes) ids_.push_back(static_cast<std::uint8_t>(axis.address));
}

template <typename Dialect>
std::string ServoLink<Dialect>::servo(std::size_t i) const {
  return "servo " + std::to_string(ids_[i]) + " (axis " + axes_[i].name + ")";
}

template <typename Dialect>
double ServoLink<Dialect>::least_period() const {
  const auto count = static_cast<double>(axes_.size());
  // Where there is no sync read each servo is asked by itself.
  const double question = Dialect::kHasSyncRead ? 1 : kQuestionBytes;
  const double bytes = 28 + count * (Dialect::kGoalBytes + question + Dialect::kReadingBytes) + 32;
  return kRoom * bytes * kBits / baud_ + kTurnaround * (Dialect::kHasSyncRead ? 1 : count);
}

/// Until the servo has answered; what others say late is passed over.
template <typename Dialect>
auto ServoLink<Dialect>::ask(std::uint8_t id, const typename Dialect::Wire& question, Frame& answer,
                             double deadline) noexcept -> Result {
  Result result = packets_.ask(question.view(), deadline);
  while (result == Result::Ok) {
    result = packets_.receive(answer, deadline);
    if (result == Result::Ok && Dialect::is_status(answer) && Dialect::id_of(answer) == id)
      return result;
  }
  return result;
}

template <typename Dialect>
auto ServoLink<Dialect>::must_ask(std::size_t i, const typename Dialect::Wire& question) -> Frame {
  Frame answer;
  for (int tries = 0; tries < kTries; ++tries) {
    const Result result = ask(ids_[i], question, answer, wire_time() + kServoAnswerTime);
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
void ServoLink<Dialect>::connect(SerialPort& port) {
  packets_.attach(port);
  enabled_ = false;
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

/// Only where it is different: some registers wear out.
template <typename Dialect>
void ServoLink<Dialect>::write_setting(std::size_t i, const ServoSetting& setting) {
  const Frame now = must_ask(i, Dialect::read(ids_[i], setting.address, setting.size));
  if (Dialect::value_of(now) == setting.value) return;
  const Frame done = must_ask(i, Dialect::write(ids_[i], setting));
  if (const std::string complaint = Dialect::complaint(done); !complaint.empty())
    throw DriverError(servo(i) + " does not take register " + std::to_string(setting.address) +
                      ": " + complaint + "; switch its power off and on");
}

template <typename Dialect>
DriverStatus ServoLink<Dialect>::enable() noexcept {
  const double deadline = wire_time() + kServoAnswerTime;
  // Where they stand is the goal before there is force: nothing jumps.
  Result result = send_goals(last_, deadline);
  for (const ServoSetting& setting : Dialect::watchdog(true))
    if (result == Result::Ok)
      result = packets_.send(Dialect::write_all(ids_, setting).view(), deadline);
  if (result == Result::Ok) result = packets_.send(Dialect::torque(ids_, true).view(), deadline);
  enabled_ = result == Result::Ok;
  if (result == Result::Gone) return lost(packets_.port());
  return enabled_ ? DriverStatus::Ok
                  : fail(DriverStatus::Silent, "the bus takes no more: " + packets_.port().path());
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
  if (!Dialect::parse_reading(frame, reading)) return false;
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
  Result result = packets_.send(Dialect::ask_readings(ids_).view(), deadline);
  Frame frame;
  std::size_t left = ids_.size();
  while (result == Result::Ok && left > 0) {
    result = packets_.receive(frame, deadline);
    if (result != Result::Ok || !Dialect::is_status(frame)) continue;
    const auto found = std::ranges::find(ids_, Dialect::id_of(frame));
    if (found == ids_.end()) continue;
    const auto i = static_cast<std::size_t>(found - ids_.begin());
    if (!answered_[i] && take(i, frame, answer)) --left;
  }
  return result;
}

/// Those that have not answered yet, one by one.
template <typename Dialect>
auto ServoLink<Dialect>::read_each(double deadline, WireAnswer& answer) noexcept -> Result {
  auto missing = std::ranges::count(answered_, false);
  for (std::size_t i = 0; i < ids_.size(); ++i) {
    if (answered_[i]) continue;
    const double share = (deadline - wire_time()) / static_cast<double>(missing--);
    Frame frame;
    const Result result =
        ask(ids_[i], Dialect::ask_reading(ids_[i]), frame, wire_time() + std::max(share, 0.0));
    if (result == Result::Gone) return result;
    if (result == Result::Ok) take(i, frame, answer);
  }
  return Result::Ok;
}

template <typename Dialect>
DriverStatus ServoLink<Dialect>::exchange(const WireCommand* command, double deadline,
                                          WireAnswer& answer) noexcept {
  const double begun = wire_time();
  answered_.assign(ids_.size(), false);
  complaint_.clear();
  Result result =
      command != nullptr ? send_goals(command->position, deadline) : packets_.ask({}, deadline);
  if (result == Result::Ok) result = read_all(begun + kChainShare * (deadline - begun), answer);
  errors_ += std::ranges::find(answered_, false) != answered_.end() ? 1 : 0;
  if (result != Result::Gone) result = read_each(deadline, answer);
  if (result == Result::Ok && std::ranges::find(answered_, false) == answered_.end()) {
    answer.spread = (wire_time() - begun) / 2;
    answer.time = begun + answer.spread;
  }
  return judge(result, deadline);
}

template <typename Dialect>
DriverStatus ServoLink<Dialect>::judge(Result result, double deadline) noexcept {
  if (result == Result::Gone) return lost(packets_.port());
  if (!complaint_.empty())
    return fail(DriverStatus::Alarm,
                complaint_ + "; look what loads it, then switch it off and on");
  const auto mute = std::ranges::find(answered_, false);
  if (mute != answered_.end()) {
    const auto i = static_cast<std::size_t>(mute - answered_.begin());
    const auto count = std::ranges::count(answered_, false);
    return fail(DriverStatus::Silent,
                (count > 1 && count == static_cast<std::ptrdiff_t>(ids_.size())
                     ? "no servo on " + packets_.port().path() + " answers"
                     : servo(i) + " does not answer") +
                    "; check its power and its cable");
  }
  return enabled_ && ++cycle_ % kHealthEvery == 0 ? check_health(deadline) : DriverStatus::Ok;
}

template <typename Dialect>
DriverStatus ServoLink<Dialect>::check_health(double deadline) noexcept {
  const std::size_t i = cycle_ / kHealthEvery % ids_.size();
  Frame frame;
  ServoHealth health;
  const Result result = ask(ids_[i], Dialect::ask_health(ids_[i]), frame, deadline);
  if (result == Result::Gone) return lost(packets_.port());
  // Its place is known; its health is asked again in its turn.
  if (result != Result::Ok || !Dialect::parse_health(frame, health)) return DriverStatus::Ok;
  if (!health.trouble.empty())
    return fail(DriverStatus::Alarm, servo(i) + ": " + health.trouble +
                                         "; look what loads it, then switch it off and on");
  if (health.torque) return DriverStatus::Ok;
  return fail(DriverStatus::Alarm, servo(i) +
                                       " has switched its torque off or has restarted;"
                                       " check its supply, and look where the arm stands");
}

template class ServoLink<DynamixelDialect>;
template class ServoLink<FeetechDialect>;
template class ServoLink<FeetechScsDialect>;

std::unique_ptr<WireLink> dynamixel_link(const std::vector<WireAxis>& axes, int baud) {
  return std::make_unique<ServoLink<DynamixelDialect>>(axes, baud);
}

std::unique_ptr<WireLink> feetech_link(const std::vector<WireAxis>& axes, int baud) {
  return std::make_unique<ServoLink<FeetechDialect>>(axes, baud);
}

std::unique_ptr<WireLink> feetech_scs_link(const std::vector<WireAxis>& axes, int baud) {
  return std::make_unique<ServoLink<FeetechScsDialect>>(axes, baud);
}

}  // namespace rob::drivers
