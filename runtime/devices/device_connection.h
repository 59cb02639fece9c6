#pragma once

#include <atomic>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>

#include "lang/code/chunk.h"
#include "runtime/devices/device_lines.h"

namespace rob::runtime {

/// The connection to one device, with a thread of its own: whatever the device does, nobody waits
/// for it. A connection that is lost is made again, tried once a second.
class DeviceConnection {
 public:
  explicit DeviceConnection(const lang::DeviceCode& device);
  ~DeviceConnection();
  DeviceConnection(const DeviceConnection&) = delete;
  DeviceConnection& operator=(const DeviceConnection&) = delete;

  bool connected() const { return connected_.load(std::memory_order_acquire); }
  /// Why it is not.
  std::string trouble() const;
  /// Drops the lines that wait to be received; then the text goes out, with the device's ending.
  void send(std::string_view text);
  std::optional<std::string> take();
  std::size_t take_dropped();

 private:
  void run();
  void serve();

  const std::string address_;
  const std::string ending_;
  std::atomic<bool> over_{false};
  std::atomic<bool> connected_{false};
  mutable std::mutex mutex_;
  DeviceLines lines_;
  std::string outgoing_;
  std::string trouble_;
  std::thread thread_;
};

}  // namespace rob::runtime
