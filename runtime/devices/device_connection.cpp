#include "runtime/devices/device_connection.h"

#include <chrono>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "drivers/serial/open_port.h"
#include "motion/servo/servo_backend.h"

namespace rob::runtime {

namespace {

using namespace std::chrono_literals;

constexpr double kLook = 0.01;                // s between two looks at what is to be sent [choice]
constexpr auto kPause = 5ms;                  // between two reads of what a device sends [choice]
constexpr std::size_t kMostRead = 65536;      // bytes in one read [choice]
constexpr double kSendTime = 1;               // s that a device may take to accept a text [choice]
constexpr std::size_t kMostOutgoing = 65536;  // bytes [choice]

std::span<const std::uint8_t> bytes_of(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

}  // namespace

DeviceConnection::DeviceConnection(const lang::DeviceCode& device)
    : address_(device.address),
      ending_(device.ending),
      lines_(device.ending),
      thread_([this] { run(); }) {}

DeviceConnection::~DeviceConnection() {
  over_ = true;
  if (thread_.joinable()) thread_.join();
}

std::string DeviceConnection::trouble() const {
  const std::scoped_lock lock(mutex_);
  return trouble_;
}

void DeviceConnection::send(std::string_view text) {
  const std::scoped_lock lock(mutex_);
  lines_.clear();
  if (outgoing_.size() + text.size() > kMostOutgoing) return;
  outgoing_.append(text).append(ending_);
}

std::optional<std::string> DeviceConnection::take() {
  const std::scoped_lock lock(mutex_);
  return lines_.take();
}

std::size_t DeviceConnection::take_dropped() {
  const std::scoped_lock lock(mutex_);
  return lines_.take_dropped();
}

void DeviceConnection::run() {
  while (!over_) {
    try {
      serve();
    } catch (const motion::DriverError& error) {
      const std::scoped_lock lock(mutex_);
      trouble_ = error.what();
    }
    connected_ = false;
    for (int i = 0; i < 100 && !over_; ++i) std::this_thread::sleep_for(10ms);
  }
}

/// As long as the connection lasts. A line for one that is gone is not sent later. A device that
/// floods is read in few large pieces: so it keeps no processor busy.
void DeviceConnection::serve() {
  const std::unique_ptr<drivers::WirePort> port = drivers::open_port(address_, 0);
  {
    const std::scoped_lock lock(mutex_);
    outgoing_.clear();
    lines_.break_off();
    trouble_ = "the connection to " + address_ + " is lost";
  }
  connected_.store(true, std::memory_order_release);
  std::vector<std::uint8_t> buffer(kMostRead);
  while (!over_) {
    const drivers::WireIo read = port->read(buffer, drivers::wire_time() + kLook);
    std::string text;
    {
      const std::scoped_lock lock(mutex_);
      lines_.add({reinterpret_cast<const char*>(buffer.data()), read.bytes});
      text = std::exchange(outgoing_, "");
    }
    if (read.status == drivers::WireIo::Status::Gone) return;
    if (!text.empty()) {
      const auto written = port->write(bytes_of(text), drivers::wire_time() + kSendTime);
      if (written.status != drivers::WireIo::Status::Ok) return;
    }
    if (read.bytes > 0) std::this_thread::sleep_for(kPause);
  }
}

}  // namespace rob::runtime
