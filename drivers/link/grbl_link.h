#pragma once

#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "drivers/link/grbl_port.h"
#include "drivers/link/grbl_setup.h"
#include "drivers/link/grbl_stream.h"
#include "drivers/link/wire_link.h"
#include "drivers/protocol/grbl_line.h"

namespace rob::drivers {

/// grbl 1.1 or grblHAL. References go out as short moves of exact duration (GrblStream). grbl
/// reports where it stands ten times a second; that is compared with the references of that
/// instant. grbl has no watchdog: without references it stands when its moves are done, 80 ms
/// later.
///
/// Whatever makes grbl do something else than its moves ends the streaming with an Alarm that names
/// it: a hold, an open door, a jog or an override at the machine, another program's work offset,
/// answers that were lost.
class GrblLink final : public WireLink {
 public:
  static constexpr double kPeriod = GrblStream::kPeriod;

  /// `axes`: letter, X = 0; mm. `baud`: for the check that the moves fit through the line.
  explicit GrblLink(const std::vector<WireAxis>& axes, int baud = 115200);

  void connect(WirePort& port) override;
  void home(const std::function<bool()>& given_up) override;
  double least_period() const override { return kPeriod; }
  motion::DriverStatus enable() noexcept override;
  void disable() noexcept override;
  motion::DriverStatus exchange(const WireCommand* command, double deadline,
                                WireAnswer& answer) noexcept override;

 private:
  using Status = motion::DriverStatus;

  Status take(const grbl::Line& line) noexcept;
  Status take_status(const grbl::Status& status) noexcept;
  Status find_interference(const grbl::Status& status) noexcept;
  Status stop_streaming(const std::string& what, const std::string& remedy) noexcept;
  Status alarm(int number) noexcept;
  void query(double period) noexcept;
  Status stream(const WireCommand* command) noexcept;
  bool deserted(const WireCommand* command) const noexcept;
  void fill(WireAnswer& answer) noexcept;
  double instant_of_report() const noexcept;
  double silence(double now) const noexcept;
  Status check_answers(double now) noexcept;
  bool run_dry() noexcept;
  void brake() noexcept;
  bool wait_for(grbl::Machine machine, double seconds) noexcept;

  std::vector<WireAxis> axes_;
  int baud_;
  GrblPort port_;
  GrblSettings settings_;
  GrblStream stream_;
  std::deque<WireCommand> told_;  ///< the references of the last kWindow
  grbl::Machine machine_ = grbl::Machine::Unknown;
  int phase_ = 0;          ///< of its state
  WireVector offset_{};    ///< WCO
  WireVector position_{};  ///< of the last report
  double reported_ = 0;    ///< when it came; 0: never
  double asked_ = 0;       ///< when a report was asked for last
  double waiting_ = 0;     ///< since when one has been asked for and has not come; 0: none
  double sent_ = 0;        ///< when a line was sent last
  bool enabled_ = false;
  bool stopped_ = false;  ///< an alarm or an error: nothing more is streamed
  bool settled_ = true;   ///< nothing was streamed since the position was taken over at standstill
};

std::unique_ptr<WireLink> grbl_link(const std::vector<WireAxis>& axes, int baud = 115200);

}  // namespace rob::drivers
