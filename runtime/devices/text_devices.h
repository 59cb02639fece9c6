#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lang/code/chunk.h"
#include "runtime/devices/device_connection.h"
#include "runtime/words/words.h"

namespace rob::runtime {

/// The DEVICEs of a program: connections in a run in real time; on the virtual clock what a signal
/// script and SIMULATE say that they send.
class TextDevices {
 public:
  /// Without connections: the virtual clock.
  explicit TextDevices(const std::vector<lang::DeviceCode>& devices);

  /// Connects to all of them. Throws motion::DriverError where one is not there within 5 s.
  void connect();
  bool real() const { return real_; }

  // The program's thread
  /// Why nothing can be sent to it, or received.
  std::optional<Words> objection(std::size_t device) const;
  /// A text is on its way in motion order: send() will follow.
  void sending(std::size_t device) { ++devices_[device].asked; }
  bool sends_pending(std::size_t device) const;
  /// The next line; `now`: s of the run.
  std::optional<std::string> take(std::size_t device, double now);
  /// Whether any is still to come, on the virtual clock.
  bool any_left(std::size_t device) const {
    return devices_[device].promised || !devices_[device].simulated.empty();
  }

  // The thread that reports
  void send(std::size_t device, std::string_view text);
  /// On the virtual clock: it sends this text and its ending at that time of the run, s.
  void give(std::size_t device, double time, std::string_view text);
  /// On the virtual clock: it will send lines at times that nobody knows yet. Before the run.
  void promise(std::size_t device) { devices_[device].promised = true; }
  enum class Telling : std::uint8_t {
    Seldom,  ///< of a real device once a second
    All      ///< what is left at the end of a run
  };
  /// For people: what devices have sent in vain.
  std::vector<std::string> take_events(Telling telling = Telling::Seldom);

 private:
  struct Line {
    double time;
    std::string text;
  };
  struct Device {
    lang::DeviceCode code;
    std::unique_ptr<DeviceConnection> connection{};
    std::deque<Line> simulated{};  ///< by time
    bool promised = false;
    std::size_t dropped = 0;                       ///< lines that nobody has been told of
    std::chrono::steady_clock::time_point told{};  ///< when that was last done
    std::int64_t asked = 0;                        ///< SENDs of the program
    std::atomic<std::int64_t> sent{0};
  };

  std::deque<Device> devices_;
  bool real_ = false;
};

}  // namespace rob::runtime
