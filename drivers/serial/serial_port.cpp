#include "drivers/serial/serial_port.h"

#include <fcntl.h>
#include <linux/serial.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <utility>

#include "drivers/serial/port_list.h"
#include "motion/servo/servo_backend.h"

namespace rob::drivers {

using motion::DriverError;

namespace {

constexpr std::array<std::pair<int, speed_t>, 14> kSpeeds{{{9600, B9600},
                                                           {19200, B19200},
                                                           {38400, B38400},
                                                           {57600, B57600},
                                                           {115200, B115200},
                                                           {230400, B230400},
                                                           {460800, B460800},
                                                           {500000, B500000},
                                                           {576000, B576000},
                                                           {921600, B921600},
                                                           {1000000, B1000000},
                                                           {2000000, B2000000},
                                                           {3000000, B3000000},
                                                           {4000000, B4000000}}};

std::string ports_text() {
  std::string text;
  for (const PortEntry& port : list_ports()) text += (text.empty() ? "" : ", ") + port.path;
  return text.empty() ? "no serial port is there: is the machine plugged in and switched on?"
                      : "the ports that are there: " + text;
}

std::string owner_text(const std::string& path) {
  const std::string owner = lock_owner(path);
  return owner.empty() ? "another program" : owner;
}

[[noreturn]] void fail_used(const std::string& path) {
  throw DriverError("the port '" + path + "' is used by " + owner_text(path) +
                    "; end that first, a machine obeys one program at a time");
}

[[noreturn]] void fail_to_open(const std::string& path, int error) {
  switch (error) {
    case ENOENT:
    case ENODEV:
    case ENXIO:
      throw DriverError("there is no port '" + path + "'; " + ports_text());
    case EACCES:
    case EPERM:
      throw DriverError("you may not use the port '" + path + "'; " + permission_advice(path));
    case EBUSY:
      fail_used(path);
    default:
      throw DriverError("the port '" + path + "' cannot be opened: " + std::strerror(error));
  }
}

speed_t speed_of(const std::string& path, int baud) {
  const auto found = std::ranges::find(kSpeeds, baud, &std::pair<int, speed_t>::first);
  if (found == kSpeeds.end())
    throw DriverError("the port '" + path + "' cannot do " + std::to_string(baud) +
                      " baud; usual are 57600, 115200 and 1000000");
  return found->second;
}

/// An FTDI adapter keeps bytes back for 16 ms unless it is set otherwise.
void ask_for_low_latency(int file) {
  serial_struct settings{};
  if (::ioctl(file, TIOCGSERIAL, &settings) != 0) return;
  settings.flags |= static_cast<int>(ASYNC_LOW_LATENCY);
  ::ioctl(file, TIOCSSERIAL, &settings);
}

int latency_timer_of(const std::string& path) {
  std::error_code error;
  const std::string name = std::filesystem::canonical(path, error).filename().string();
  std::ifstream file("/sys/class/tty/" + name + "/device/latency_timer");
  int milliseconds = 0;
  return file >> milliseconds ? milliseconds : 0;
}

}  // namespace

SerialPort::SerialPort(const std::string& path, int baud) : WirePort(path) {
  const int opened = ::open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (opened < 0) fail_to_open(path, errno);
  take(opened);
  configure(baud);
}

void SerialPort::configure(int baud) {
  if (::isatty(file()) == 0)
    throw DriverError("'" + path() + "' is no serial port; " + ports_text());
  if (::flock(file(), LOCK_EX | LOCK_NB) != 0) fail_used(path());
  ::ioctl(file(), TIOCEXCL);
  const speed_t speed = speed_of(path(), baud);
  termios mode{};
  if (::tcgetattr(file(), &mode) != 0) fail_to_open(path(), errno);
  ::cfmakeraw(&mode);
  mode.c_cflag |= CLOCAL | CREAD;
  // Without HUPCL a board is not reset when the port is closed.
  mode.c_cflag &= ~static_cast<tcflag_t>(CSTOPB | CRTSCTS | HUPCL);
  mode.c_cc[VMIN] = 1;  // a read of 0 bytes means that the device has gone
  mode.c_cc[VTIME] = 0;
  ::cfsetispeed(&mode, speed);
  ::cfsetospeed(&mode, speed);
  if (::tcsetattr(file(), TCSANOW, &mode) != 0) fail_to_open(path(), errno);
  ask_for_low_latency(file());
  latency_timer_ = latency_timer_of(path());
}

SerialPort::~SerialPort() { ::ioctl(file(), TIOCNXCL); }

}  // namespace rob::drivers
