#pragma once

#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "drivers/link/grbl_stream.h"
#include "drivers/link/wire_link.h"
#include "drivers/protocol/grbl_line.h"

namespace rob::drivers {

/// grbl 1.1 or grblHAL. References go out as short moves of exact duration (GrblStream), where the
/// machine stands comes back ten times a second, compared with the references of that instant.
/// grbl has no watchdog: without references it stands when its moves are done, 80 ms later.
class GrblLink final : public WireLink {
 public:
  static constexpr double kPeriod = 0.02;  ///< s a move: 50 Hz, of which 115200 baud bears twice

  /// `axes`: letter, X = 0; mm.
  explicit GrblLink(const std::vector<WireAxis>& axes);

  void connect(SerialPort& port) override;
  void home(const std::function<bool()>& given_up) override;
  double least_period() const override { return kPeriod; }
  motion::DriverStatus enable() noexcept override;
  void disable() noexcept override;
  motion::DriverStatus exchange(const WireCommand* command, double deadline,
                                WireAnswer& answer) noexcept override;

 private:
  using Status = motion::DriverStatus;

  bool send(std::string_view text) noexcept;
  bool send_byte(std::uint8_t byte) noexcept;
  /// The next line until then; none: `gone_`, or the time is over.
  bool next_line(grbl::Line& line, double deadline) noexcept;
  void greet();
  void read_settings();
  void carry_out(const std::string& line, double seconds, const std::string& what,
                 const std::function<bool()>& given_up = {});
  double setting(int number) const;
  void check_settings();
  void take_limits();

  Status take(const grbl::Line& line) noexcept;
  Status take_status(const grbl::Status& status) noexcept;
  Status stop_streaming(std::string trouble) noexcept;
  Status alarm(int number) noexcept;
  void query(double now) noexcept;
  Status stream(const WireCommand* command) noexcept;
  double instant_of_report() const noexcept;
  Status check_answers(double now) noexcept;
  bool wait_for(grbl::Machine machine, double seconds) noexcept;

  std::vector<WireAxis> axes_;
  SerialPort* port_ = nullptr;
  grbl::LineReader reader_;
  std::array<std::uint8_t, 512> bytes_{};
  Bytes unread_;
  bool gone_ = false;
  std::map<int, double> settings_;
  GrblStream stream_;
  std::deque<WireCommand> told_;  ///< the references of the last kWindow
  grbl::Machine machine_ = grbl::Machine::Unknown;
  WireVector offset_{};    ///< WCO
  WireVector position_{};  ///< of the last report
  double reported_ = 0;    ///< when it came; 0: never
  double asked_ = 0;
  bool enabled_ = false;
  bool stopped_ = false;  ///< an alarm or an error: nothing more is streamed
  bool settled_ = true;   ///< nothing was streamed since the place was taken over at standstill
};

std::unique_ptr<WireLink> grbl_link(const std::vector<WireAxis>& axes);

}  // namespace rob::drivers
