#include "lang/syntax/plain_motion.h"

#include <algorithm>

#include "lang/text/ascii.h"
#include "lang/values/units.h"

namespace rob::lang {
namespace {

/// More digits may not fit an INT; the lexer reports it.
constexpr std::size_t kMostDigits = 18;

/// Goes over one line.
class LineReader {
 public:
  explicit LineReader(std::string_view text, std::size_t at) : text_(text), at_(at) {}

  std::size_t at() const { return at_; }
  char now() const { return at_ < text_.size() ? text_[at_] : '\n'; }
  void skip_blanks() {
    while (now() == ' ' || now() == '\t') ++at_;
  }
  bool accept(char sign) {
    skip_blanks();
    if (now() != sign) return false;
    ++at_;
    return true;
  }
  bool at_line_end() {
    skip_blanks();
    return now() == '\n' || text_.substr(at_).starts_with("//") ||
           text_.substr(at_).starts_with("\r\n");
  }
  bool component(PlainMotion::Component& component, bool percent = false);
  bool clause(PlainMotion& motion);

 private:
  bool accept_word(std::string_view word);
  bool digits() {
    const std::size_t begin = at_;
    while (is_digit(now())) ++at_;
    return at_ > begin && at_ - begin <= kMostDigits;
  }

  std::string_view text_;
  std::size_t at_;
};

/// [ "-" ] digits [ "." digits ] [ unit ]
bool LineReader::component(PlainMotion::Component& component, bool percent) {
  skip_blanks();
  if (now() == ',' || now() == ')') return true;
  component.negative = accept('-');
  skip_blanks();
  const std::size_t begin = at_;
  if (!digits()) return false;
  if (now() == '.') {
    ++at_;
    if (!digits()) return false;
  }
  component.number = text_.substr(begin, at_ - begin);
  if (!begins_word(now()) && !(percent && now() == '%')) return true;
  const auto unit = match_unit(text_.substr(at_));
  if (!unit) return false;  // an exponent, too
  component.unit = unit->unit;
  at_ += unit->length;
  return true;
}

bool LineReader::accept_word(std::string_view word) {
  skip_blanks();
  if (!same_word(text_.substr(at_, word.size()), word)) return false;
  at_ += word.size();
  return now() == ' ' || now() == '\t';
}

bool is_share(const Unit& unit, double value) { return unit.dimension == kNone && value <= 1; }

bool take_pace(const Unit& unit, double value, PlainMotion& motion) {
  using Pace = MoveCommand::Pace;
  motion.pace = unit.dimension == kSpeed          ? Pace::ToolSpeed
                : unit.dimension == kAngularSpeed ? Pace::AngularSpeed
                : is_share(unit, value)           ? Pace::Share
                                                  : Pace::Unspecified;
  motion.pace_value = value;
  return motion.pace != Pace::Unspecified;
}

bool take_zone(const Unit& unit, double value, PlainMotion& motion) {
  using Zone = MoveCommand::Zone;
  motion.zone = unit.dimension == kLength ? Zone::Length
                : unit.dimension == kTime ? Zone::Time
                : unit.dimension == kNone ? Zone::Share
                                          : Zone::Unspecified;
  motion.zone_value = value;
  return motion.zone != Zone::Unspecified;
}

/// ( "AT" | "ZONE" ) digits [ "." digits ] unit. A value that is not above zero, or above 100 %, is
/// none: it has a meaning, or a message, of its own.
bool LineReader::clause(PlainMotion& motion) {
  const bool pace = motion.pace == MoveCommand::Pace::Unspecified && accept_word("AT");
  const bool zone = !pace && motion.zone == MoveCommand::Zone::Unspecified && accept_word("ZONE");
  if (!pace && !zone) return false;
  skip_blanks();
  if (zone) motion.zone_offset = at_;
  PlainMotion::Component number;
  if (!component(number, true) || number.number.empty() || number.negative || !number.unit)
    return false;
  const auto quantity = quantity_of(number.number, *number.unit);
  if (!quantity || *quantity <= 0) return false;
  const double value = to_si(*quantity, number.unit->dimension);
  return pace ? take_pace(*number.unit, value, motion) : take_zone(*number.unit, value, motion);
}

}  // namespace

std::optional<PlainMotion> read_plain_target(std::string_view text, std::size_t word) {
  LineReader reader(text, word);
  PlainMotion motion;
  if (!reader.accept('(')) return std::nullopt;
  do {
    if (motion.count == kMaxCoordinates) return std::nullopt;
    auto& component = motion.components[static_cast<std::size_t>(motion.count++)];
    if (!reader.component(component)) return std::nullopt;
  } while (reader.accept(','));
  const bool nothing = motion.count == 1 && motion.components.front().number.empty();
  if (nothing || !reader.accept(')')) return std::nullopt;
  motion.length = reader.at();
  return motion;
}

std::optional<PlainMotion> read_plain_motion(std::string_view text, std::size_t word) {
  auto motion = read_plain_target(text, word);
  if (!motion) return std::nullopt;
  LineReader reader(text, motion->length);
  while (!reader.at_line_end()) {
    if (!reader.clause(*motion)) return std::nullopt;
    motion->length = reader.at();
  }
  return motion;
}

}  // namespace rob::lang
