#include "runtime/devices/text_devices.h"

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "lang/text/codes.h"
#include "motion/servo/servo_backend.h"

namespace rob::runtime {

namespace {

using namespace std::chrono_literals;

constexpr auto kConnectTime = 5s;
constexpr auto kBetweenEvents = 1s;  // of one device
constexpr double kSameTime = 1e-9;   // s

}  // namespace

TextDevices::TextDevices(const std::vector<lang::DeviceCode>& devices) {
  for (const lang::DeviceCode& device : devices) devices_.emplace_back().code = device;
}

void TextDevices::connect() {
  real_ = true;
  for (Device& device : devices_)
    device.connection = std::make_unique<DeviceConnection>(device.code);
  const auto latest = std::chrono::steady_clock::now() + kConnectTime;
  for (const Device& device : devices_) {
    while (!device.connection->connected()) {
      if (std::chrono::steady_clock::now() >= latest)
        throw motion::DriverError(
            fmt::format("DEVICE {}: {}", device.code.name, device.connection->trouble()));
      std::this_thread::sleep_for(10ms);
    }
  }
}

std::optional<Words> TextDevices::objection(std::size_t device) const {
  const Device& asked = devices_[device];
  if (!real_ || asked.connection->connected()) return std::nullopt;
  return Words{std::string(lang::code::kNoConnection),
               fmt::format("{}: {}", asked.code.name, asked.connection->trouble()),
               "it is tried again every second; a TRY can wait for it"};
}

bool TextDevices::sends_pending(std::size_t device) const {
  const Device& asked = devices_[device];
  return asked.sent.load(std::memory_order_acquire) < asked.asked;
}

std::optional<std::string> TextDevices::take(std::size_t device, double now) {
  Device& asked = devices_[device];
  if (real_) return asked.connection->take();
  if (asked.simulated.empty() || asked.simulated.front().time > now + kSameTime)
    return std::nullopt;
  std::string line = std::move(asked.simulated.front().text);
  asked.simulated.pop_front();
  return line;
}

void TextDevices::send(std::size_t device, std::string_view text) {
  Device& asked = devices_[device];
  if (real_) asked.connection->send(text);
  asked.sent.fetch_add(1, std::memory_order_release);
}

/// Cut into lines as what a real one sends.
void TextDevices::give(std::size_t device, double time, std::string_view text) {
  if (real_) return;
  Device& given = devices_[device];
  DeviceLines lines(given.code.ending);
  lines.add(text);
  lines.add(given.code.ending);
  given.dropped += lines.take_dropped();
  std::deque<Line>& all = given.simulated;
  const auto later = [&] {
    return std::ranges::find_if(all, [&](const Line& one) { return one.time > time; });
  };
  while (auto line = lines.take()) all.insert(later(), {time, std::move(*line)});
}

std::vector<std::string> TextDevices::take_events(Telling telling) {
  std::vector<std::string> events;
  const auto now = std::chrono::steady_clock::now();
  for (Device& device : devices_) {
    if (device.connection != nullptr) device.dropped += device.connection->take_dropped();
    const bool told_lately = real_ && now - device.told < kBetweenEvents;
    if (device.dropped == 0 || (told_lately && telling == Telling::Seldom)) continue;
    const std::size_t dropped = std::exchange(device.dropped, 0);
    device.told = now;
    events.push_back(
        fmt::format("DEVICE {}: {} line{} dropped: longer than 4 KiB, or nobody has "
                    "received them",
                    device.code.name, dropped, dropped == 1 ? "" : "s"));
  }
  return events;
}

}  // namespace rob::runtime
