#include "runtime/prompt/session_text.h"

#include <algorithm>

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

void SessionText::forget_from(std::uint32_t line) {
  std::for_each(lines_.begin() + std::min<std::ptrdiff_t>(line - 1, std::ssize(lines_)),
                lines_.end(), [](std::string& one) { one.clear(); });
  std::erase_if(names_, [&](const lang::DeclaredName& one) { return one.place.line >= line; });
}

}  // namespace rob::runtime
