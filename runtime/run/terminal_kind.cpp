#include "runtime/run/terminal_kind.h"

#include <langinfo.h>
#include <unistd.h>

#include <clocale>
#include <cstdlib>
#include <string_view>

// It defines short names as macros, and so comes last.
#include <term.h>

namespace rob::runtime {

namespace {

std::string_view value_of(const char* variable) {
  const char* const value = std::getenv(variable);
  return value == nullptr ? "" : value;
}

/// readline has an entry of its own in use, which stays.
bool has_colours(const char* term) {
  TERMINAL* const before = set_curterm(nullptr);
  int found = 0;
  const bool known = setupterm(term, STDERR_FILENO, &found) == 0;  // OK of curses.h
  const int colours = known ? tigetnum("colors") : 0;
  TERMINAL* const own = set_curterm(before);
  if (known) del_curterm(own);
  return colours >= 8;
}

bool term_draws() { return !value_of("TERM").empty() && value_of("TERM") != "dumb"; }

bool wants_colours() {
  return term_draws() && value_of("NO_COLOR").empty() && has_colours(std::getenv("TERM"));
}

bool find_out_utf8() {
  const locale_t locale = newlocale(LC_CTYPE_MASK, "", nullptr);
  if (locale == nullptr) return false;
  const bool utf8 = std::string_view(nl_langinfo_l(CODESET, locale)) == "UTF-8";
  freelocale(locale);
  return utf8;
}

}  // namespace

bool draws(int descriptor) { return isatty(descriptor) != 0 && term_draws(); }

bool shows_colours(int descriptor) {
  static const bool wanted = wants_colours();
  return wanted && isatty(descriptor) != 0;
}

bool locale_is_utf8() {
  static const bool utf8 = find_out_utf8();
  return utf8;
}

}  // namespace rob::runtime
