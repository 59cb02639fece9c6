#pragma once

#include <fcntl.h>
#include <poll.h>
#include <stdlib.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <system_error>
#include <vector>

namespace rob::test {

/// A wire that is not there: what is written at this end can be read at the port path() as from a
/// device, and the other way round.
class PtyWire {
 public:
  PtyWire() : master_(::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC | O_NONBLOCK)) {
    if (master_ < 0 || ::grantpt(master_) != 0 || ::unlockpt(master_) != 0) fail();
    path_ = ::ptsname(master_);
    // Kept open, so that the wire does not hang up when the other side closes the port.
    slave_ = ::open(path_.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
    if (slave_ < 0) fail();
    termios mode{};
    ::tcgetattr(slave_, &mode);
    ::cfmakeraw(&mode);
    ::tcsetattr(slave_, TCSANOW, &mode);
  }
  ~PtyWire() { unplug(); }
  PtyWire(const PtyWire&) = delete;
  PtyWire& operator=(const PtyWire&) = delete;

  const std::string& path() const { return path_; }

  /// The device is pulled out.
  void unplug() {
    if (slave_ >= 0) ::close(slave_);
    if (master_ >= 0) ::close(master_);
    slave_ = master_ = -1;
  }

  void send(const std::vector<std::uint8_t>& bytes) const {
    std::size_t done = 0;
    while (master_ >= 0 && done < bytes.size()) {
      const ssize_t count = ::write(master_, bytes.data() + done, bytes.size() - done);
      if (count > 0) done += static_cast<std::size_t>(count);
      if (count < 0 && errno != EAGAIN) return;
    }
  }

  /// What comes within that time, as soon as it comes; empty if nothing does.
  std::vector<std::uint8_t> receive(int milliseconds) const {
    std::vector<std::uint8_t> bytes(4096);
    pollfd waits{master_, POLLIN, 0};
    ::poll(&waits, 1, milliseconds);
    const ssize_t count = master_ < 0 ? -1 : ::read(master_, bytes.data(), bytes.size());
    bytes.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
    return bytes;
  }

 private:
  [[noreturn]] static void fail() {
    throw std::system_error(errno, std::generic_category(), "pseudo-terminal");
  }

  int master_;
  int slave_ = -1;
  std::string path_;
};

}  // namespace rob::test
