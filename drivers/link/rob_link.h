#pragma once

#include <memory>
#include <vector>

#include "drivers/link/packet_port.h"
#include "drivers/link/wire_link.h"
#include "drivers/protocol/rob_frame.h"

namespace rob::drivers {

/// A device that speaks Rob's own protocol (docs/serial-protocol.md). References go out with the
/// instant of the device's clock at which they hold, kLead periods ahead; the state that comes back
/// is compared with the references of its own instant.
class RobLink final : public WireLink {
 public:
  /// Periods between a reference and its instant: one on the way, one between its neighbours, and
  /// one for a computer that is late.
  static constexpr int kLead = 3;

  /// Units: 1e-6 mm or deg. `period`: of a cycle, s. `baud`: of the line, which bounds a cycle
  /// unless the device is on USB or a network.
  RobLink(const std::vector<WireAxis>& axes, double period, int baud = 115200);

  void connect(WirePort& port) override;
  double least_period() const override;
  /// Throws motion::DriverError where REF cannot have it: its 16 bits end at 65.535 ms.
  void use_period(double period) override;
  motion::DriverStatus enable() noexcept override;
  void disable() noexcept override;
  motion::DriverStatus exchange(const WireCommand* command, double deadline,
                                WireAnswer& answer) noexcept override;

 private:
  using Packets = PacketPort<wire::Format>;
  using Result = Packets::Result;

  double round_trip() const noexcept;
  Result ask(wire::Type type, Bytes payload, wire::Frame& answer, double deadline) noexcept;
  Result ask_state(wire::Type type, Bytes payload, double deadline) noexcept;
  ByteBuffer<wire::kMostPayload> reference_of(const WireCommand& command) const noexcept;
  Result enable_drives() noexcept;
  Result ask_as_it_is(double deadline) noexcept;
  void run_dry() noexcept;
  void follow_clock(double asked, double answered) noexcept;
  motion::DriverStatus judge(Result result) noexcept;
  void fill(WireAnswer& answer) const noexcept;

  int axes_;
  double period_;
  int baud_;
  Packets packets_;
  wire::Info info_;
  wire::State state_;
  std::uint8_t sequence_ = 0;
  bool enabled_ = false;
  int late_ = 0;  ///< cycles for which it is still remembered that an answer came late
  // The device's clock: device = wire_time()·1e6 + offset_, modulo 2^32.
  double offset_ = 0;
  double trip_ = 0;  ///< s of the quickest answer so far, forgotten slowly
  bool clocked_ = false;
};

std::unique_ptr<WireLink> rob_link(const std::vector<WireAxis>& axes, double period,
                                   int baud = 115200);

}  // namespace rob::drivers
