#pragma once

#include <array>
#include <fstream>
#include <string>

#include "tests/support/rob_command.h"

namespace rob::test {

/// The gantry with wide following limits, for a computer that is late, and counts of a servo.
/// `wires`: of x, y and theta; `whole`: of the file.
inline std::string gantry_file(const RobCommand& rob, const std::array<std::string, 3>& wires,
                               const std::string& whole = "") {
  std::string text = read_whole_file(ROB_SOURCE_DIR "/motion/robots/gantry.toml");
  const auto replace_all = [&](const std::string& what, const std::string& with) {
    for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += with.size())
      text.replace(at, what.size(), with);
  };
  replace_all("following_warn = \"0.25", "following_warn = \"5");
  replace_all("following_limit = \"1 ", "following_limit = \"10 ");
  replace_all("encoder_resolution = \"1 um", "encoder_resolution = \"50 um");
  replace_all("encoder_resolution = \"0.001 deg", "encoder_resolution = \"0.1 deg");
  std::size_t at = 0;
  for (const std::string& wire : wires) {
    at = text.find("[axis.drive]", at);
    const std::string table = "[axis.wire]\n" + wire + "\n\n";
    text.insert(at, table);
    at += table.size() + 1;
  }
  std::ofstream(rob.file("wired.toml")) << text << (whole.empty() ? "" : "\n[wire]\n" + whole);
  return rob.file("wired.toml");
}

/// 4096/200 = 20.48 ticks/mm on x, backwards; 10.24 ticks/mm on y; a gear of 3 to 1 on theta.
inline const std::array<std::string, 3> kServoWires{
    "id = 3\ntravel = \"200 mm\"\noffset = \"60 mm\"\ndirection = -1",
    "id = 1\ntravel = \"400 mm\"\noffset = \"0 mm\"", "id = 2\ntravel = \"120 deg\""};
/// The same places of SCS servos, of 1024 places.
inline const std::array<std::string, 3> kScsWires{
    "id = 3\ntravel = \"100 mm\"\noffset = \"60 mm\"\ndirection = -1",
    "id = 1\ntravel = \"200 mm\"\noffset = \"50 mm\"", "id = 2\ntravel = \"300 deg\""};

}  // namespace rob::test
