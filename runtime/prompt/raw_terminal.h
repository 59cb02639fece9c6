#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace rob::runtime {

/// The terminal on standard input and output for a whole screen: no echo, no lines, its other
/// screen. The destructor gives it back as it was; at a crash a TerminalGuard does, which has to
/// live meanwhile. One object at a time.
class RawTerminal {
 public:
  /// Throws FileError where there is no terminal.
  RawTerminal();
  ~RawTerminal();
  RawTerminal(const RawTerminal&) = delete;
  RawTerminal& operator=(const RawTerminal&) = delete;

  /// The text that has been typed, waiting at most so long; none: the terminal is gone.
  std::optional<std::string> read(int milliseconds);
  void write(std::string_view text);
  /// Over what is shown: lines from the top left.
  void show(std::string_view lines);
  int columns() const;
  int rows() const;

 private:
  bool gone_ = false;
};

}  // namespace rob::runtime
