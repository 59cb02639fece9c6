#include "lang/help/manual.h"

#include <algorithm>
#include <cstddef>

namespace rob::lang {
namespace {

using Kind = ManualBlock::Kind;
constexpr std::string_view kFence = "```";
constexpr std::string_view kIndex = "<!-- help: ";

bool is_blank(std::string_view line) { return line.find_first_not_of(' ') == line.npos; }

bool begins_item(std::string_view line) {
  const std::size_t digits = line.find_first_not_of("0123456789");
  if (digits != 0 && digits != line.npos) return line.substr(digits).starts_with(". ");
  return line.starts_with("- ");
}

std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> words;
  while (!text.empty()) {
    const std::string_view word = text.substr(0, text.find(' '));
    if (!word.empty()) words.push_back(word);
    text.remove_prefix(std::min(word.size() + 1, text.size()));
  }
  return words;
}

/// Reads line by line; the block that is open is the last one of the last section.
class Reader {
 public:
  explicit Reader(std::vector<ManualSection>& sections) : sections_(sections) {}

  void read(std::string_view line) {
    if (fenced_ || line.starts_with(kFence)) return read_code(line);
    const std::size_t depth = line.find_first_not_of('#');
    if (depth != 0 && depth != line.npos && line[depth] == ' ') {
      open_ = false;
      sections_.push_back({line.substr(depth + 1), static_cast<int>(depth), {}, {}});
    } else if (line.starts_with(kIndex)) {
      line.remove_prefix(kIndex.size());
      sections_.back().words = words_of(line.substr(0, line.rfind(" -->")));
    } else if (is_blank(line)) {
      open_ = false;
    } else if (line.starts_with('|')) {
      if (!line.starts_with("|---")) add(Kind::Table, line);
    } else if (begins_item(line)) {
      open_ = false;
      add(Kind::Item, line);
    } else if (line.starts_with("    ")) {
      add(Kind::Code, line.substr(4));
    } else {
      add(open_ && kind() == Kind::Item ? Kind::Item : Kind::Paragraph, line);
    }
  }

 private:
  Kind kind() const { return sections_.back().blocks.back().kind; }

  void read_code(std::string_view line) {
    if (!line.starts_with(kFence)) return add(Kind::Code, line);
    fenced_ = !fenced_;
    open_ = false;
  }

  void add(Kind what, std::string_view line) {
    std::vector<ManualBlock>& blocks = sections_.back().blocks;
    if (!open_ || kind() != what) blocks.push_back({what, {}});
    blocks.back().lines.push_back(line);
    open_ = true;
  }

  std::vector<ManualSection>& sections_;
  bool fenced_ = false;  ///< between ``` and ```
  bool open_ = false;    ///< a line of the same kind goes on with the last block
};

}  // namespace

std::vector<ManualSection> read_manual(std::span<const std::string_view> chapters) {
  std::vector<ManualSection> sections;
  Reader reader(sections);
  for (std::string_view chapter : chapters) {
    while (!chapter.empty()) {
      const std::string_view line = chapter.substr(0, chapter.find('\n'));
      reader.read(line);
      chapter.remove_prefix(std::min(line.size() + 1, chapter.size()));
    }
  }
  return sections;
}

}  // namespace rob::lang
