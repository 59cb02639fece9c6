#include "lang/vm/answer.h"

#include <optional>

#include <fmt/format.h>

#include "lang/syntax/written_value.h"
#include "lang/text/source_text.h"

namespace rob::lang {
namespace {

bool is_text(std::string_view line) {
  Diagnostics unread;
  return check_source(line, unread);
}

bool read_answer(std::string_view line, const Type& type, Slot& value) {
  const std::optional<Slot> read = read_scalar(line, type);
  if (read) value = *read;
  return read.has_value();
}

bool read_answer(std::string_view line, std::string& value) {
  if (!is_text(line)) return false;
  value = line;
  return true;
}

/// "'7' is not a length, such as 5mm": for one who has to try again.
std::string misread_answer(std::string_view line, const Type& type) {
  if (!is_text(line)) return "that is no text";
  if (type.is(Type::Kind::Enum)) {
    return fmt::format("'{}' is none of {}", shortened(line), fmt::join(type.detail->names, ", "));
  }
  return fmt::format("'{}' is not {}, such as {}", shortened(line), in_words(type),
                     example_of(type));
}

}  // namespace

Reply Question::ask(Machine& machine, int line, std::string text, const Type& type, Slot* numbers,
                    std::string* texts, std::size_t index) {
  if (!misread_.empty()) text = fmt::format("{}; {}", misread_, text);
  std::optional<std::string> answer;
  const Reply reply = machine.ask(line, text, answer);
  if (reply == Reply::Later) return reply;
  forget();
  if (reply == Reply::Refused || !answer) return reply;
  const bool read = type.is(Type::Kind::String) ? read_answer(*answer, texts[index])
                                                : read_answer(*answer, type, numbers[index]);
  if (read) return Reply::Done;
  misread_ = misread_answer(*answer, type);
  return Reply::Later;
}

}  // namespace rob::lang
