#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "drivers/protocol/byte_buffer.h"

/// The lines of grbl 1.1 and grblHAL (the grbl wiki: Interface, Commands). Firmwares differ in
/// their numbers: what counts is "error" and "ALARM", the number only explains.
namespace rob::drivers::grbl {

inline constexpr int kMostAxes = 6;            ///< X Y Z A B C
inline constexpr std::size_t kMostLine = 128;  ///< of what it sends; its settings are shorter

// Real-time bytes: they are not queued and not counted.
inline constexpr std::uint8_t kStatusQuery = '?';
inline constexpr std::uint8_t kFeedHold = '!';
inline constexpr std::uint8_t kResume = '~';
inline constexpr std::uint8_t kReset = 0x18;
inline constexpr std::uint8_t kJogCancel = 0x85;
inline constexpr std::uint8_t kFeedAt100 = 0x90;

enum class Machine : std::uint8_t {
  Unknown,
  Idle,
  Run,
  Hold,
  Jog,
  Alarm,
  Door,
  Check,
  Home,
  Sleep,
  Tool  ///< grblHAL: it waits for another tool
};

/// "<Run|MPos:1.000,0.000,0.000|FS:600,0|Bf:12,100|Ov:100,100,100|WCO:…>". mm.
struct Status {
  Machine machine = Machine::Unknown;
  int phase = 0;  ///< the number after the state: Hold:1 still brakes, Hold:0 stands
  int axes = 0;
  std::array<double, kMostAxes> position{};
  bool of_work = false;  ///< WPos, not MPos
  bool has_offset = false;
  std::array<double, kMostAxes> offset{};  ///< WCO: work position = machine position − offset
  bool has_buffer = false;
  int free_blocks = 0;
  int free_bytes = 0;
  int feed_override = 0;  ///< %; 0: this report does not have it
};

struct Line {
  enum class Kind : std::uint8_t {
    Other,
    Ok,
    Error,
    Alarm,
    Status,
    Banner,
    Setting,
    Parameter,  ///< of $#: "[G54:1.000,0.000,0.000]"
    Message
  };
  Kind kind = Kind::Other;
  int number = 0;         ///< of error, alarm, setting; 0 where it is no number
  double value = 0;       ///< of a setting
  int version = 0;        ///< of a banner: 101 for 1.1
  std::string_view text;  ///< the whole line
  Status status;
  std::string_view name;                      ///< of a parameter: "G54"
  std::array<double, kMostAxes> parameter{};  ///< its values
  int values = 0;                             ///< how many
};

/// A line without its end. False for a status or setting that is mutilated: it is not to be used.
bool parse(std::string_view text, Line& line) noexcept;

/// Cuts what comes into lines. A line that is too long, or has bytes which no line has, is dropped
/// and counted.
class LineReader {
 public:
  /// True: `line` holds until the next call, and there may be another one for the bytes so far:
  /// call with the rest. `bytes` loses what was used up.
  bool next(Bytes& bytes, std::string_view& line) noexcept;
  void clear() noexcept;
  std::uint32_t broken() const noexcept { return broken_; }

 private:
  std::array<char, kMostLine> text_{};
  std::size_t size_ = 0;
  bool spoilt_ = false;
  std::uint32_t broken_ = 0;
};

/// In words; "" where the number is not of grbl 1.1.
const char* error_text(int number) noexcept;
const char* alarm_text(int number) noexcept;
/// After these nobody knows any more where the axes stand: 1 hard limit, 3 reset in motion, and all
/// that befalls homing.
bool loses_position(int alarm) noexcept;

}  // namespace rob::drivers::grbl
