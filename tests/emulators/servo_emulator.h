#pragma once

#include <array>
#include <map>

#include "tests/emulators/device_emulator.h"

namespace rob::test {

/// Servos on one bus: ROBOTIS' X series (protocol 2.0) or Feetech's STS series, each with its table
/// of registers, and a motor that goes to its goal at kSpeed.
class ServoEmulator final : public DeviceEmulator {
 public:
  enum class Kind { Dynamixel, Feetech };
  static constexpr double kSpeed = 4000;  ///< ticks/s

  /// IDs 1 … count, all at 2048.
  ServoEmulator(Kind kind, int count);
  ~ServoEmulator() override { end(); }

  std::atomic<int> mute{0};  ///< the servo that does not answer; it hears

  void set(int id, int address, int size, std::uint32_t value);
  std::uint32_t get(int id, int address, int size) const;
  double position(int id) const;
  void stand_at(int id, double ticks);
  bool torque(int id) const;
  /// Its supply has failed for a moment: torque off, as after switching on.
  void restart(int id);

 private:
  struct Servo {
    std::array<std::uint8_t, 256> registers{};
    double position = 2048;
    bool jams = false;
  };

  void take(std::uint8_t byte) override;
  void pass(double now) override;
  bool take_dynamixel();
  bool take_feetech();
  void carry_out(int id, int instruction, const Octets& p);
  void sync(int instruction, const Octets& p);
  void status(int id, std::uint8_t error, const Octets& p);
  void refresh(Servo& servo) const;
  std::uint32_t value(const Servo& servo, int address, int size) const;

  int torque_register() const { return kind_ == Kind::Dynamixel ? 64 : 40; }
  int width() const { return kind_ == Kind::Dynamixel ? 2 : 1; }  ///< of an address

  Kind kind_;
  std::map<int, Servo> servos_;
  Octets in_;
  double last_ = 0;
};

}  // namespace rob::test
