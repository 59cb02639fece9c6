#include "runtime/prompt/key_reader.h"

#include <algorithm>
#include <charconv>
#include <utility>

namespace rob::runtime {

namespace {

constexpr char kEsc = '\x1b';

/// Numbers of a sequence: "97;1:3" has 97, 1 and, after the colon, 3.
struct Numbers {
  int first = 1;
  int event = 1;
};

Numbers numbers_of(std::string_view body) {
  Numbers numbers;
  std::from_chars(body.data(), body.data() + body.size(), numbers.first);
  const std::size_t second = body.find(';');
  const std::size_t colon = second == std::string_view::npos ? second : body.find(':', second);
  if (colon == std::string_view::npos) return numbers;
  std::from_chars(body.data() + colon + 1, body.data() + body.size(), numbers.event);
  numbers.event = std::clamp(numbers.event, 1, 3);
  return numbers;
}

Key key_of_code(int code) {
  switch (code) {
    case 13:
      return {Key::Kind::Enter};
    case 27:
      return {Key::Kind::Escape};
    case 127:
      return {Key::Kind::Backspace};
    default:
      return {Key::Kind::Character, static_cast<char32_t>(code)};
  }
}

std::optional<Key> key_of_letter(char final) {
  switch (final) {
    case 'A':
      return Key{Key::Kind::Up};
    case 'B':
      return Key{Key::Kind::Down};
    case 'C':
      return Key{Key::Kind::Right};
    case 'D':
      return Key{Key::Kind::Left};
    default:
      return std::nullopt;
  }
}

/// The length of a character in UTF-8, by its first byte.
std::size_t length_of(unsigned char first) {
  if (first < 0xC0) return 1;
  if (first < 0xE0) return 2;
  return first < 0xF0 ? 3 : 4;
}

char32_t decoded(std::string_view bytes) {
  const auto first = static_cast<unsigned char>(bytes[0]);
  if (bytes.size() == 1) return first;
  auto character = static_cast<char32_t>(first & (0x7FU >> bytes.size()));
  for (const char byte : bytes.substr(1)) character = character << 6U | (byte & 0x3F);
  return character;
}

}  // namespace

std::optional<Key> KeyReader::next() {
  while (!bytes_.empty()) {
    if (bytes_[0] != kEsc) {
      const std::size_t length = length_of(static_cast<unsigned char>(bytes_[0]));
      if (bytes_.size() < length) return std::nullopt;
      const char32_t character = decoded(std::string_view(bytes_).substr(0, length));
      bytes_.erase(0, length);
      return key_of_code(character == '\n' ? 13
                         : character == 8  ? 127
                                           : static_cast<int>(character));
    }
    if (bytes_.size() < 2) return std::nullopt;
    if (bytes_[1] != '[' && bytes_[1] != 'O') {  // an Esc that something follows
      bytes_.erase(0, 1);
      return Key{Key::Kind::Escape};
    }
    std::size_t end = 2;
    while (end < bytes_.size() && (bytes_[end] < '@' || bytes_[end] > '~')) ++end;
    if (end == bytes_.size()) return std::nullopt;
    const std::string body = bytes_.substr(2, end - 1);
    bytes_.erase(0, end + 1);
    if (const auto key = sequence(body)) return key;
  }
  return std::nullopt;
}

/// With its last letter.
std::optional<Key> KeyReader::sequence(std::string_view body) {
  const char final = body.back();
  if (body.starts_with('?')) {
    tells_releases_ = tells_releases_ || final == 'u';
    answered_ = answered_ || final == 'c';
    return std::nullopt;
  }
  const Numbers numbers = numbers_of(body);
  std::optional<Key> key;
  if (final == 'u') key = key_of_code(numbers.first);
  if (final == '~' && numbers.first == 5) key = Key{Key::Kind::PageUp};
  if (final == '~' && numbers.first == 6) key = Key{Key::Kind::PageDown};
  if (!key) key = key_of_letter(final);
  if (key) key->event = static_cast<Key::Event>(numbers.event - 1);
  return key;
}

std::optional<Key> KeyReader::lone_escape() {
  if (bytes_.size() != 1 || bytes_[0] != kEsc) return std::nullopt;
  bytes_.clear();
  return Key{Key::Kind::Escape};
}

}  // namespace rob::runtime
