#pragma once

namespace rob::runtime {

/// Gives the terminal back as it was found, whatever ends the process: return, exit(), a crash
/// (kill -9 aside). While it lives Ctrl-Z is only noted: nobody would look after the robot. One
/// object at a time.
class TerminalGuard {
 public:
  TerminalGuard();
  ~TerminalGuard();
  /// The text that the terminal is sent then, before its modes are given back; null: nothing. It
  /// stays.
  static void send_at_end(const char* text);
  /// Ctrl-Z has been pressed; once.
  static bool take_suspension();
  /// The process stops as by Ctrl-Z elsewhere, with the terminal as it was found, until it is
  /// continued.
  static void suspend();
  TerminalGuard(const TerminalGuard&) = delete;
  TerminalGuard& operator=(const TerminalGuard&) = delete;
};

}  // namespace rob::runtime
