#include "lang/syntax/foreign_hints.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "lang/text/ascii.h"
#include "lang/text/codes.h"
#include "lang/values/number_text.h"
#include "lang/values/units.h"

namespace rob::lang {
namespace {

/// Motions of others, and Rob's word for them.
struct ForeignMotion {
  std::string_view word;
  std::string_view ours;
};
constexpr auto kForeignMotions = std::to_array<ForeignMotion>(
    {{"MOVEJ", "MOVE"}, {"PTP", "MOVE"}, {"LIN", "MOVEL"}, {"MOVEL", "MOVEL"}});
constexpr auto kPathWords = std::to_array<ForeignMotion>(
    {{"G0", "MOVE"}, {"G00", "MOVE"}, {"G1", "MOVEL"}, {"G01", "MOVEL"}});

const ForeignMotion* find_motion(std::span<const ForeignMotion> motions, std::string_view word) {
  const auto found = std::ranges::find_if(
      motions, [&](const ForeignMotion& one) { return same_word(one.word, word); });
  return found == motions.end() ? nullptr : &*found;
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r;";
  text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
  while (!text.empty() && kBlanks.find(text.back()) != std::string_view::npos)
    text.remove_suffix(1);
  return text;
}

/// The parts between commas, without blanks around them.
std::vector<std::string_view> parts_of(std::string_view text) {
  std::vector<std::string_view> parts;
  while (!text.empty()) {
    const std::size_t comma = std::min(text.find(','), text.size());
    parts.push_back(trimmed(text.substr(0, comma)));
    text.remove_prefix(std::min(comma + 1, text.size()));
  }
  return parts;
}

bool is_number(std::string_view text) {
  const bool digits = std::ranges::all_of(text, [](char c) { return is_digit(c) || c == '.'; });
  return !text.empty() && digits && is_digit(text.front()) && is_digit(text.back()) &&
         std::ranges::count(text, '.') <= 1;
}

/// `v100`, `z10`: a letter and a number.
std::string_view number_behind(char letter, std::string_view text) {
  if (text.size() < 2 || to_upper(text.front()) != letter) return {};
  return is_number(text.substr(1)) ? text.substr(1) : std::string_view();
}

bool is_name(std::string_view text) {
  return !text.empty() && begins_word(text.front()) && std::ranges::all_of(text, in_word);
}

/// ABB's data after the point, as clauses: v100, z10, fine, tool0.
std::string clauses_of(std::span<const std::string_view> data) {
  std::string clauses;
  for (const std::string_view one : data) {
    const std::string_view speed = number_behind('V', one);
    const std::string_view zone = number_behind('Z', one);
    if (!speed.empty()) clauses += fmt::format(" AT {}mm/s", speed);
    if (!zone.empty()) clauses += fmt::format(" ZONE {}mm", zone);
    if (same_word(one, "fine")) clauses += " FINE";
    const bool tool = speed.empty() && zone.empty() && is_name(one);
    if (tool && !same_word(one, "fine") && !same_word(one, "tool0"))
      clauses += fmt::format(" WITH {}", shortened(one));
  }
  return clauses;
}

bool is_signed_number(std::string_view text) {
  return is_number(text.starts_with('-') ? text.substr(1) : text);
}

/// The arguments of a call, from its '(' on, cut at the commas outside of [] and (); at least one.
std::vector<std::string_view> arguments_of(std::string_view call) {
  std::vector<std::string_view> arguments;
  int open = 0;
  std::size_t begin = 1;
  for (std::size_t i = 0; i < call.size(); ++i) {
    if (call[i] == '(' || call[i] == '[') ++open;
    if (call[i] == ')' || call[i] == ']') --open;
    if (open > 1 || (call[i] != ',' && open == 1)) continue;
    arguments.push_back(trimmed(call.substr(begin, i - begin)));
    begin = i + 1;
    if (open == 0) return arguments;
  }
  arguments.push_back(trimmed(call.substr(begin)));  // no ')' has come
  return arguments;
}

/// Where UR's movej and movel go: joints in rad, or a name.
std::string universal_target(std::string_view target) {
  if (is_name(target)) return std::string(shortened(target));
  if (!target.starts_with('[') || !target.ends_with(']')) return "p";
  std::string joints;
  for (const std::string_view joint : parts_of(target.substr(1, target.size() - 2))) {
    if (!is_signed_number(joint)) return "p";
    joints += fmt::format("{}{}rad", joints.empty() ? "" : ", ", joint);
  }
  return fmt::format("JOINTS({})", joints);
}

/// UR's movej(q, a=1.4, v=1.05, t=0, r=0), in rad and m, and movel with a and v in m.
std::string universal_motion(std::string_view ours, std::string_view call) {
  constexpr std::string_view kOrder = "avtr";
  const std::string_view unit = ours == "MOVE" ? "rad" : "m";
  const std::vector<std::string_view> arguments = arguments_of(call);
  std::array<std::string_view, kOrder.size()> values{};
  for (std::size_t i = 1; i < arguments.size(); ++i) {
    const std::size_t equal = arguments[i].find('=');
    const bool named = equal != std::string_view::npos;
    const std::string_view name = trimmed(arguments[i].substr(0, named ? equal : 0));
    const std::size_t which = !named ? i - 1 : name.size() == 1 ? kOrder.find(name) : kOrder.size();
    const std::string_view value = named ? trimmed(arguments[i].substr(equal + 1)) : arguments[i];
    if (which < values.size() && is_number(value) && value.find_first_not_of("0.") < value.size())
      values[which] = value;
  }
  const auto [a, v, t, r] = values;
  std::string line = fmt::format("{} {}", ours, universal_target(arguments.front()));
  if (!v.empty()) line += fmt::format(" AT {}{}/s", v, unit);
  if (!t.empty()) line += fmt::format(" OVER {}s", t);
  if (!r.empty()) line += fmt::format(" ZONE {}m", r);
  if (!a.empty()) line += fmt::format(" ACCEL {}{}/s^2", a, unit);
  return line;
}

/// `X10 Y-2.5 F600` as a target by names and a speed, mm/min.
std::string path_target(std::string_view words) {
  std::string target;
  std::string speed;
  while (!(words = trimmed(words)).empty()) {
    const std::size_t end = std::min(words.find_first_of(" \t"), words.size());
    const std::string_view word = words.substr(0, end);
    words.remove_prefix(end);
    const std::string_view number = word.substr(1);
    const bool sound = is_number(number.starts_with('-') ? number.substr(1) : number);
    if (!sound) continue;
    const char letter = static_cast<char>(to_upper(word.front()) - 'A' + 'a');
    if (letter >= 'x' && letter <= 'z')
      target += fmt::format("{}{}: {}", target.empty() ? "" : ", ", letter, number);
    if (letter == 'f') speed = fmt::format(" AT {}mm / 1min", number);
  }
  return fmt::format("({}){}", target.empty() ? "x: 10" : target, speed);
}

}  // namespace

bool ForeignHints::skip() {
  if (!tokens_.current().first_on_line) return false;
  const Token& first = tokens_.current();
  const Token& next = tokens_.next();
  if (first.kind == TokenKind::Minus && next.kind == TokenKind::Minus &&
      next.offset == first.offset + 1) {
    return skip_line("'--' begins no comment in Rob",
                     "a comment begins with // and ends with its line");
  }
  if (tokens_.at(Keyword::Movel)) return skip_motion();
  if (tokens_.at(Keyword::For)) return skip_for();
  return tokens_.at(TokenKind::Word) && skip_word();
}

bool ForeignHints::skip_word() {
  const TokenKind next = tokens_.next().kind;
  if (next == TokenKind::Colon) return skip_label();
  const bool called = next == TokenKind::LeftParen && !names_.names_routine(tokens_.text());
  const bool operand = next == TokenKind::Word || next == TokenKind::Number;
  if (tokens_.at_word("REPEAT") && next == TokenKind::EndOfLine) return skip_repeat();
  if (!called && !operand) return false;
  if (find_motion(kForeignMotions, tokens_.text()) != nullptr) return skip_motion();
  if (tokens_.at_word("SLEEP")) {
    std::string_view time = trimmed(rest_of_line().substr(tokens_.text().size()));
    if (time.starts_with('(')) time = trimmed(time.substr(1, time.find(')') - 1));
    return skip_line("sleep is WAIT in Rob",
                     is_number(time) ? fmt::format("WAIT {}s", time) : "WAIT 1s");
  }
  if (!operand) return false;
  if (tokens_.at_word("GOTO"))
    return skip_line("Rob has no GOTO: LOOP … ENDLOOP repeats, EXIT leaves it",
                     "LOOP, and ENDLOOP after the lines that are repeated");
  if (tokens_.at_word("SUB") && next == TokenKind::Word) return skip_sub();
  const ForeignMotion* const path = find_motion(kPathWords, tokens_.text());
  if (path == nullptr || next != TokenKind::Word) return false;
  return skip_line(
      fmt::format("{} is {} in Rob", tokens_.text(), path->ours),
      fmt::format("{}{}", path->ours, path_target(rest_of_line().substr(tokens_.text().size()))));
}

/// MOVEL is a word of Rob, too: then what stands after it decides.
bool ForeignHints::skip_motion() {
  const Token word = tokens_.current();
  if (word.kind == TokenKind::Reserved && !is_call_of_others()) return false;
  const ForeignMotion* const motion = find_motion(kForeignMotions, word.text);
  if (motion == nullptr) return false;  // a MOVEL that is mistyped
  const std::string_view ours = motion->ours;
  std::string_view data = trimmed(rest_of_line().substr(word.text.size()));
  data = data.substr(0, std::min(data.find("//"), data.size()));
  std::string line;
  if (data.starts_with('(')) {
    const bool tuple =
        data.find_first_of("[=") == std::string_view::npos && !is_name(arguments_of(data).front());
    line = tuple ? fmt::format("{}{}", ours, data) : universal_motion(ours, data);
  } else {
    const std::vector<std::string_view> parts = parts_of(data);
    const bool point = !parts.empty() && is_name(parts.front());
    line = fmt::format("{} {}{}", ours, point ? shortened(parts.front()) : "p",
                       parts.size() > 1 ? clauses_of(std::span(parts).subspan(1)) : "");
  }
  return skip_line(fmt::format("{} as other robots write it is {} in Rob", word.text, ours),
                   std::move(line));
}

/// Whether MOVEL has a point and data between commas, or named or bracketed arguments.
bool ForeignHints::is_call_of_others() const {
  if (tokens_.next().kind != TokenKind::Word && tokens_.next().kind != TokenKind::LeftParen)
    return false;
  const bool brackets = tokens_.next().kind == TokenKind::LeftParen;
  Lexer ahead = tokens_.ahead();
  Token before = tokens_.next();
  Token token = ahead.next();
  if (!brackets) return token.kind == TokenKind::Comma;
  int lists = 0;
  for (; token.kind != TokenKind::EndOfLine && token.kind != TokenKind::EndOfFile;
       before = token, token = ahead.next()) {
    if (token.kind == TokenKind::Assign) return true;
    if (token.kind == TokenKind::RightBracket) --lists;
    if (token.kind == TokenKind::Comma && lists > 0) return true;
    if (token.kind == TokenKind::LeftBracket) ++lists;
  }
  return false;
}

/// A FOR of Python, whose line ends with ':', and the lines after it that stand farther right.
bool ForeignHints::skip_for() {
  const Token first = tokens_.current();
  Lexer ahead = tokens_.ahead();
  Token last = tokens_.next();
  Token token = ahead.next();
  const bool in = token.kind == TokenKind::Reserved && token.keyword == Keyword::In;
  if (!in) return false;
  for (; token.kind != TokenKind::EndOfLine && token.kind != TokenKind::EndOfFile;
       token = ahead.next()) {
    last = token;
  }
  const std::string range = range_text();
  if (last.kind != TokenKind::Colon && range.empty()) return false;
  std::size_t end = last.offset;
  for (bool inside = true; token.kind != TokenKind::EndOfFile; token = ahead.next()) {
    const bool ends = token.kind == TokenKind::Reserved && token.keyword == Keyword::Endfor;
    if (token.first_on_line) inside = ends || token.place.column > first.place.column;
    if (!inside) break;
    end = token.offset;
    if (ends) break;
  }
  const std::string variable = std::string(shortened(tokens_.next().text));
  const std::string ours = range.empty() ? fmt::format("FOR {} IN a DO", variable)
                                         : fmt::format("FOR {} = {} DO", variable, range);
  return skip_up_to(end, fmt::format("this loop is written {} … ENDFOR in Rob", ours), ours);
}

/// `0 TO 2` of range(3); empty where no range stands.
std::string ForeignHints::range_text() const {
  std::string_view rest = rest_of_line();
  const std::size_t begin = rest.find("range(");
  if (begin == std::string_view::npos) return "";
  rest.remove_prefix(begin + std::string_view("range(").size());
  const std::size_t end = rest.find(')');
  if (end == std::string_view::npos) return "0 TO n - 1";
  const std::vector<std::string_view> parts = parts_of(rest.substr(0, end));
  if (parts.empty() || parts.size() > 3) return "0 TO n - 1";
  const std::string_view behind = parts.size() == 1 ? parts[0] : parts[1];
  std::int64_t number = 0;
  const auto read = std::from_chars(behind.data(), behind.data() + behind.size(), number);
  const bool whole = read.ec == std::errc{} && read.ptr == behind.data() + behind.size();
  const std::string last =
      whole ? std::to_string(number - 1) : fmt::format("{} - 1", std::string(shortened(behind)));
  return fmt::format(
      "{} TO {}{}", parts.size() == 1 ? "0" : std::string(shortened(parts[0])), last,
      parts.size() == 3 ? fmt::format(" STEP {}", std::string(shortened(parts[2]))) : "");
}

/// `start:` on a line of its own. Where a GOTO names it, that has the message.
bool ForeignHints::skip_label() {
  if (tokens_.ahead().next().kind != TokenKind::EndOfLine) return false;
  if (!labels_) {
    labels_.emplace();
    Lexer lexer = tokens_.from_beginning();
    bool after_goto = false;
    for (Token token = lexer.next(); token.kind != TokenKind::EndOfFile; token = lexer.next()) {
      if (after_goto) labels_->insert(to_upper(token.text));
      after_goto = token.kind == TokenKind::Word && same_word(token.text, "GOTO");
    }
  }
  if (labels_->contains(to_upper(tokens_.text()))) {
    tokens_.skip_line();
    return true;
  }
  return skip_line("Rob has no labels: LOOP … ENDLOOP repeats, a PROC is called by its name",
                   "LOOP, and ENDLOOP after the lines that are repeated");
}

bool ForeignHints::skip_repeat() {
  Lexer ahead = tokens_.ahead();
  int open = 1;
  std::size_t end = tokens_.current().offset;
  for (Token token = ahead.next(); open > 0 && token.kind != TokenKind::EndOfFile;
       token = ahead.next()) {
    if (!token.first_on_line) continue;
    if (token.kind == TokenKind::Word && same_word(token.text, "REPEAT")) ++open;
    const bool until = token.kind == TokenKind::Reserved && token.keyword == Keyword::Until;
    if (until && --open == 0) end = token.offset;
  }
  return skip_up_to(end, "REPEAT … UNTIL is LOOP in Rob: an IF with EXIT ends it",
                    "LOOP, then as its last line IF x > 3 THEN EXIT, then ENDLOOP");
}

/// The routine is known all the same, so that its calls are no mistakes.
bool ForeignHints::skip_sub() {
  Lexer ahead = tokens_.ahead();
  std::size_t end = tokens_.current().offset;
  bool after_end = false;
  for (Token token = ahead.next(); token.kind != TokenKind::EndOfFile; token = ahead.next()) {
    const bool sub = token.kind == TokenKind::Word &&
                     (after_end ? same_word(token.text, "SUB")
                                : token.first_on_line && same_word(token.text, "ENDSUB"));
    if (sub) {
      end = token.offset;
      break;
    }
    after_end =
        token.first_on_line && token.kind == TokenKind::Reserved && token.keyword == Keyword::End;
  }
  const std::string name(tokens_.next().text);
  routines_.add_unread(tokens_.place(), tokens_.next());
  return skip_up_to(end, "a SUB is a PROC in Rob",
                    fmt::format("PROC {}() … ENDPROC, with the types of its parameters between "
                                "the brackets",
                                shortened(name)));
}

std::string_view ForeignHints::rest_of_line() const {
  const std::string_view rest = tokens_.source().substr(tokens_.current().offset);
  return rest.substr(0, std::min(rest.find_first_of("\r\n"), rest.size()));
}

bool ForeignHints::skip_line(std::string message, std::string help) {
  return skip_up_to(tokens_.current().offset, std::move(message), std::move(help));
}

bool ForeignHints::skip_up_to(std::size_t end, std::string message, std::string help) {
  tokens_.report(code::kForeignStatement, tokens_.place(), std::move(message), std::move(help));
  tokens_.skip_over(end);
  return true;
}

}  // namespace rob::lang
