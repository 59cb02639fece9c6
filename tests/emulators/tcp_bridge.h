#pragma once

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <string>
#include <system_error>
#include <thread>

namespace rob::test {

/// A serial server: a TCP port of this computer whose bytes are those of a serial port. One
/// connection after another.
class TcpBridge {
 public:
  explicit TcpBridge(const std::string& serial)
      : serial_(::open(serial.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC)),
        listener_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    auto* const plain = reinterpret_cast<sockaddr*>(&address);
    if (serial_ < 0 || listener_ < 0 || ::bind(listener_, plain, size) != 0 ||
        ::listen(listener_, 1) != 0 || ::getsockname(listener_, plain, &size) != 0)
      throw std::system_error(errno, std::generic_category(), "TCP bridge");
    port_ = ntohs(address.sin_port);
    thread_ = std::thread([this] { serve(); });
  }
  ~TcpBridge() {
    ending_ = true;
    thread_.join();
    ::close(listener_);
    ::close(serial_);
  }
  TcpBridge(const TcpBridge&) = delete;
  TcpBridge& operator=(const TcpBridge&) = delete;

  std::string address() const { return "tcp://127.0.0.1:" + std::to_string(port_); }
  /// The connection breaks, and no other is taken.
  void cut() { cut_ = true; }
  int connections() const { return connections_; }

 private:
  static constexpr int kLook = 5;  // ms

  void serve() {
    while (!ending_) {
      pollfd waits{listener_, POLLIN, 0};
      if (cut_ || ::poll(&waits, 1, kLook) <= 0) continue;
      const int client = ::accept4(listener_, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
      if (client < 0) continue;
      ++connections_;
      while (!ending_ && !cut_ && pass_on(client)) {
      }
      ::close(client);
    }
  }
  bool pass_on(int client) const {
    pollfd waits[] = {{client, POLLIN, 0}, {serial_, POLLIN, 0}};
    ::poll(waits, 2, kLook);
    return copy(client, serial_) && copy(serial_, client);
  }
  /// False: the source has gone.
  static bool copy(int from, int to) {
    std::array<char, 1024> bytes;
    const ssize_t count = ::read(from, bytes.data(), bytes.size());
    if (count == 0 || (count < 0 && errno != EAGAIN)) return false;
    for (ssize_t done = 0; done < count;) {
      const ssize_t written =
          ::write(to, bytes.data() + done, static_cast<std::size_t>(count - done));
      if (written < 0 && errno != EAGAIN) return false;
      done += written > 0 ? written : 0;
    }
    return true;
  }

  int serial_;
  int listener_;
  int port_ = 0;
  std::atomic<bool> ending_{false};
  std::atomic<bool> cut_{false};
  std::atomic<int> connections_{0};
  std::thread thread_;
};

}  // namespace rob::test
