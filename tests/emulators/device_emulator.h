#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <deque>
#include <mutex>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "tests/support/pty_wire.h"

namespace rob::test {

using Octets = std::vector<std::uint8_t>;

/// A device behind a pseudo-terminal, with everything that can go wrong on a wire. The classes
/// derived from it are written from the documents of their protocols, and share no code with the
/// drivers. It is switched on, in a thread of its own, when its path is asked for first; the
/// derived class calls end() first thing in its destructor.
class DeviceEmulator {
 public:
  std::atomic<bool> silent{false};  ///< it answers nothing
  std::atomic<int> corrupt{0};      ///< % of answers in which one bit is wrong
  std::atomic<int> garbage{0};      ///< % of answers behind noise
  std::atomic<int> halved{0};       ///< % of answers that break off
  std::atomic<int> late_ms{0};      ///< each answer takes it that long
  std::atomic<int> kept_ms{0};      ///< its adapter keeps each answer for a random time up to that
  std::atomic<bool> echo_old{false};  ///< before each answer comes the one before it again
  std::atomic<bool> echoes{false};    ///< its adapter gives back what is sent to it
  std::atomic<int> baud{0};           ///< bytes take the time that this gives them; 0: none

  virtual ~DeviceEmulator() = default;

  const std::string& path() {
    if (!thread_.joinable()) thread_ = std::thread([this] { serve(); });
    return wire_.path();
  }
  /// Its thread does it, which may be waiting for bytes.
  void unplug() {
    leaving_ = true;
    while (!gone_) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  int questions() const { return questions_; }

 protected:
  void end() {
    stopping_ = true;
    if (thread_.joinable()) thread_.join();
  }
  /// s since it was switched on.
  double now() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - on_).count();
  }
  /// The instant of the steady clock at which it was switched on, s.
  double on() const { return std::chrono::duration<double>(on_.time_since_epoch()).count(); }
  virtual void take(std::uint8_t byte) = 0;
  virtual void pass(double now) = 0;
  void answer(Octets bytes) {
    ++questions_;
    if (silent) return;
    take_time(bytes.size());
    if (late_ms > 0) std::this_thread::sleep_for(std::chrono::milliseconds(late_ms));
    const Octets clean = bytes;
    if (happens(corrupt) && !bytes.empty()) {
      std::uint8_t& byte = bytes[random_() % bytes.size()];
      byte = static_cast<std::uint8_t>(byte ^ 1U << random_() % 8);
    }
    if (happens(halved)) bytes.resize(bytes.size() / 2);
    if (happens(garbage)) bytes.insert(bytes.begin(), {0x3C, 0x81, 0x00, 0x42, 0x7E});
    if (echo_old) bytes.insert(bytes.begin(), old_.begin(), old_.end());
    old_ = clean;
    if (kept_ms == 0 && kept_.empty()) return wire_.send(bytes);
    const double until = now() + 1e-3 * static_cast<double>(random_() % 1000) / 1000 * kept_ms;
    kept_.push_back({kept_.empty() ? until : std::max(until, kept_.back().until), bytes});
  }

  mutable std::mutex mutex_;  ///< held while bytes are taken and time passes

 private:
  /// An answer in the adapter; none overtakes another.
  struct Kept {
    double until;
    Octets bytes;
  };

  void send_kept() {
    for (; !kept_.empty() && kept_.front().until <= now(); kept_.pop_front())
      wire_.send(kept_.front().bytes);
  }
  /// Of so many bytes on the line, which are sent one after the other without a pause.
  void take_time(std::size_t bytes) {
    constexpr double kBits = 10;
    if (baud == 0 || bytes == 0) return;
    line_free_ = std::max(line_free_, now()) + kBits * static_cast<double>(bytes) / baud;
    std::this_thread::sleep_until(on_ +
                                  std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                                      std::chrono::duration<double>(line_free_)));
  }
  bool happens(int percent) { return static_cast<int>(random_() % 100) < percent; }

  void serve() {
    while (!stopping_ && !leaving_) {
      const Octets bytes = wire_.receive(1);
      if (echoes) wire_.send(bytes);
      take_time(bytes.size());
      const std::lock_guard lock(mutex_);
      pass(now());
      for (const std::uint8_t byte : bytes) take(byte);
      send_kept();
    }
    if (leaving_) wire_.unplug();
    gone_ = true;
  }

  PtyWire wire_;
  std::chrono::steady_clock::time_point on_ = std::chrono::steady_clock::now();
  double line_free_ = 0;  ///< when the last byte has passed, s
  std::mt19937 random_{1};
  Octets old_;
  std::deque<Kept> kept_;
  std::atomic<int> questions_{0};
  std::atomic<bool> stopping_{false};
  std::atomic<bool> leaving_{false};
  std::atomic<bool> gone_{false};
  std::thread thread_;
};

}  // namespace rob::test
