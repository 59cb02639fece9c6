#include "drivers/protocol/grbl_line.h"

#include <algorithm>
#include <charconv>
#include <utility>

namespace rob::drivers::grbl {

namespace {

constexpr std::pair<std::string_view, Machine> kMachines[] = {
    {"Idle", Machine::Idle},   {"Run", Machine::Run},     {"Hold", Machine::Hold},
    {"Jog", Machine::Jog},     {"Alarm", Machine::Alarm}, {"Door", Machine::Door},
    {"Check", Machine::Check}, {"Home", Machine::Home},   {"Sleep", Machine::Sleep},
    {"Tool", Machine::Tool}};

template <typename T>
bool number(std::string_view text, T& value) noexcept {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}

/// Takes what stands before `mark` from the front, and the mark.
std::string_view take(std::string_view& text, char mark) noexcept {
  const std::size_t end = std::min(text.find(mark), text.size());
  const std::string_view part = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return part;
}

/// "1.000,0.000,0.000": how many; 0 if one is no number.
int numbers(std::string_view text, std::array<double, kMostAxes>& values) noexcept {
  int count = 0;
  while (!text.empty()) {
    if (count == kMostAxes) return 0;
    if (!number(take(text, ','), values[static_cast<std::size_t>(count++)])) return 0;
  }
  return count;
}

bool parse_field(std::string_view field, Status& status) noexcept {
  const std::string_view name = take(field, ':');
  if (name == "MPos" || name == "WPos") {
    status.axes = numbers(field, status.position);
    status.of_work = name == "WPos";
    return status.axes > 0;
  }
  if (name == "WCO") return status.has_offset = numbers(field, status.offset) > 0;
  if (name == "Ov") return number(take(field, ','), status.feed_override);
  if (name != "Bf") return true;
  status.has_buffer = true;
  return number(take(field, ','), status.free_blocks) && number(field, status.free_bytes);
}

/// Between < and >.
bool parse_status(std::string_view text, Status& status) noexcept {
  std::string_view state = take(text, '|');
  const std::string_view name_of_state = take(state, ':');
  if (!state.empty() && !number(state, status.phase)) return false;
  for (const auto& [name, machine] : kMachines)
    if (name == name_of_state) status.machine = machine;
  if (status.machine == Machine::Unknown) return false;
  while (!text.empty())
    if (!parse_field(take(text, '|'), status)) return false;
  return status.axes > 0;
}

/// "Grbl 1.1h ['$' for help]": 101; 0 if there is no version.
int version_of(std::string_view text) noexcept {
  std::string_view rest = text.substr(text.find(' ') + 1);
  int high = 0;
  int low = 0;
  const auto [dot, error] = std::from_chars(rest.data(), rest.data() + rest.size(), high);
  if (error != std::errc() || dot == rest.data() + rest.size() || *dot != '.') return 0;
  std::from_chars(dot + 1, rest.data() + rest.size(), low);
  return 100 * high + low;
}

bool parse_setting(std::string_view text, Line& line) noexcept {
  std::string_view rest = text.substr(1);
  if (!number(take(rest, '='), line.number)) return false;
  return number(take(rest, ' '), line.value);  // some firmwares write "(x max rate)" after it
}

void parse_numbered(std::string_view text, Line::Kind kind, Line& line) noexcept {
  line.kind = kind;
  number(text.substr(text.find(':') + 1), line.number);
}

/// "[G54:1.000,0.000,0.000]", "[TLO:0.000]"; false for other messages.
bool parse_parameter(std::string_view text, Line& line) noexcept {
  if (!text.ends_with(']')) return false;
  std::string_view rest = text.substr(1, text.size() - 2);
  line.name = take(rest, ':');
  line.values = numbers(rest, line.parameter);
  return line.values > 0;
}

bool is_banner(std::string_view text) noexcept {
  return text.starts_with("Grbl ") || text.starts_with("GrblHAL ");
}

}  // namespace

bool parse(std::string_view text, Line& line) noexcept {
  line = {};
  line.text = text;
  if (text == "ok") {
    line.kind = Line::Kind::Ok;
  } else if (text.starts_with("error:")) {
    parse_numbered(text, Line::Kind::Error, line);
  } else if (text.starts_with("ALARM:")) {
    parse_numbered(text, Line::Kind::Alarm, line);
  } else if (text.starts_with('<')) {
    line.kind = Line::Kind::Status;
    return text.ends_with('>') && parse_status(text.substr(1, text.size() - 2), line.status);
  } else if (is_banner(text)) {
    line.kind = Line::Kind::Banner;
    line.version = version_of(text);
  } else if (text.starts_with('$') && text.find('=') != std::string_view::npos) {
    line.kind = Line::Kind::Setting;
    return parse_setting(text, line);
  } else if (text.starts_with('[')) {
    line.kind = parse_parameter(text, line) ? Line::Kind::Parameter : Line::Kind::Message;
  }
  return true;
}

bool LineReader::next(Bytes& bytes, std::string_view& line) noexcept {
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const std::uint8_t byte = bytes[i];
    if (byte == '\r') continue;
    if (byte != '\n') {
      const bool fits = size_ < text_.size() && byte >= 0x20 && byte < 0x7F;
      if (fits) text_[size_++] = static_cast<char>(byte);
      spoilt_ = spoilt_ || !fits;
      continue;
    }
    const std::size_t length = std::exchange(size_, 0);
    if (std::exchange(spoilt_, false)) {
      ++broken_;
      continue;
    }
    if (length == 0) continue;
    line = {text_.data(), length};
    bytes = bytes.subspan(i + 1);
    return true;
  }
  bytes = {};
  return false;
}

void LineReader::clear() noexcept {
  size_ = 0;
  spoilt_ = false;
}

const char* error_text(int number) noexcept {
  switch (number) {
    case 1:
    case 2:
    case 3:
      return "it does not understand the line";
    case 5:
      return "homing is switched off in its settings";
    case 8:
      return "it takes that only while it stands idle";
    case 9:
      return "it is locked, in alarm or while it jogs";
    case 10:
      return "soft limits need homing";
    case 11:
    case 14:
      return "the line is too long";
    case 13:
      return "its safety door is open";
    case 15:
      return "the jog leads beyond its travel";
    case 16:
      return "the jog has no feed or is no jog";
    case 20:
      return "it does not know this command";
    case 22:
      return "the feed is missing";
    case 33:
      return "the target is not valid";
    default:
      return "";
  }
}

const char* alarm_text(int number) noexcept {
  switch (number) {
    case 1:
      return "a limit switch was hit";
    case 2:
      return "the target is beyond its travel";
    case 3:
      return "it was reset while it moved";
    case 4:
    case 5:
      return "probing failed";
    case 6:
      return "homing failed: it was reset";
    case 7:
      return "homing failed: the safety door was opened";
    case 8:
      return "homing failed: a switch did not come free";
    case 9:
    case 10:
      return "homing failed: no switch was found";
    default:
      return "";
  }
}

bool loses_position(int alarm) noexcept { return alarm != 2 && alarm != 4 && alarm != 5; }

}  // namespace rob::drivers::grbl
