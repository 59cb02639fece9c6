#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace rob::runtime {

/// A key of the terminal.
struct Key {
  enum class Kind : unsigned char {
    Character,  ///< `character`
    Up,
    Down,
    Right,
    Left,
    PageUp,
    PageDown,
    Enter,
    Backspace,
    Escape
  };
  enum class Event : unsigned char { Press, Repeat, Release };

  Kind kind = Kind::Character;
  char32_t character = 0;
  Event event = Event::Press;

  bool is(char32_t c) const { return kind == Kind::Character && character == c; }
  bool same(const Key& other) const { return kind == other.kind && character == other.character; }
};

/// Makes keys of the bytes that a terminal sends: plain ones, the sequences of xterm, and the
/// reports of the kitty keyboard protocol (https://sw.kovidgoyal.net/kitty/keyboard-protocol),
/// which report releases, too. It passes over sequences that it does not know.
class KeyReader {
 public:
  void feed(std::string_view bytes) { bytes_ += bytes; }
  /// The next whole key; none while there is none.
  std::optional<Key> next();
  /// Nothing has followed for a while: an ESC that stands alone is the key Esc.
  std::optional<Key> lone_escape();
  /// The terminal has answered that it speaks the kitty protocol; and that it has answered at all.
  bool tells_releases() const { return tells_releases_; }
  bool answered() const { return answered_; }

 private:
  std::optional<Key> sequence(std::string_view body);

  std::string bytes_;
  bool tells_releases_ = false;
  bool answered_ = false;
};

/// The question whether the terminal speaks the protocol: flags, then its attributes, which every
/// terminal answers.
inline constexpr std::string_view kAskKeyboard = "\x1b[?u\x1b[c";
/// Escape codes unambiguous, events reported, all keys as escape codes (1 + 2 + 8); and back.
inline constexpr std::string_view kTellReleases = "\x1b[>11u";
inline constexpr std::string_view kTellNoReleases = "\x1b[<u";

}  // namespace rob::runtime
