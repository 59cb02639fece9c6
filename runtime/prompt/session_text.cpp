#include "runtime/prompt/session_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "lang/text/ascii.h"

namespace rob::runtime {

namespace {

/// What messages call the text.
constexpr const char* kName = "prompt";

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  for (;;) {
    const std::size_t end = text.find('\n');
    lines.emplace_back(text.substr(0, end));
    if (end == std::string_view::npos) return lines;
    text.remove_prefix(end + 1);
  }
}

}  // namespace

std::size_t find_word(std::string_view line, std::string_view word, std::size_t begin) {
  for (std::size_t i = begin; i < line.size();) {
    if (!lang::in_word(line[i])) {
      ++i;
      continue;
    }
    std::size_t end = i;
    while (end < line.size() && lang::in_word(line[end])) ++end;
    if (lang::same_word(line.substr(i, end - i), word)) return i;
    i = end;
  }
  return std::string_view::npos;
}

LoadedProgram SessionText::compile(std::string_view entry) const {
  std::string source;
  for (const std::string& line : lines_) source.append(line).push_back('\n');
  source.append(entry).push_back('\n');
  return compile_program(kName, std::move(source), robot_, points_file_, robot_.law, line());
}

void SessionText::keep(std::string_view entry, const LoadedProgram& compiled) {
  const bool stays = compiled.runnable() && compiled.compilation.lasts;
  for (std::string& line : lines_of(entry))
    lines_.push_back(stays ? std::move(line) : std::string());
  if (stays) names_ = compiled.compilation.names;
}

void SessionText::forget(std::uint32_t first, std::uint32_t last) {
  for (std::size_t line = first; line <= last && line <= lines_.size(); ++line)
    lines_[line - 1].clear();
  std::erase_if(names_, [&](const lang::DeclaredName& one) {
    return one.place.line >= first && one.place.line <= last;
  });
}

/// Its line goes on declaring something under another name: what is declared behind keeps its place
/// in the memory of the variables.
bool SessionText::forget_name(const std::string& name) {
  const auto declares = [&](const std::string& line) {
    return find_word(line, "POINT") == line.find_first_not_of(" \t") && has_word(line, name);
  };
  const bool used = std::ranges::any_of(
      lines_, [&](const std::string& one) { return has_word(one, name) && !declares(one); });
  if (used) return false;
  for (std::string& line : lines_) {
    if (declares(line))
      line.replace(find_word(line, name), name.size(), fmt::format("forgotten_{}", ++forgotten_));
  }
  std::erase_if(names_, [&](const auto& one) { return lang::same_word(one.name, name); });
  return true;
}

}  // namespace rob::runtime
