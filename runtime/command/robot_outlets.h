#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "lang/machine/machine.h"
#include "runtime/command/device_desk.h"
#include "runtime/command/file_desk.h"
#include "runtime/command/task_reports.h"

namespace rob::runtime {

/// The commands of a RobotMachine that do not concern the robot: files, devices that exchange
/// texts, and TASKs.
class RobotOutlets : public lang::Machine {
 public:
  lang::Reply write(int line, std::string_view file, std::string_view text) override;
  lang::Reply persist(int line, std::size_t variable, std::string_view value) override;
  lang::Reply exists(int line, std::string_view file, bool& value) override;
  lang::Reply send(int line, std::size_t device, std::string_view text) override;
  lang::Reply receive(int line, std::size_t device, double timeout, std::string& text,
                      bool& came) override;
  lang::Reply simulate_line(int line, std::size_t device, std::string_view text,
                            double after) override;
  lang::Reply read_file(int line, std::string_view file, std::string& text) override;
  void warn(int line, lang::Refusal warning) override;
  lang::Reply start(const lang::Place& place, std::uint32_t task) override;
  lang::Reply publish(int line, std::size_t first, std::span<const lang::Slot> values) override;
  lang::Reply publish(int line, std::size_t first, std::span<const std::string> texts) override;
  lang::Reply publish_list(int line, std::size_t home, const lang::ListContent& list) override;
  lang::Reply refresh(int line, std::size_t first, std::span<lang::Slot> values) override;
  lang::Reply refresh(int line, std::size_t first, std::span<std::string> texts) override;

 protected:
  /// Before the first command; they must outlive it.
  void lead_to(FileDesk& files, DeviceDesk& devices, TaskReports& reports) {
    files_ = &files;
    devices_ = &devices;
    reports_ = &reports;
  }

 private:
  FileDesk* files_ = nullptr;
  DeviceDesk* devices_ = nullptr;
  TaskReports* reports_ = nullptr;
};

}  // namespace rob::runtime
