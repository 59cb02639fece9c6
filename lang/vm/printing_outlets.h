#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <map>
#include <string>
#include <string_view>

#include <fmt/core.h>

#include "lang/machine/machine.h"
#include "lang/vm/call_log.h"

namespace rob::lang {

/// The files and devices of a PrintingMachine, and the calls that it writes down.
class PrintingOutlets : public Machine {
 public:
  Reply send(int line, std::size_t device, std::string_view text) override {
    return log_.note(line, fmt::format("send {} {}", device + 1, text));
  }
  /// The lines that were simulated, one after the other; then its time is over.
  Reply receive(int line, std::size_t device, double timeout, std::string& text,
                bool& came) override;
  Reply simulate_line(int line, std::size_t device, std::string_view text, double after) override;
  /// The lines that have been written.
  Reply read_file(int line, std::string_view file, std::string& text) override;
  void warn(int line, Refusal warning) override;
  Reply write(int line, std::string_view file, std::string_view text) override;
  Reply persist(int line, std::size_t variable, std::string_view value) override {
    return log_.note(line, fmt::format("persist {} {}", variable + 1, value));
  }
  /// Whether it has been written.
  Reply exists(int line, std::string_view file, bool& value) override;

 protected:
  CallLog log_;

 private:
  std::map<std::string, std::string, std::less<>> files_;  ///< what was written
  std::map<std::size_t, std::deque<std::string>> lines_;   ///< simulated, of each device
};

}  // namespace rob::lang
