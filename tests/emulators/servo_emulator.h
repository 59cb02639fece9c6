#pragma once

#include <array>
#include <map>

#include "tests/emulators/device_emulator.h"

namespace rob::test {

/// Servos on one bus: ROBOTIS' X series (protocol 2.0), Feetech's STS or SCS series (whose numbers
/// are big-endian, 1024 to its way, and which know no sync read), each with its table of registers,
/// and a motor that goes to its goal at `speed`. Those of ROBOTIS have a bus watchdog (register
/// 98), and do not take settings of their EEPROM (below 64) while their torque is on.
class ServoEmulator final : public DeviceEmulator {
 public:
  enum class Kind { Dynamixel, Feetech, FeetechScs };

  /// IDs 1 … count, all in their middle: 2048, SCS 512.
  ServoEmulator(Kind kind, int count);
  ~ServoEmulator() override { end(); }

  std::atomic<int> mute{0};         ///< the servo that does not answer; it hears
  std::atomic<double> speed{4000};  ///< ticks/s
  std::atomic<bool> frozen{false};  ///< the positions that they report stay as they are
  std::atomic<int> jumped{0};       ///< ticks that are added to them
  std::atomic<int> blocked{0};      ///< the servo whose axis is held fast

  void set(int id, int address, int size, std::uint32_t value);
  std::uint32_t get(int id, int address, int size) const;
  double position(int id) const;
  /// At an instant of the steady clock, s, near now; its motion is taken to be steady.
  double position_at(int id, double time) const;
  void stand_at(int id, double ticks);
  bool torque(int id) const;
  /// s from the first to the last change of a position.
  double moved_for() const;
  /// Its supply has failed for a moment: all that is not kept is as after switching on.
  void restart(int id);
  /// Its bus watchdog has stopped it.
  bool tripped(int id) const;

 private:
  struct Servo {
    std::array<std::uint8_t, 256> registers{};
    double position = 0;
    double velocity = 0;  ///< ticks/s
  };

  void take(std::uint8_t byte) override;
  void pass(double now) override;
  bool take_dynamixel();
  bool take_feetech();
  void carry_out(int id, int instruction, const Octets& p);
  void sync(int instruction, const Octets& p);
  void status(int id, std::uint8_t error, const Octets& p);
  void refresh(Servo& servo) const;
  void move(int id, Servo& servo, double now);
  bool refuses(const Servo& servo, int address) const;
  std::uint32_t value(const Servo& servo, int address, int size) const;
  void write(Servo& servo, int address, int size, std::uint32_t value) const;

  int torque_register() const { return kind_ == Kind::Dynamixel ? 64 : 40; }
  int width() const { return kind_ == Kind::Dynamixel ? 2 : 1; }  ///< of an address

  Kind kind_;
  std::map<int, Servo> servos_;
  Octets in_;
  double last_ = 0;
  double heard_ = 0;  ///< when the last instruction came
  double first_motion_ = -1;
  double last_motion_ = 0;
};

}  // namespace rob::test
