#pragma once

#include <optional>
#include <string>

#include "runtime/tick/operator_panel.h"

namespace rob::runtime {

/// The person at the terminal that is standard input. Where it is none, nobody is there; nor after
/// its end of file. While the process is in the background nobody answers.
class Terminal final : public Person {
 public:
  /// `waits`: line() waits for the line, or a signal of the system: on the virtual clock no time
  /// passes while a person thinks.
  explicit Terminal(bool waits) : waits_(waits) {}

  bool present() override;
  void listen() override;
  std::optional<std::string> line() override;

 private:
  bool waits_;
  bool over_ = false;
  std::string typed_;  ///< of a line whose end has not come
};

}  // namespace rob::runtime
