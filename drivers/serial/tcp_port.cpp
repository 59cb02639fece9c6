#include "drivers/serial/tcp_port.h"

#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstring>
#include <memory>
#include <string_view>

#include "motion/servo/servo_backend.h"

namespace rob::drivers {

using motion::DriverError;

namespace {

constexpr std::string_view kScheme = "tcp://";
constexpr int kConnectTime = 3000;  // ms [choice] for the other side to accept

struct Address {
  std::string host;
  std::string port;
};

[[noreturn]] void fail_to_read(const std::string& text) {
  throw DriverError("'" + text +
                    "' is no network address; write tcp://host:port, such as"
                    " tcp://192.168.1.20:23");
}

Address address_of(const std::string& text) {
  std::string rest = text.substr(kScheme.size());
  const std::size_t colon = rest.rfind(':');
  if (colon == std::string::npos || colon == 0) fail_to_read(text);
  Address address{rest.substr(0, colon), rest.substr(colon + 1)};
  if (address.host.starts_with('[') && address.host.ends_with(']'))
    address.host = address.host.substr(1, address.host.size() - 2);
  unsigned number = 0;
  const char* const last = address.port.data() + address.port.size();
  const auto [end, error] = std::from_chars(address.port.data(), last, number);
  if (address.host.empty() || error != std::errc() || end != last || number == 0 || number > 65535)
    fail_to_read(text);
  return address;
}

/// 0, or why there is no connection.
int connect_within(int file, const addrinfo& where) noexcept {
  if (::connect(file, where.ai_addr, where.ai_addrlen) == 0) return 0;
  if (errno != EINPROGRESS) return errno;
  pollfd waits{file, POLLOUT, 0};
  if (::poll(&waits, 1, kConnectTime) <= 0) return ETIMEDOUT;
  int error = 0;
  socklen_t size = sizeof error;
  ::getsockopt(file, SOL_SOCKET, SO_ERROR, &error, &size);
  return error;
}

}  // namespace

bool is_network_address(const std::string& path) { return path.starts_with(kScheme); }

TcpPort::TcpPort(const std::string& text) : WirePort(text) {
  const Address address = address_of(text);
  addrinfo hints{};
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  if (::getaddrinfo(address.host.c_str(), address.port.c_str(), &hints, &found) != 0)
    throw DriverError("there is no host '" + address.host + "' for " + text +
                      "; check its name, and the network of this computer");
  const std::unique_ptr<addrinfo, void (*)(addrinfo*)> all(found, ::freeaddrinfo);
  int error = EHOSTUNREACH;
  for (const addrinfo* where = found; where != nullptr; where = where->ai_next) {
    const int file = ::socket(where->ai_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    if (file < 0) continue;
    error = connect_within(file, *where);
    if (error == 0) {
      const int on = 1;
      ::setsockopt(file, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
      take(file);
      return;
    }
    ::close(file);
  }
  throw DriverError("no connection to " + text + ": " + std::strerror(error) +
                    "; check that the machine is switched on and that nothing else is connected"
                    " to it");
}

std::ptrdiff_t TcpPort::put(std::span<const std::uint8_t> bytes) noexcept {
  return ::send(file(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
}

}  // namespace rob::drivers
