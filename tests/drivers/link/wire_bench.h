#pragma once

#include <chrono>
#include <cmath>
#include <map>
#include <memory>
#include <thread>
#include <vector>

#include "drivers/link/grbl_link.h"
#include "drivers/link/rob_link.h"
#include "drivers/link/servo_driver.h"
#include "drivers/link/wire_backend.h"
#include "tests/support/eventually.h"

namespace rob::test {

using motion::DriverStatus;

using drivers::WireAxis;

/// Axes in units of their own, so that 1 is a tick, a millimetre, or 1e-6 of it; unlimited speed.
inline std::vector<WireAxis> plain_axes(int count, int first_address, double most = 0) {
  std::vector<WireAxis> axes;
  for (int i = 0; i < count; ++i)
    axes.push_back({"xyzabc"[i] + std::string(), first_address + i, 1, 0, most});
  return axes;
}

inline drivers::WireSettings settings_for(const std::string& port, std::vector<WireAxis> axes,
                                          double period) {
  return {port, 115200, period, std::move(axes)};
}

/// The servo's tick without the rest of a controller: reads, and writes a reference, each period.
class WireBench {
 public:
  explicit WireBench(std::unique_ptr<drivers::WireBackend> machine)
      : machine_(std::move(machine)), begun_(drivers::wire_time()) {
    machine_->open();
    period_ = machine_->period();
    command_.reference.q = machine_->position();
    command_.reference.qd = motion::JointVector::Zero(machine_->axes());
    command_.reference.qdd = command_.reference.qd;
    machine_->enable(now());
  }

  double now() const { return drivers::wire_time() - begun_; }
  /// A cycle towards q; what read() said.
  DriverStatus cycle(const motion::JointVector& q) {
    const double t = now();
    const DriverStatus status = machine_->read(t, state_);
    command_.reference.time = t;
    command_.reference.qd = (q - command_.reference.q) / period_;
    command_.reference.q = q;
    machine_->write(t, command_);
    ++statuses_[status];
    std::this_thread::sleep_for(std::chrono::duration<double>(period_));
    return status;
  }
  /// Reads, and writes nothing.
  DriverStatus look() { return machine_->read(now(), state_); }
  /// Stands for so long; true when `status` comes before that.
  bool comes(DriverStatus status, double seconds) {
    const double end = now() + seconds;
    const motion::JointVector q = command_.reference.q;
    while (now() < end)
      if (cycle(q) == status) return true;
    return false;
  }
  /// From where it is to q, steadily.
  void go(const motion::JointVector& q, double seconds) {
    const motion::JointVector from = command_.reference.q;
    const double start = now();
    for (double share = 0; share < 1;) {
      share = std::min((now() - start) / seconds, 1.0);
      cycle(from + share * (q - from));
    }
  }

  drivers::WireBackend& machine() { return *machine_; }
  const motion::ServoState& state() const { return state_; }
  int count(DriverStatus status) { return statuses_[status]; }
  void close() { machine_->close(); }

 private:
  std::unique_ptr<drivers::WireBackend> machine_;
  double begun_;
  double period_ = 0.01;
  motion::ServoState state_;
  motion::ServoCommand command_;
  std::map<DriverStatus, int> statuses_;
};

inline motion::JointVector all(int count, double value) {
  return motion::JointVector::Constant(count, value);
}

inline bool mentions(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// What is said when it is opened; empty: nothing is wrong.
inline std::string trouble_opening(drivers::WireBackend& machine) {
  try {
    machine.open();
  } catch (const motion::DriverError& error) {
    return error.what();
  }
  return "";
}

}  // namespace rob::test
