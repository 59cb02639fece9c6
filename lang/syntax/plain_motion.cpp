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
  bool component(PlainMotion::Component& component);

 private:
  bool digits() {
    const std::size_t begin = at_;
    while (is_digit(now())) ++at_;
    return at_ > begin && at_ - begin <= kMostDigits;
  }

  std::string_view text_;
  std::size_t at_;
};

/// [ "-" ] digits [ "." digits ] [ unit ]
bool LineReader::component(PlainMotion::Component& component) {
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
  if (!begins_word(now())) return true;
  const auto unit = match_unit(text_.substr(at_));
  if (!unit) return false;  // an exponent, too
  component.unit = unit->unit;
  at_ += unit->length;
  return true;
}

}  // namespace

std::optional<PlainMotion> read_plain_motion(std::string_view text, std::size_t word) {
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
  return reader.at_line_end() ? std::optional(motion) : std::nullopt;
}

}  // namespace rob::lang
