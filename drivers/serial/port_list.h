#pragma once

#include <string>
#include <vector>

namespace rob::drivers {

/// A serial port that is there.
struct PortEntry {
  std::string path;   ///< "/dev/ttyUSB0"
  std::string by_id;  ///< its name by maker and serial number, which stays; empty: none
  std::string state;  ///< "free", or who uses it, or why this user may not
};

/// USB adapters and boards below `dev`: those of serial/by-id, ttyUSB* and ttyACM*, each once, by
/// path.
std::vector<PortEntry> list_ports(const std::string& dev = "/dev");

/// "process 1234 (rob)" that holds flock() on the file; empty where nobody does. Found in
/// /proc/locks.
std::string lock_owner(const std::string& path);

/// The group to which the port belongs: "dialout"; empty if the file is not there.
std::string group_of(const std::string& path);

/// How a user gets access to a port that he may not use: by joining its group, if that group exists
/// for such devices (dialout, uucp, plugdev) and may use the port. Membership in any other group
/// (root, tty, disk) would give away more than a port: then it names owner, group and mode instead.
std::string permission_advice(const std::string& path);

}  // namespace rob::drivers
