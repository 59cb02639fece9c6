#pragma once

namespace rob::runtime {

/// Gives the terminal back as it was found, whatever ends the process: return, exit(), a crash
/// (kill -9 aside). While it lives the process cannot be suspended: nobody would look after the
/// robot. One object at a time.
class TerminalGuard {
 public:
  TerminalGuard();
  ~TerminalGuard();
  /// What the terminal is sent then, before its modes are given back; null: nothing. It stays.
  static void send_at_end(const char* text);
  TerminalGuard(const TerminalGuard&) = delete;
  TerminalGuard& operator=(const TerminalGuard&) = delete;
};

}  // namespace rob::runtime
