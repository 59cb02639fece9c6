#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lang/help/manual.h"

/// Texts as a terminal of 80 characters shows them.
namespace rob::lang {

/// Breaks the text between words; each line begins with so many blanks.
std::string wrapped(std::string_view text, std::size_t indent = 2);

/// Lines of a program, farther in than other text, and not wrapped.
std::string indented(std::string_view program);

/// Without the marks of Markdown: `code`, **bold**, [a link](to.md).
std::string unmarked(std::string_view markdown);

/// The cells of a line of a table, without their blanks.
std::vector<std::string_view> cells_of(std::string_view row);

std::string shown(const ManualBlock& block);

}  // namespace rob::lang
