#include "runtime/prompt/program_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "lang/text/ascii.h"
#include "runtime/files/text_lines.h"

namespace rob::runtime {

namespace {

/// Edits that can be undone. [choice] more than anybody remembers
constexpr std::size_t kMostEdits = 200;

/// Where a text ends that begins at `quote`, and where a comment does.
std::size_t end_of_aside(std::string_view line, std::size_t begin) {
  if (line[begin] != '"') return line.size();
  for (std::size_t i = begin + 1; i < line.size(); ++i) {
    if (line[i] == '"') return i + 1;
    if (line[i] == '\\') ++i;
  }
  return line.size();
}

/// With another name for a name; a field is none.
std::string renamed(std::string_view line, const ProgramText::Renaming& renaming) {
  std::string text;
  for (std::size_t i = 0; i < line.size();) {
    const bool aside = line[i] == '"' || line.substr(i).starts_with("//");
    std::size_t end = aside ? end_of_aside(line, i) : i + 1;
    while (!aside && lang::in_word(line[i]) && end < line.size() && lang::in_word(line[end])) ++end;
    const std::string_view part = line.substr(i, end - i);
    const bool name = lang::same_word(part, renaming.from) && (i == 0 || line[i - 1] != '.');
    text += name ? std::string_view(renaming.to) : part;
    i = end;
  }
  return text;
}

}  // namespace

std::string ProgramText::text() const {
  std::string text;
  for (const Line& line : lines_) text.append(line.text).push_back('\n');
  return text;
}

bool ProgramText::has_name(std::string_view name) const {
  const Renaming away{std::string(name), ""};
  return std::ranges::any_of(
      lines_, [&](const Line& line) { return renamed(line.text, away) != line.text; });
}

/// The splice that takes it back.
ProgramText::Splice ProgramText::apply(Splice splice) {
  const auto begin = lines_.begin() + static_cast<std::ptrdiff_t>(splice.at);
  const auto end = begin + static_cast<std::ptrdiff_t>(splice.count);
  Splice back{splice.at, splice.lines.size(),
              Lines(std::make_move_iterator(begin), std::make_move_iterator(end)),
              std::move(splice.done)};
  for (const Line& line : back.lines) points_.remove(line.text);
  for (const Line& line : splice.lines) points_.add(line.text);
  const auto place = lines_.erase(begin, end);
  lines_.insert(place, std::make_move_iterator(splice.lines.begin()),
                std::make_move_iterator(splice.lines.end()));
  return back;
}

void ProgramText::edit(Splice splice) {
  if (before_.size() == kMostEdits) before_.erase(before_.begin());
  before_.push_back(apply(std::move(splice)));
  undone_.clear();
}

std::string ProgramText::replace(std::size_t number, std::string text) {
  std::string what = fmt::format("line {} changed: {}", number, text);
  edit({number - 1, 1, {{std::move(text)}}, {what}});
  return what;
}

std::string ProgramText::insert(std::size_t number, std::string text) {
  std::string what = fmt::format("line {} inserted: {}", number, text);
  edit({number - 1, 0, {{std::move(text)}}, {what}});
  return what;
}

std::string ProgramText::erase(std::size_t first, std::size_t last) {
  std::string what = first == last ? fmt::format("line {} deleted: {}", first, line(first))
                                   : fmt::format("lines {} to {} deleted", first, last);
  edit({first - 1, last + 1 - first, {}, {what}});
  return what;
}

void ProgramText::set(std::string_view text, std::string what) {
  Lines lines;
  for (std::string& line : split_lines(text)) lines.push_back({std::move(line)});
  edit({0, lines_.size(), std::move(lines), {std::move(what)}});
}

void ProgramText::rename(const Renaming& renaming) {
  Lines lines = lines_;
  for (Line& line : lines) line.text = renamed(line.text, renaming);
  edit({0,
        lines_.size(),
        std::move(lines),
        {fmt::format("{} renamed to {}", renaming.from, renaming.to), renaming}});
}

void ProgramText::record(std::string_view text, std::uint32_t entry) {
  Lines lines;
  for (std::string& line : split_lines(text)) lines.push_back({std::move(line), entry});
  const std::string what = fmt::format("recorded: {}", text.substr(0, text.find('\n')));
  edit({lines_.size(), 0, std::move(lines), {what}});
}

void ProgramText::take_back(std::uint32_t first, std::uint32_t last) {
  const auto failed = [&](const Line& line) {
    return line.entry != 0 && line.entry >= first && line.entry <= last;
  };
  const auto found = std::ranges::find_if(lines_, failed);
  if (found == lines_.end()) return;
  Lines kept;
  std::ranges::remove_copy_if(found, lines_.end(), std::back_inserter(kept), failed);
  const auto at = static_cast<std::size_t>(found - lines_.begin());
  edit({at, lines_.size() - at, std::move(kept), {"entries that failed taken out"}});
}

std::optional<ProgramText::Done> ProgramText::apply_last(std::vector<Splice>& from,
                                                         std::vector<Splice>& to) {
  if (from.empty()) return std::nullopt;
  to.push_back(apply(std::move(from.back())));
  from.pop_back();
  return to.back().done;
}

std::optional<ProgramText::Done> ProgramText::undo() { return apply_last(before_, undone_); }

std::optional<ProgramText::Done> ProgramText::redo() { return apply_last(undone_, before_); }

}  // namespace rob::runtime
