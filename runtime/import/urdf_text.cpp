#include "runtime/import/urdf_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "lang/text/utf8.h"
#include "motion/robots/robot_file_error.h"

namespace rob::runtime {

namespace {

// [choice] Some ten times what published robots have. The reader of XML calls itself for each
// level, and looks through all attributes for each new one.
constexpr int kMostLevels = 100;
constexpr int kMostLinks = 1000;
constexpr std::size_t kLongestTag = std::size_t{1} << 16U;

/// Goes through the tags of a text, one after the other.
class TagScanner {
 public:
  TagScanner(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  std::map<std::string, std::size_t> check() {
    for (at_ = text_.find('<'); at_ != std::string_view::npos; at_ = text_.find('<', at_)) step();
    if (elements_ == 0) fail("is not XML: it has no element such as <robot>");
    if (level_ != 0) fail("is not XML: some element is not closed; the file may be cut off");
    return std::move(collisions_);
  }

 private:
  void step() {
    if (skipped("<!--", "-->") || skipped("<![CDATA[", "]]>") || skipped("<?", "?>") ||
        skipped("<!", ">"))
      return;
    const std::size_t end = end_of_tag();
    const std::string_view tag = text_.substr(at_, end - at_);
    if (tag.starts_with("</")) {
      if (--level_ < 0) fail("is not XML: more elements end than begin");
    } else {
      ++elements_;
      check_tag(tag);
      count(tag);
      if (!tag.ends_with("/")) ++level_;
    }
    if (level_ > kMostLevels) fail(fmt::format("is nested more than {} levels deep", kMostLevels));
    at_ = end;
  }

  bool skipped(std::string_view begin, std::string_view end) {
    if (!text_.substr(at_).starts_with(begin)) return false;
    const std::size_t found = text_.find(end, at_ + begin.size());
    if (found == std::string_view::npos)
      fail(fmt::format("is not XML: a {} has no {} after it", begin, end));
    at_ = found + end.size();
    return true;
  }

  /// Where its > is; one inside quotation marks is part of a value.
  std::size_t end_of_tag() const {
    char quote = 0;
    const std::size_t last = std::min(text_.size(), at_ + kLongestTag);
    for (std::size_t i = at_; i < last; ++i) {
      const char c = text_[i];
      if (quote != 0) {
        if (c == quote) quote = 0;
      } else if (c == '"' || c == '\'') {
        quote = c;
      } else if (c == '>') {
        return i;
      }
    }
    fail(last == text_.size() ? "is not XML: a tag has no >"
                              : fmt::format("has a tag of more than {} bytes", kLongestTag));
  }

  void check_tag(std::string_view tag) {
    if (tag.starts_with("<xacro:") || tag.find("${") != std::string_view::npos ||
        tag.find("$(") != std::string_view::npos)
      fail(
          "is a xacro, from which a URDF is made; run xacro first: xacro arm.urdf.xacro > "
          "arm.urdf");
    if (!tag.starts_with("<link")) return;
    if (++links_ > kMostLinks) fail(fmt::format("has more than {} links", kMostLinks));
  }

  /// A <collision> is a child of a <link>, which is one of the robot.
  void count(std::string_view tag) {
    if (level_ == 1) link_ = is(tag, "<link") ? &collisions_[attribute(tag, "name")] : nullptr;
    if (level_ == 2 && link_ != nullptr && is(tag, "<collision")) ++*link_;
  }

  static bool is(std::string_view tag, std::string_view element) {
    constexpr std::string_view kEnds = " \t\r\n/";
    if (!tag.starts_with(element)) return false;
    const std::string_view rest = tag.substr(element.size());
    return rest.empty() || kEnds.find(rest.front()) != std::string_view::npos;
  }

  /// As it is written between its quotation marks.
  static std::string attribute(std::string_view tag, std::string_view name) {
    for (std::size_t at = tag.find('='); at != std::string_view::npos;) {
      std::string_view key = tag.substr(0, at);
      while (!key.empty() && std::string_view(" \t\r\n").find(key.back()) != std::string_view::npos)
        key.remove_suffix(1);
      const std::size_t open = tag.find_first_of("\"'", at);
      if (open == std::string_view::npos) return "";
      const std::size_t close = tag.find(tag[open], open + 1);
      if (close == std::string_view::npos) return "";
      if (key.ends_with(name)) return std::string(tag.substr(open + 1, close - open - 1));
      at = tag.find('=', close);
    }
    return "";
  }

  [[noreturn]] void fail(const std::string& problem) const {
    const auto end = text_.begin() + static_cast<std::ptrdiff_t>(std::min(at_, text_.size()));
    throw motion::RobotFileError(
        fmt::format("{}:{}: {}", file_, 1 + std::count(text_.begin(), end, '\n'), problem));
  }

  std::string_view text_;
  const std::string& file_;
  std::size_t at_ = 0;
  int level_ = 0;
  int elements_ = 0;
  int links_ = 0;
  std::map<std::string, std::size_t> collisions_;
  std::size_t* link_ = nullptr;  // of the link that is open
};

void check_characters(std::string_view text, const std::string& file) {
  int line = 1;
  for (std::size_t i = 0; i < text.size();) {
    const lang::CodePoint point = lang::decode_utf8(text.substr(i));
    if (point.length == 0 || point.value == 0)
      throw motion::RobotFileError(
          fmt::format("{}:{}: is no text in UTF-8, as a URDF is; name the .urdf file", file, line));
    if (point.value == '\n') ++line;
    i += point.length;
  }
}

}  // namespace

std::map<std::string, std::size_t> check_urdf_text(std::string_view text, const std::string& file) {
  check_characters(text, file);
  return TagScanner(text, file).check();
}

}  // namespace rob::runtime
