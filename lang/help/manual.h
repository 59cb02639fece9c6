#pragma once

#include <span>
#include <string_view>
#include <vector>

namespace rob::lang {

/// A block of the manual: a paragraph, an item of a list, a program, a table.
struct ManualBlock {
  enum class Kind { Paragraph, Item, Code, Table };
  Kind kind = Kind::Paragraph;
  std::vector<std::string_view> lines;  ///< of a table: its head, then its rows
};

/// A heading and what stands below it, up to the next one.
struct ManualSection {
  std::string_view heading;
  int depth = 0;  ///< 1 for the title, 2 for a chapter, 3 for a part of one
  /// Words that are explained here, although neither the heading nor a row of a table begins with
  /// them: `<!-- help: WORD … -->` below the heading.
  std::vector<std::string_view> words;
  std::vector<ManualBlock> blocks;
};

/// docs/language.md as it was when the library was built, by chapters.
std::span<const std::string_view> embedded_manual();

/// Their sections, in order; they look into the texts.
std::vector<ManualSection> read_manual(std::span<const std::string_view> chapters);

}  // namespace rob::lang
