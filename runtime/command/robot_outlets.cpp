#include "runtime/command/robot_outlets.h"

#include <utility>

namespace rob::runtime {

using lang::Reply;

Reply RobotOutlets::write(int line, std::string_view file, std::string_view text) {
  return files_->write(line, file, text);
}

Reply RobotOutlets::persist(int line, std::size_t variable, std::string_view value) {
  return files_->persist(line, variable, value);
}

Reply RobotOutlets::exists(int /*line*/, std::string_view file, bool& value) {
  return files_->exists(file, value);
}

Reply RobotOutlets::send(int line, std::size_t device, std::string_view text) {
  return devices_->send(line, device, text);
}

Reply RobotOutlets::receive(int line, std::size_t device, double timeout, std::string& text,
                            bool& came) {
  return devices_->receive(line, device, timeout, text, came);
}

Reply RobotOutlets::simulate_line(int line, std::size_t device, std::string_view text,
                                  double after) {
  return devices_->simulate(line, device, text, after);
}

Reply RobotOutlets::read_file(int line, std::string_view file, std::string& text) {
  return files_->read(line, file, text);
}

void RobotOutlets::warn(int line, lang::Refusal warning) {
  files_->log().found({lang::Severity::Warning, std::move(warning.code), lang::tagged_place(line),
                       std::move(warning.message), std::move(warning.help)});
}

Reply RobotOutlets::start(const lang::Place& place, std::uint32_t task) {
  return reports_->start(place, task);
}

Reply RobotOutlets::publish(int line, std::size_t first, std::span<const lang::Slot> values) {
  return reports_->publish(line, first, values);
}

Reply RobotOutlets::publish(int line, std::size_t first, std::span<const std::string> texts) {
  return reports_->publish(line, first, texts);
}

Reply RobotOutlets::publish_list(int line, std::size_t home, const lang::ListContent& list) {
  return reports_->publish_list(line, home, list);
}

Reply RobotOutlets::refresh(int /*line*/, std::size_t first, std::span<lang::Slot> values) {
  return reports_->refresh(first, values);
}

Reply RobotOutlets::refresh(int /*line*/, std::size_t first, std::span<std::string> texts) {
  return reports_->refresh(first, texts);
}

}  // namespace rob::runtime
