#pragma once

#include <string>
#include <vector>

#include "drivers/link/answer_turns.h"
#include "drivers/link/packet_port.h"
#include "drivers/link/servo_dialect.h"
#include "drivers/link/wire_link.h"

namespace rob::drivers {

/// Servos with position loops of their own on one half-duplex bus. A cycle is one sync write of all
/// goals and one sync read of all positions. A mute servo stalls those after it in the chain, so
/// Rob then asks each of these by itself, and so it does on a bus without sync read. Rob waits as
/// long as the bytes take at this baud rate, however short the cycle.
///
/// Every tenth cycle Rob also asks one servo for its health, and it asks a servo that stands while
/// its goal moves away at once. An alert is an Alarm, and so is torque that is off after a restart.
///
/// An answer that comes after its cycle is never taken for an answer of a later one: the questions
/// of the cycles after it differ, up to the seventh.
///
/// connect() detects an adapter that echoes what Rob sends.
template <typename Dialect>
class ServoLink final : public WireLink {
 public:
  /// `axes`: ID, and ticks per rad or m. `baud`: for the least period of a cycle.
  ServoLink(const std::vector<WireAxis>& axes, int baud);

  void connect(WirePort& port) override;
  double least_period() const override;
  motion::DriverStatus enable() noexcept override;
  void disable() noexcept override;
  motion::DriverStatus exchange(const WireCommand* command, double deadline,
                                WireAnswer& answer) noexcept override;

 private:
  using Packets = PacketPort<typename Dialect::Format>;
  using Frame = typename Dialect::Frame;
  using Result = typename Packets::Result;

  std::string servo(std::size_t i) const;
  template <typename Wanted>
  Result ask(std::size_t i, const typename Dialect::Wire& question, Frame& answer, double deadline,
             const Wanted& wanted) noexcept;
  std::size_t sender_of(const Frame& frame) const noexcept;
  void note_late(const Frame& frame) noexcept;
  void hear_out(double deadline) noexcept;
  Frame must_ask(std::size_t i, const typename Dialect::Wire& question);
  void check_mode(std::size_t i);
  void configure(std::size_t i);
  void write_setting(std::size_t i, const ServoSetting& setting);
  void release_torque(std::size_t i);
  double time_of(double bytes) const noexcept;
  double chain_time() const noexcept;
  double question_time(int answer) const noexcept;
  int reading_bytes() const noexcept;
  Result send_goals(const WireVector& position, double deadline) noexcept;
  Result read_all(double deadline, WireAnswer& answer) noexcept;
  Result read_each(double deadline, WireAnswer& answer) noexcept;
  bool take(std::size_t i, const Frame& frame, WireAnswer& answer) noexcept;
  motion::DriverStatus judge(Result result, double deadline) noexcept;
  motion::DriverStatus no_answer() noexcept;
  void watch_stalls(const WireCommand* command, const WireAnswer& before,
                    const WireAnswer& answer) noexcept;
  motion::DriverStatus check_health(std::size_t i, double deadline) noexcept;
  motion::DriverStatus check_watchdog(std::size_t i, double deadline) noexcept;

  std::vector<WireAxis> axes_;
  std::vector<std::uint8_t> ids_;
  int baud_;
  Packets packets_;
  WireVector last_{};
  std::vector<bool> answered_;
  std::uint32_t cycle_ = 0;
  std::string complaint_;        ///< of a servo, in this cycle
  std::size_t stalled_ = kNone;  ///< the servo that stands while its goal goes away
  AnswerTurns turns_;
  bool enabled_ = false;

  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
};

}  // namespace rob::drivers
