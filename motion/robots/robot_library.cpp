#include "motion/robots/robot_library.h"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>

#include "base/nearest_words.h"
#include "motion/robots/robot_file.h"
#include "motion/robots/shapes_file.h"

namespace rob::motion {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t kMostRobotFile = std::uintmax_t{1}
                                          << 20U;  // bytes [choice] 100 × the longest

[[noreturn]] void refuse(const std::string& file, const std::string& why) {
  throw RobotFileUnreadable("cannot read '" + file + "': " + why);
}

[[noreturn]] void refuse(const std::string& file, const std::error_code& error) {
  const char* remedy = error == std::errc::no_such_file_or_directory
                           ? "; check the name and the folder"
                       : error == std::errc::permission_denied ? "; check the permissions"
                                                               : "";
  refuse(file, error.message() + remedy);
}

/// A pipe or a device might never end.
void check_regular(const std::string& file) {
  std::error_code error;
  const fs::file_type type = fs::status(file, error).type();
  if (type == fs::file_type::regular) return;
  if (error) refuse(file, error);
  const char* kind = type == fs::file_type::directory ? "a folder"
                     : type == fs::file_type::fifo    ? "a pipe"
                     : type == fs::file_type::socket  ? "a socket"
                                                      : "a device";
  refuse(file, std::string("it is ") + kind + "; name a file");
}

std::string text_of(const std::string& file) {
  check_regular(file);
  const auto close = [](std::FILE* open) { std::fclose(open); };
  const std::unique_ptr<std::FILE, decltype(close)> stream(std::fopen(file.c_str(), "rb"));
  if (!stream) refuse(file, {errno, std::generic_category()});
  std::error_code error;
  const std::uintmax_t size = fs::file_size(file, error);
  if (error) refuse(file, error);
  if (size > kMostRobotFile)
    refuse(file, std::to_string(size >> 20U) + " MiB; at most " +
                     std::to_string(kMostRobotFile >> 20U) + " MiB are read");
  std::string text(static_cast<std::size_t>(size), '\0');
  text.resize(std::fread(text.data(), 1, text.size(), stream.get()));
  if (std::ferror(stream.get()) != 0) refuse(file, {errno, std::generic_category()});
  return text;
}

}  // namespace

std::vector<std::string_view> robot_names() {
  std::vector<std::string_view> names;
  for (const EmbeddedRobot& robot : embedded_robots()) names.push_back(robot.name);
  std::sort(names.begin(), names.end());
  return names;
}

RobotModel embedded_robot(std::string_view name) {
  for (const EmbeddedRobot& robot : embedded_robots())
    if (robot.name == name) return parse_robot_file(robot.text, std::string(name).append(".toml"));

  const std::vector<std::string_view> names = robot_names();
  const std::string_view close = suggest(name, names);
  std::string message = "there is no robot '";
  message.append(name).append("'; ");
  if (!close.empty()) {
    message.append("did you mean '").append(close).append("'?");
  } else {
    message.append("known are");
    for (const std::string_view known : names) message.append(" ").append(known);
    message.append("; a file of your own is named with its ending, .toml");
  }
  throw RobotFileError(message);
}

RobotModel load_robot(std::string_view name_or_file) {
  if (!name_or_file.ends_with(".toml")) return embedded_robot(name_or_file);
  return parse_robot_file(text_of(std::string(name_or_file)), name_or_file);
}

void load_cell(const std::string& file, RobotModel& robot) {
  read_cell(text_of(file), file, robot.collision);
}

}  // namespace rob::motion
