#pragma once

#include <atomic>
#include <functional>
#include <limits>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "drivers/link/latest.h"
#include "drivers/link/wire_link.h"
#include "drivers/serial/wire_port.h"
#include "motion/servo/servo_backend.h"

namespace rob::drivers {

struct WireSettings {
  std::string port;
  int baud = 115200;
  double period = 0.01;  ///< s of a cycle; raised to what the machine needs
  std::vector<WireAxis> axes;
  bool home = false;                        ///< the machine homes itself when it is opened
  std::function<void()> begin_thread = {};  ///< called by the thread of the wire when it begins
  std::function<bool()> given_up = {};      ///< asked while the machine homes itself: it shall stop
};

/// A machine on a wire. A thread of its own talks to it: each command that the servo's tick writes
/// wakes it for one exchange; the tick takes the newest answer and never waits. The WireLink knows
/// the protocol. The reaction when the wire fails is the same for all of them:
///
/// - An exchange without an answer is Silent; the next one repeats it.
/// - A step that the axis cannot have made is taken for a bad frame, once.
/// - An Alarm, and a port that has vanished, stay: nothing is enabled or opened again by itself.
/// - If this computer keeps the thread waiting for longer than kLate, that is Late, not Silent.
/// - The drives come under force with the first command, so that their watchdogs are fed from then
/// on.
/// - If the tick neither reads nor writes for kTickLost, nothing is sent, so that the machine's own
///   watchdog can act.
///
/// Times cross between the servo's clock and wire_time() by one constant difference, the least that
/// read() has seen, and never by looking at both clocks once: a thread that is kept waiting between
/// the two looks would move every stamp by that time.
class WireBackend final : public motion::ServoBackend {
 public:
  /// s. [choice] what a machine's watchdog should have; beyond any cycle that is only late.
  static constexpr double kTickLost = 0.1;
  /// s. [choice] as much as motion control makes up itself (docs/realtime.md).
  static constexpr double kLate = 0.2;

  WireBackend(WireSettings settings, std::unique_ptr<WireLink> link);
  ~WireBackend() override;

  int axes() const noexcept override { return static_cast<int>(settings_.axes.size()); }
  /// Connects, and reads where the axes stand; throws motion::DriverError.
  void open() override;
  void close() noexcept override;
  motion::DriverStatus enable(double now) noexcept override;
  void disable(double now) noexcept override;
  motion::DriverStatus read(double now, motion::ServoState& state) noexcept override;
  motion::DriverStatus write(double now, const motion::ServoCommand& command) noexcept override;
  bool follows_references() const noexcept override { return true; }
  std::string trouble() const override;
  std::string remark() const override;

  /// Since open(): where the axes stand, m or rad.
  const motion::JointVector& position() const { return position_; }
  /// Since open(): what the machine permits, m or rad; infinite where it does not say.
  double most(int axis) const;
  double least(int axis) const;
  double most_speed(int axis) const;
  double most_acceleration(int axis) const;
  double period() const { return period_; }
  /// s that the settings ask for; less than period() where the wire cannot do that.
  double asked_period() const { return settings_.period; }
  bool carries_signals() const { return link_->carries_signals(); }

 private:
  struct Report {
    motion::DriverStatus status = motion::DriverStatus::Ok;
    std::uint32_t number = 0;  ///< of the exchange
    double tried = 0;          ///< wire_time() of its end
    double errors = 0;         ///< share
    WireAnswer answer;
  };

  void first_exchange();
  void start();
  void run() noexcept;
  bool wait() noexcept;
  void wake() noexcept;
  void follow_wish(bool told) noexcept;
  void exchange() noexcept;
  motion::DriverStatus believed(motion::DriverStatus status, const WireAnswer& before,
                                const WireCommand& newest) noexcept;
  void publish(motion::DriverStatus status) noexcept;
  motion::DriverStatus status_of(const Report& report) noexcept;
  double zero_seen(double now) noexcept;
  double limit_in_si(int axis, const WireVector& at_plus, const WireVector& at_minus) const;

  WireSettings settings_;
  std::unique_ptr<WireLink> link_;
  std::unique_ptr<WirePort> port_;
  double period_ = 0;
  motion::JointVector position_;
  int event_ = -1;  ///< eventfd: there is something new for the thread
  std::thread thread_;
  std::atomic<bool> stopping_{false};
  std::atomic<bool> wanted_{false};  ///< enabled
  std::atomic<double> looked_{0};    ///< wire_time() of the tick's last read() or write()
  Latest<WireCommand> commands_;
  Latest<Report> reports_;

  // The tick's.
  double zero_ = std::numeric_limits<double>::infinity();  ///< wire_time() of the servo's 0
  std::uint32_t taken_ = 0;                                ///< number of the last report read

  // The thread's.
  Report report_;
  bool enabled_ = false;
  bool doubted_ = false;  ///< the last answer was taken for a bad frame
  bool first_ = true;
  double newest_ = 0;  ///< time of the newest command
  double window_ = 0;  ///< when the counting of errors began
  std::uint32_t exchanges_ = 0;
  std::uint32_t errors_before_ = 0;

  mutable std::mutex mutex_;  ///< of the texts
  std::string trouble_;
  std::string remark_;
};

}  // namespace rob::drivers
