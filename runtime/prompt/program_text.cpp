#include "runtime/prompt/program_text.h"

#include <algorithm>
#include <utility>

#include "runtime/files/text_lines.h"

namespace rob::runtime {

namespace {

/// Edits that can be undone. [choice] more than anybody remembers
constexpr std::size_t kMostEdits = 200;

}  // namespace

std::string ProgramText::text() const {
  std::string text;
  for (const Line& line : lines_) text.append(line.text).push_back('\n');
  return text;
}

void ProgramText::begin_edit() {
  if (before_.size() == kMostEdits) before_.erase(before_.begin());
  before_.push_back(lines_);
  undone_.clear();
}

void ProgramText::replace(std::size_t number, std::string text) {
  begin_edit();
  lines_.at(number - 1) = {std::move(text)};
}

void ProgramText::insert(std::size_t number, std::string text) {
  begin_edit();
  lines_.insert(lines_.begin() + static_cast<std::ptrdiff_t>(number - 1), {std::move(text)});
}

void ProgramText::erase(std::size_t first, std::size_t last) {
  begin_edit();
  lines_.erase(lines_.begin() + static_cast<std::ptrdiff_t>(first - 1),
               lines_.begin() + static_cast<std::ptrdiff_t>(last));
}

void ProgramText::set(std::string_view text) {
  begin_edit();
  lines_.clear();
  for (std::string& line : split_lines(text)) lines_.push_back({std::move(line)});
}

void ProgramText::record(std::string_view text, std::uint32_t entry) {
  begin_edit();
  for (std::string& line : split_lines(text)) lines_.push_back({std::move(line), entry});
}

void ProgramText::take_back(std::uint32_t first, std::uint32_t last) {
  const auto failed = [&](const Line& line) {
    return line.entry != 0 && line.entry >= first && line.entry <= last;
  };
  if (std::ranges::none_of(lines_, failed)) return;
  begin_edit();
  std::erase_if(lines_, failed);
}

bool ProgramText::undo() {
  if (before_.empty()) return false;
  undone_.push_back(std::exchange(lines_, std::move(before_.back())));
  before_.pop_back();
  return true;
}

bool ProgramText::redo() {
  if (undone_.empty()) return false;
  before_.push_back(std::exchange(lines_, std::move(undone_.back())));
  undone_.pop_back();
  return true;
}

}  // namespace rob::runtime
