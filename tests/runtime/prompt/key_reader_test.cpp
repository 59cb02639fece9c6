#include "runtime/prompt/key_reader.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using rob::runtime::Key;
using rob::runtime::KeyReader;
using Kind = Key::Kind;
using Event = Key::Event;

namespace {

std::vector<Key> keys_of(KeyReader& reader, std::string_view bytes) {
  reader.feed(bytes);
  std::vector<Key> keys;
  while (const auto key = reader.next()) keys.push_back(*key);
  return keys;
}

}  // namespace

TEST_CASE("plain characters and the sequences of xterm are keys") {
  KeyReader reader;
  const auto keys = keys_of(reader, "a\x1b[A\x1b[6~\x1bOD\r\x7f\xc3\xa4");
  REQUIRE(keys.size() == 7);
  CHECK(keys[0].is('a'));
  CHECK(keys[1].kind == Kind::Up);
  CHECK(keys[2].kind == Kind::PageDown);
  CHECK(keys[3].kind == Kind::Left);
  CHECK(keys[4].kind == Kind::Enter);
  CHECK(keys[5].kind == Kind::Backspace);
  CHECK(keys[6].is(U'\u00e4'));
  for (const Key& key : keys) CHECK(key.event == Event::Press);
}

TEST_CASE("the kitty protocol tells presses, repeats and releases") {
  KeyReader reader;
  const auto keys =
      keys_of(reader, "\x1b[97;1:1u\x1b[97;1:2u\x1b[97;1:3u\x1b[1;1:3A\x1b[5;1:2~\x1b[27u");
  REQUIRE(keys.size() == 6);
  CHECK((keys[0].is('a') && keys[0].event == Event::Press));
  CHECK(keys[1].event == Event::Repeat);
  CHECK(keys[2].event == Event::Release);
  CHECK((keys[3].kind == Kind::Up && keys[3].event == Event::Release));
  CHECK((keys[4].kind == Kind::PageUp && keys[4].event == Event::Repeat));
  CHECK(keys[5].kind == Kind::Escape);
}

TEST_CASE("a sequence that comes in parts is one key") {
  KeyReader reader;
  CHECK(keys_of(reader, "\x1b").empty());
  CHECK(keys_of(reader, "[1;1").empty());
  const auto keys = keys_of(reader, ":3B");
  REQUIRE(keys.size() == 1);
  CHECK((keys[0].kind == Kind::Down && keys[0].event == Event::Release));
}

TEST_CASE("an ESC alone is the key Esc once nothing follows") {
  KeyReader reader;
  CHECK(keys_of(reader, "\x1b").empty());
  const auto key = reader.lone_escape();
  REQUIRE(key);
  CHECK(key->kind == Kind::Escape);
  CHECK(!reader.lone_escape());
}

TEST_CASE("the terminal's answer tells whether it speaks the protocol") {
  KeyReader plain;
  CHECK(keys_of(plain, "\x1b[?62;22c").empty());
  CHECK(plain.answered());
  CHECK(!plain.tells_releases());
  KeyReader kitty;
  CHECK(keys_of(kitty, "\x1b[?0u\x1b[?62c").empty());
  CHECK(kitty.answered());
  CHECK(kitty.tells_releases());
}

TEST_CASE("what is no key is passed over") {
  KeyReader reader;
  const auto keys = keys_of(reader, "\x1b[200~x\x1b[?2026;1$y\x1b[99999999999999999999uz");
  REQUIRE(!keys.empty());
  CHECK(keys.back().is('z'));
}
