#include "drivers/link/wire_backend.h"

#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "drivers/serial/open_port.h"
#include "motion/servo/following_supervisor.h"

namespace rob::drivers {

using motion::DriverStatus;

namespace {

constexpr double kOpening = 0.5;  // s [choice] for the first exchange
constexpr double kShare = 0.8;    // of the period, for one exchange
constexpr double kCounting = 1;   // s over which errors are counted
constexpr double kCredible = 2;   // times the axis' speed, as FollowingSupervisor's

/// As asked for, if the wire can do that; otherwise the next multiple of 5 ms that it can do.
double period_for(double asked, double least) {
  constexpr double kStep = 5e-3;  // s [choice] a figure that people remember
  return least <= asked ? asked : kStep * std::ceil(least / kStep);
}

}  // namespace

WireBackend::WireBackend(WireSettings settings, std::unique_ptr<WireLink> link)
    : settings_(std::move(settings)), link_(std::move(link)), period_(settings_.period) {}

WireBackend::~WireBackend() { close(); }

void WireBackend::open() {
  port_ = open_port(settings_.port, settings_.baud);
  link_->connect(*port_);
  if (settings_.home) link_->home(settings_.given_up);
  period_ = period_for(settings_.period, link_->least_period());
  link_->use_period(period_);
  first_exchange();
  start();
}

void WireBackend::first_exchange() {
  const DriverStatus status = link_->exchange(nullptr, wire_time() + kOpening, report_.answer);
  if (status != DriverStatus::Ok) throw motion::DriverError(link_->trouble());
  publish(status);
  position_.resize(axes());
  for (int i = 0; i < axes(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    position_[i] = report_.answer.position[k] / settings_.axes[k].scale + settings_.axes[k].offset;
  }
}

void WireBackend::start() {
  stopping_ = false;
  event_ = ::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC);
  if (event_ < 0) throw motion::DriverError("cannot create an eventfd; too many files are open");
  thread_ = std::thread([this] { run(); });
}

void WireBackend::close() noexcept {
  stopping_ = true;
  wake();
  if (thread_.joinable()) thread_.join();
  if (event_ >= 0) ::close(std::exchange(event_, -1));
  port_.reset();
}

// ---- the tick's side

DriverStatus WireBackend::enable(double) noexcept {
  wanted_.store(true, std::memory_order_release);
  wake();
  return DriverStatus::Ok;
}

void WireBackend::disable(double) noexcept {
  wanted_.store(false, std::memory_order_release);
  wake();
}

/// The wire_time() of the servo's 0. Looking at its clock and then here takes some time, so the
/// least difference is the nearest to the true one. A clock that has not begun says nothing; until
/// then the tick counts as alive.
double WireBackend::zero_seen(double now) noexcept {
  const double here = wire_time();
  const bool begun = now >= 0;
  looked_.store(begun ? here : std::numeric_limits<double>::infinity(), std::memory_order_relaxed);
  if (!begun) return here - now;
  return zero_ = std::min(zero_, here - now);
}

DriverStatus WireBackend::status_of(const Report& report) noexcept {
  const bool old = std::exchange(taken_, report.number) == report.number;
  const DriverStatus status = report.status;
  if (status == DriverStatus::Alarm || status == DriverStatus::Lost) return status;
  if (wire_time() - report.tried > std::max(kLate, 3 * period_)) return DriverStatus::Late;
  return old && status == DriverStatus::Silent ? DriverStatus::Pending : status;
}

/// Reports the last known positions with every status, an alarm included.
DriverStatus WireBackend::read(double now, motion::ServoState& state) noexcept {
  const double zero = zero_seen(now);
  const Report& report = reports_.load();
  const WireAnswer& answer = report.answer;
  state.wire_errors = report.errors;
  state.late = wire_time() - report.tried;
  state.measured.time = answer.time - zero;
  state.seen = answer.seen - zero;
  state.spread = answer.spread;
  state.inputs = answer.inputs;
  state.analog_inputs = answer.analog_inputs;
  state.measured.q.resize(axes());
  state.measured.qd.resize(axes());
  for (int i = 0; i < axes(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const WireAxis& axis = settings_.axes[k];
    state.measured.q[i] = answer.position[k] / axis.scale + axis.offset;
    state.measured.qd[i] = answer.velocity[k] / axis.scale;
  }
  return status_of(report);
}

DriverStatus WireBackend::write(double now, const motion::ServoCommand& command) noexcept {
  WireCommand sent;
  sent.time = command.reference.time + zero_seen(now);
  for (std::size_t k = 0; k < settings_.axes.size(); ++k) {
    const WireAxis& axis = settings_.axes[k];
    const auto i = static_cast<Eigen::Index>(k);
    sent.position[k] = (command.reference.q[i] - axis.offset) * axis.scale;
    sent.velocity[k] = command.reference.qd[i] * axis.scale;
  }
  sent.outputs = command.outputs;
  sent.analog_outputs = command.analog_outputs;
  commands_.store(sent);
  wake();
  return DriverStatus::Ok;
}

void WireBackend::wake() noexcept {
  const std::uint64_t one = 1;
  if (event_ >= 0 && ::write(event_, &one, sizeof one) < 0) return;  // full: it will wake anyway
}

std::string WireBackend::trouble() const {
  const std::lock_guard lock(mutex_);
  return trouble_;
}

std::string WireBackend::remark() const {
  const std::lock_guard lock(mutex_);
  return remark_;
}

// ---- the thread's side

void WireBackend::run() noexcept {
  if (settings_.begin_thread) settings_.begin_thread();
  window_ = wire_time();
  while (!stopping_.load(std::memory_order_relaxed)) {
    const bool told = wait();
    follow_wish(told);
    const bool ended =
        report_.status == DriverStatus::Lost || stopping_.load(std::memory_order_relaxed);
    // The tick has fallen silent: so does this side, for the machine's watchdog.
    const double heard = std::max(newest_, looked_.load(std::memory_order_relaxed));
    const bool deserted = enabled_ && !told && wire_time() - heard > kTickLost;
    if (!ended && !deserted) exchange();
  }
  if (enabled_ && report_.status != DriverStatus::Lost) link_->disable();
  enabled_ = false;
}

/// For the next command, a period and a half at most; whether there is one.
bool WireBackend::wait() noexcept {
  pollfd waits{event_, POLLIN, 0};
  ::poll(&waits, 1, static_cast<int>(std::ceil(1.5e3 * period_)));
  std::uint64_t count = 0;
  if (::read(event_, &count, sizeof count) < 0) count = 0;
  return commands_.load().time > newest_;
}

/// Under force with the first command: until the tick has begun, nobody would look after the
/// machine.
void WireBackend::follow_wish(bool told) noexcept {
  const bool wanted = wanted_.load(std::memory_order_acquire);
  if (wanted == enabled_ || (wanted && !told)) return;
  if (report_.status == DriverStatus::Lost || report_.status == DriverStatus::Alarm) {
    enabled_ = wanted;
    return;
  }
  enabled_ = wanted;
  if (!wanted) return link_->disable();
  if (const DriverStatus status = link_->enable(); status != DriverStatus::Ok) publish(status);
}

void WireBackend::exchange() noexcept {
  const WireCommand& command = commands_.load();
  bool fresh = enabled_ && command.time > newest_;
  if (fresh) newest_ = command.time;
  // One that this process was stopped over is too old to be carried out.
  fresh = fresh && wire_time() - command.time < kLate;
  const bool stopped = report_.status == DriverStatus::Alarm;
  const WireAnswer before = report_.answer;
  ++exchanges_;
  const DriverStatus status = link_->exchange(fresh && !stopped ? &command : nullptr,
                                              wire_time() + kShare * period_, report_.answer);
  publish(stopped && status != DriverStatus::Lost ? DriverStatus::Alarm
                                                  : believed(status, before, command));
}

/// A position that the axis cannot have reached is a bad frame, if the next one does not say the
/// same. A drive makes up its lag as fast as it can.
DriverStatus WireBackend::believed(DriverStatus status, const WireAnswer& before,
                                   const WireCommand& newest) noexcept {
  if (status != DriverStatus::Ok || std::exchange(first_, false)) return status;
  const double elapsed =
      std::max(report_.answer.time - before.time, period_) + before.spread + report_.answer.spread;
  bool credible = true;
  for (std::size_t k = 0; k < settings_.axes.size(); ++k) {
    const double from = before.position[k];
    const double goal = enabled_ && newest_ > 0 ? newest.position[k] : from;
    const double step = motion::off_way(from, goal, report_.answer.position[k]);
    const double most = settings_.axes[k].most_step;
    credible = credible && (most == 0 || step <= kCredible * most * elapsed + 1);
  }
  if (credible || doubted_) {
    doubted_ = false;
    return status;
  }
  doubted_ = true;
  report_.answer = before;
  return DriverStatus::Silent;
}

void WireBackend::publish(DriverStatus status) noexcept {
  report_.status = status;
  report_.tried = wire_time();
  ++report_.number;
  if (wire_time() - window_ > kCounting) {
    const auto errors = static_cast<double>(link_->errors() - errors_before_);
    report_.errors = exchanges_ > 0 ? errors / exchanges_ : 0;
    errors_before_ = link_->errors();
    exchanges_ = 0;
    window_ = wire_time();
  }
  if (status != DriverStatus::Ok || link_->remark() != remark_) {
    const std::lock_guard lock(mutex_);
    if (status != DriverStatus::Ok) trouble_ = link_->trouble();
    remark_ = link_->remark();
  }
  reports_.store(report_);
}

// ---- what it is, for those who make the robot's model

double WireBackend::limit_in_si(int axis, const WireVector& at_plus,
                                const WireVector& at_minus) const {
  const auto k = static_cast<std::size_t>(axis);
  const WireAxis& wire = settings_.axes[k];
  return (wire.scale > 0 ? at_plus[k] : at_minus[k]) / wire.scale + wire.offset;
}

double WireBackend::most(int axis) const {
  return limit_in_si(axis, link_->limits().max, link_->limits().min);
}

double WireBackend::least(int axis) const {
  return limit_in_si(axis, link_->limits().min, link_->limits().max);
}

double WireBackend::most_speed(int axis) const {
  const auto k = static_cast<std::size_t>(axis);
  return link_->limits().speed[k] / std::abs(settings_.axes[k].scale);
}

double WireBackend::most_acceleration(int axis) const {
  const auto k = static_cast<std::size_t>(axis);
  return link_->limits().acceleration[k] / std::abs(settings_.axes[k].scale);
}

}  // namespace rob::drivers
