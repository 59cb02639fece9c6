#include "lang/text/diagnostic.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "lang/text/utf8.h"
#include "lang/text/visible.h"

namespace rob::lang {

namespace {

/// How much of a source line is shown: three lines of a usual terminal.
constexpr std::size_t kMostShown = 200;

bool before(const Diagnostic& a, const Diagnostic& b) { return comes_before(a.place, b.place); }

std::string_view word_of(Severity severity) {
  switch (severity) {
    case Severity::Error:
      return "error";
    case Severity::Warning:
      return "warning";
    case Severity::Note:
      return "note";
  }
  return "";
}

/// A line of the source, counted from 1, without its line end and without a byte order mark.
std::string_view source_line(std::string_view source, std::uint32_t number) {
  if (source.starts_with(kByteOrderMark)) source.remove_prefix(kByteOrderMark.size());
  for (std::uint32_t line = 1; line < number; ++line) {
    const std::size_t end = source.find('\n');
    if (end == std::string_view::npos) return {};
    source.remove_prefix(end + 1);
  }
  source = source.substr(0, source.find('\n'));
  if (source.ends_with('\r')) source.remove_suffix(1);
  return source;
}

/// The byte at which a character begins, or the line's length where the line is shorter.
std::size_t byte_of_column(std::string_view line, std::uint32_t column) {
  std::uint32_t at = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (!is_utf8_continuation(line[i]) && ++at == column) return i;
  }
  return line.size();
}

/// At most kMostShown bytes of the line around `byte`, in whole characters.
std::pair<std::size_t, std::size_t> window(std::string_view line, std::size_t byte) {
  if (line.size() <= kMostShown) return {0, line.size()};
  const std::size_t last_begin = line.size() - kMostShown;
  std::size_t begin = std::min(byte - std::min(byte, kMostShown / 2), last_begin);
  std::size_t end = begin + kMostShown;
  while (begin < end && is_utf8_continuation(line[begin])) ++begin;
  while (end > begin && end < line.size() && is_utf8_continuation(line[end])) --end;
  return {begin, end};
}

/// A tab is as wide as a blank there.
std::string shown_part(std::string_view line) {
  std::string part(line);
  std::ranges::replace(part, '\t', ' ');
  return visible(part);
}

/// The source line and the line with the caret under the place.
std::string excerpt(const Place& place, std::string_view line) {
  if (line.empty()) return "";
  if (place.column == 0) {
    const auto [begin, end] = window(line, 0);
    return fmt::format("  {}\n", shown_part(line.substr(begin, end - begin)));
  }
  const std::size_t byte = byte_of_column(line, place.column);
  const auto [begin, end] = window(line, byte);
  const std::size_t last = std::min(byte_of_column(line, place.column + place.length), end);
  const auto width = [&](std::size_t from, std::size_t to) {
    return count_code_points(shown_part(line.substr(from, to - from)));
  };
  const std::uint32_t carets = std::max(width(byte, std::max(byte, last)), 1U);
  return fmt::format("  {}\n  {}{}\n", shown_part(line.substr(begin, end - begin)),
                     std::string(width(begin, byte), ' '), std::string(carets, '^'));
}

}  // namespace

bool comes_before(const Place& a, const Place& b) {
  return std::tuple(a.file, a.line, a.column) < std::tuple(b.file, b.line, b.column);
}

std::string Diagnostics::line_of(const Place& place, const Place& from) const {
  std::string text = fmt::format("line {}", place.line);
  if (place.file == from.file) return text;
  const bool named = place.file > 0 && place.file <= file_names_.size();
  return fmt::format("{} of {}", text, named ? file_names_[place.file - 1] : "the program");
}

bool Diagnostics::has_error_between(const Place& first, const Place& last) const {
  if (errors_ >= kMost) return true;
  return std::ranges::any_of(all_, [&](const Diagnostic& one) {
    return one.severity == Severity::Error && one.place.file == first.file &&
           one.place.line >= first.line && one.place.line <= last.line;
  });
}

void Diagnostics::add(Diagnostic diagnostic) {
  // A message may quote the source, whatever stands there.
  diagnostic.message = visible(diagnostic.message);
  diagnostic.help = visible(diagnostic.help);
  const bool is_error = diagnostic.severity == Severity::Error;
  if (is_error) ++errors_;
  if (all_.size() >= kMost) {
    ++left_out_;
    // An error must be seen; a warning gives way to it.
    const auto last_other = std::find_if(all_.rbegin(), all_.rend(), [](const Diagnostic& d) {
      return d.severity != Severity::Error;
    });
    if (!is_error || last_other == all_.rend()) return;
    all_.erase(std::next(last_other).base());
  }
  all_.insert(std::ranges::upper_bound(all_, diagnostic, before), std::move(diagnostic));
}

void Diagnostics::error(std::string_view code, Place place, std::string message, std::string help) {
  add({Severity::Error, std::string(code), place, std::move(message), std::move(help)});
}

void Diagnostics::warning(std::string_view code, Place place, std::string message,
                          std::string help) {
  add({Severity::Warning, std::string(code), place, std::move(message), std::move(help)});
}

std::string render_line(const Diagnostic& diagnostic, std::string_view file_name,
                        std::string_view line) {
  const Place& place = diagnostic.place;
  std::string text = on_one_line(file_name);
  if (place.line > 0) text += fmt::format(":{}", place.line);
  if (place.line > 0 && place.column > 0) text += fmt::format(":{}", place.column);
  text += fmt::format(": {}[{}]: {}\n", word_of(diagnostic.severity), diagnostic.code,
                      visible(diagnostic.message));
  if (place.line > 0) text += excerpt(place, line);
  if (!diagnostic.help.empty()) text += fmt::format("help: {}\n", visible(diagnostic.help));
  return text;
}

std::string render(const Diagnostic& diagnostic, std::string_view file_name,
                   std::string_view source) {
  const std::uint32_t line = diagnostic.place.line;
  return render_line(diagnostic, file_name, line == 0 ? source : source_line(source, line));
}

std::string render(const Diagnostic& diagnostic, std::string_view file_name,
                   std::string_view source, std::span<const SourceFile> used) {
  const std::uint32_t file = diagnostic.place.file;
  if (file == 0 || file > used.size()) return render(diagnostic, file_name, source);
  return render(diagnostic, used[file - 1].name, used[file - 1].text);
}

}  // namespace rob::lang
