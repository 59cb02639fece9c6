#pragma once

#include <sys/types.h>
#include <termios.h>

#include <chrono>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace rob::test {

/// A program with a terminal of 24 lines of 80 characters: what a person types, and what they see.
class PseudoTerminal {
 public:
  struct Options {
    std::string folder;                              ///< to run in; empty: the present one
    std::map<std::string, std::string> environment;  ///< beside that of the test
  };
  static constexpr std::chrono::seconds kPatience{20};  ///< [choice] for a machine that is busy

  /// `arguments[0]` with the others. Throws std::system_error.
  PseudoTerminal(const std::vector<std::string>& arguments, const Options& options);
  /// Kills what has not been waited for.
  ~PseudoTerminal();
  PseudoTerminal(const PseudoTerminal&) = delete;
  PseudoTerminal& operator=(const PseudoTerminal&) = delete;

  void send(std::string_view keys);
  /// Waits for a text behind the one that was expected last; false when it does not come.
  bool expect(std::string_view text, std::chrono::milliseconds patience = kPatience);
  /// Takes what comes in that time.
  void watch(std::chrono::milliseconds time);
  /// All that has come, byte by byte.
  const std::string& raw() const { return raw_; }
  /// As a person sees it: the lines so far, those that have scrolled away too, without the blanks
  /// at their ends.
  std::vector<std::string> screen() const;
  /// The line with the cursor, up to the last character.
  std::string last_line() const;

  /// Whether the terminal's modes are those that the program has found.
  bool modes_as_found() const;
  void resize(unsigned short lines, unsigned short columns);
  void signal(int number) const;
  /// The terminal goes away, as when a window is closed.
  void hang_up();
  /// The program's end: its exit code, or 128 + the signal that ended it; −1 if it does not end.
  int wait(std::chrono::milliseconds patience = kPatience);

 private:
  bool take(std::chrono::milliseconds patience);

  termios modes() const;

  termios found_{};
  int master_ = -1;
  int slave_ = -1;  ///< kept open, so that the modes can be read when the program has gone
  pid_t child_ = 0;
  bool over_ = false;
  std::string raw_;
  std::size_t seen_ = 0;  ///< behind what was expected last
};

/// What a screen of 80 columns shows after these bytes: the control sequences of a VT100 that move
/// the cursor in its line or up and down, and erase. Its last line is the one with the cursor, or
/// below it.
std::vector<std::string> shown_screen(std::string_view bytes, std::size_t* cursor_line = nullptr);

}  // namespace rob::test
