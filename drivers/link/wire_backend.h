#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "drivers/latest.h"
#include "drivers/link/wire_link.h"
#include "drivers/serial/serial_port.h"
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

/// A machine on a serial line. A thread of its own talks to it: each command that the servo's tick
/// writes wakes it for one exchange; the tick takes the newest answer and never waits. What the
/// protocol is, is the WireLink's affair; what is done when it fails is the same for all of them:
///
/// - an exchange without an answer is Silent, and repeated by the next one;
/// - a step that the axis cannot have made is taken for a bad frame, once;
/// - an Alarm, and a port that has vanished, stay: nothing is enabled or opened again by itself;
/// - while the tick writes nothing for kTickLost, nothing is sent, so that the machine's own
/// watchdog
///   can act.
class WireBackend final : public motion::ServoBackend {
 public:
  /// s. [choice] what a machine's watchdog should have; beyond any cycle that is only late.
  static constexpr double kTickLost = 0.1;

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

  /// Since open(): where the axes stand, m or rad.
  const motion::JointVector& position() const { return position_; }
  /// Since open(): what the machine permits, m or rad; infinite where it does not say.
  double most(int axis) const;
  double least(int axis) const;
  double most_speed(int axis) const;
  double most_acceleration(int axis) const;
  double period() const { return period_; }

 private:
  struct Report {
    motion::DriverStatus status = motion::DriverStatus::Ok;
    double received = 0;  ///< wire_time() of the last exchange that was answered
    double errors = 0;    ///< share
    WireAnswer answer;
  };

  void first_exchange();
  void start();
  void run() noexcept;
  bool wait() noexcept;
  void wake() noexcept;
  void follow_wish() noexcept;
  void exchange() noexcept;
  motion::DriverStatus believed(motion::DriverStatus status, const WireAnswer& before) noexcept;
  void publish(motion::DriverStatus status) noexcept;
  double limit_in_si(int axis, const WireVector& at_plus, const WireVector& at_minus) const;

  WireSettings settings_;
  std::unique_ptr<WireLink> link_;
  std::optional<SerialPort> port_;
  double period_ = 0;
  motion::JointVector position_;
  int event_ = -1;  ///< eventfd: there is something new for the thread
  std::thread thread_;
  std::atomic<bool> stopping_{false};
  std::atomic<bool> wanted_{false};  ///< enabled
  Latest<WireCommand> commands_;
  Latest<Report> reports_;

  // The thread's.
  Report report_;
  bool enabled_ = false;
  bool doubted_ = false;  ///< the last answer was taken for a bad frame
  bool first_ = true;
  double newest_ = 0;  ///< time of the newest command
  double window_ = 0;  ///< when the counting of errors began
  std::uint32_t exchanges_ = 0;
  std::uint32_t errors_before_ = 0;

  mutable std::mutex mutex_;  ///< of trouble_
  std::string trouble_;
};

}  // namespace rob::drivers
