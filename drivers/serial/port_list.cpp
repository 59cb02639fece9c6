#include "drivers/serial/port_list.h"

#include <grp.h>
#include <pwd.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <system_error>

namespace rob::drivers {

namespace fs = std::filesystem;

namespace {

/// The name of each process is in its /proc/PID/comm.
std::string name_of(int process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/comm");
  std::string name;
  std::getline(file, name);
  return name;
}

bool is_port_name(const std::string& name) {
  return name.starts_with("ttyUSB") || name.starts_with("ttyACM");
}

PortEntry& entry_of(std::vector<PortEntry>& ports, const std::string& path) {
  const auto known = std::ranges::find(ports, path, &PortEntry::path);
  return known != ports.end() ? *known : ports.emplace_back(PortEntry{path, "", ""});
}

/// Whether the group of the port exists for such devices, and may use it.
bool is_for_devices(const std::string& path) {
  constexpr std::array<std::string_view, 3> kGroups{"dialout", "uucp", "plugdev"};
  struct stat file {};
  if (::stat(path.c_str(), &file) != 0) return false;
  const bool permitted = (file.st_mode & S_IRGRP) != 0 && (file.st_mode & S_IWGRP) != 0;
  return permitted && std::ranges::find(kGroups, group_of(path)) != kGroups.end();
}

/// "root:tty, mode 0620".
std::string ownership_of(const std::string& path) {
  struct stat file {};
  if (::stat(path.c_str(), &file) != 0) return "nobody";
  const passwd* const owner = ::getpwuid(file.st_uid);
  std::array<char, 8> mode{};
  std::snprintf(mode.data(), mode.size(), "%04o", static_cast<unsigned>(file.st_mode & 07777));
  return (owner != nullptr ? std::string(owner->pw_name) : std::to_string(file.st_uid)) + ":" +
         group_of(path) + ", mode " + mode.data();
}

std::string state_of(const std::string& path) {
  if (const std::string owner = lock_owner(path); !owner.empty()) return "used by " + owner;
  if (::access(path.c_str(), R_OK | W_OK) == 0) return "free";
  if (is_for_devices(path)) return "not permitted: needs the group " + group_of(path);
  return "not permitted: belongs to " + ownership_of(path);
}

}  // namespace

std::string lock_owner(const std::string& path) {
  struct stat file {};
  if (::stat(path.c_str(), &file) != 0) return "";
  std::ifstream locks("/proc/locks");
  for (std::string line; std::getline(locks, line);) {
    int process = 0;
    unsigned major_number = 0;
    unsigned minor_number = 0;
    unsigned long inode = 0;
    // "1: FLOCK  ADVISORY  WRITE 1234 00:05:678 0 EOF" (proc_locks(5))
    if (std::sscanf(line.c_str(), "%*d: FLOCK %*s %*s %d %x:%x:%lu", &process, &major_number,
                    &minor_number, &inode) != 4)
      continue;
    const bool same = inode == file.st_ino && major_number == major(file.st_dev) &&
                      minor_number == minor(file.st_dev);
    if (!same) continue;
    const std::string name = name_of(process);
    return "process " + std::to_string(process) + (name.empty() ? "" : " (" + name + ")");
  }
  return "";
}

std::string group_of(const std::string& path) {
  struct stat file {};
  if (::stat(path.c_str(), &file) != 0) return "";
  const group* const found = ::getgrgid(file.st_gid);
  return found != nullptr ? found->gr_name : std::to_string(file.st_gid);
}

std::string permission_advice(const std::string& path) {
  if (is_for_devices(path))
    return "it needs the group " + group_of(path) + ": sudo usermod -aG " + group_of(path) +
           " $USER, then log in again";
  return "it belongs to " + ownership_of(path) +
         ": ask the administrator of this computer for a udev rule that gives you access to it";
}

std::vector<PortEntry> list_ports(const std::string& dev) {
  std::vector<PortEntry> ports;
  std::error_code error;  // a folder that is not there has no ports
  for (const fs::directory_entry& link : fs::directory_iterator(dev + "/serial/by-id", error)) {
    const fs::path target = fs::canonical(link.path(), error);
    if (!error) entry_of(ports, target.string()).by_id = link.path().string();
  }
  for (const fs::directory_entry& device : fs::directory_iterator(dev, error)) {
    if (!is_port_name(device.path().filename().string())) continue;
    const fs::path target = fs::canonical(device.path(), error);
    if (!error) entry_of(ports, target.string());
  }
  for (PortEntry& port : ports) port.state = state_of(port.path);
  std::ranges::sort(ports, {}, &PortEntry::path);
  return ports;
}

}  // namespace rob::drivers
