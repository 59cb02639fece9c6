#pragma once

#include <array>
#include <deque>
#include <map>
#include <string>

#include "tests/emulators/device_emulator.h"

namespace rob::test {

/// grbl 1.1 as its wiki describes it: a planner of 15 blocks, a receive buffer of 128 bytes, moves
/// at constant speed for their time; a hold brakes within kBraking. mm, s.
class GrblEmulator final : public DeviceEmulator {
 public:
  static constexpr int kAxes = 3;

  GrblEmulator();
  ~GrblEmulator() override { end(); }

  static constexpr double kBraking = 0.05;

  std::map<int, double> settings;  ///< before it is talked to
  std::string banner = "Grbl 1.1h ['$' for help]";
  /// The report after a reset that has WCO first: 1 of grbl, 2 of grblHAL; 0: none ever has.
  int offset_in_report = 1;
  /// s from a reset to the banner, in which it drops what it receives. Above 0, an old banner is
  /// there before Rob says anything.
  double starts_for = 0;
  std::atomic<int> lost_oks{0};        ///< so many of the next are not sent
  std::atomic<int> error_next{0};      ///< the next line gets this error
  std::atomic<bool> jammed{false};     ///< its motors turn, its axes do not
  std::atomic<bool> homes_on{false};   ///< its homing switches are never met
  bool locked = false;                 ///< it starts in alarm
  bool opens_door = false;             ///< its door is open, whatever resets it
  std::array<double, kAxes> offset{};  ///< WCO

  void stand_at(double x, double y, double z);
  void raise_alarm(int number);
  void restart();
  void hold();       ///< feed hold is pressed
  void open_door();  ///< until it is reset
  void override_feed(int percent);
  void set_offset(const std::array<double, kAxes>& now);  ///< by another sender, while it runs
  /// A line of another sender, whose answer goes there.
  void take_foreign(const std::string& line);

  std::array<double, kAxes> position() const;
  /// s from the first move to the end of the last.
  double moved_for() const;
  int overflows() const { return overflows_; }
  int moves() const { return moves_; }
  int resets() const { return resets_; }
  int homing() const { return homing_; }  ///< how often it was told to home itself
  bool idle() const;

 private:
  struct Block {
    std::array<double, kAxes> target;
    double seconds;
    bool jog;
  };

  void take(std::uint8_t byte) override;
  void pass(double now) override;
  void real_time(std::uint8_t byte);
  void carry_out(const std::string& line);
  void system_command(const std::string& line);
  void g_code(const std::string& line, bool jog);
  void say(const std::string& line);
  void ok();
  void report();
  void reset();
  std::string state() const;
  void list_parameters();
  void greet();
  void run(double seconds);

  std::string line_;
  std::deque<std::string> lines_;  ///< received, not carried out
  int buffered_ = 0;               ///< bytes of lines_ and line_
  std::deque<Block> blocks_;
  std::array<double, kAxes> here_{};
  std::array<double, kAxes> planned_{};  ///< end of the last block
  std::array<double, kAxes> from_{};     ///< begin of the present one
  double begun_ = 0;
  bool running_ = false;
  double last_ = 0;
  double machine_time_ = 0;  ///< s; passes as its moves do
  double pace_ = 1;          ///< machine time a second, without the override
  bool alarm_ = false;
  bool held_ = false;
  bool door_ = false;
  bool foreign_ = false;  ///< the line that is carried out is another sender's
  int override_ = 100;    ///< %
  bool tell_override_ = true;
  double started_ = 0;   ///< when it takes again what comes
  bool greets_ = false;  ///< its banner is due
  bool relative_ = false;
  bool inverse_time_ = false;
  double feed_ = 0;
  int reports_ = 0;
  std::atomic<int> overflows_{0};
  std::atomic<int> resets_{0};
  std::atomic<int> homing_{0};
  std::atomic<int> moves_{0};
  double first_move_ = -1;
  double last_move_ = 0;
};

}  // namespace rob::test
