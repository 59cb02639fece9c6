#include "lang/format/source_lines.h"

#include <algorithm>
#include <utility>

#include "lang/text/utf8.h"

namespace rob::lang {

SourceLines::SourceLines(std::string_view source, Diagnostics& diagnostics)
    : source_(source), lexer_(source, diagnostics), pending_(lexer_.next()) {
  if (source.starts_with(kByteOrderMark)) begin_ = kByteOrderMark.size();
}

bool SourceLines::next(SourceLine& line) {
  line.tokens.clear();
  line.comment = {};
  if (begin_ >= source_.size()) return false;
  ++number_;
  while (pending_.kind != TokenKind::EndOfFile && pending_.place.line == number_) {
    if (pending_.kind != TokenKind::EndOfLine) line.tokens.push_back(std::move(pending_));
    pending_ = lexer_.next();
  }
  const std::size_t end = std::min(source_.find('\n', begin_), source_.size());
  find_comment(line, end);
  begin_ = end + 1;
  return true;
}

/// After the last token there are blanks and the comment alone.
void SourceLines::find_comment(SourceLine& line, std::size_t end) const {
  std::size_t behind = begin_;
  if (!line.tokens.empty()) behind = line.tokens.back().offset + line.tokens.back().text.size();
  const std::string_view rest = source_.substr(behind, end - behind);
  const std::size_t mark = rest.find("//");
  if (mark == std::string_view::npos) return;
  const std::size_t last = rest.find_last_not_of(" \t\r");
  line.comment = rest.substr(mark, last + 1 - mark);
  line.comment_column = count_code_points(source_.substr(begin_, behind + mark - begin_)) + 1;
}

}  // namespace rob::lang
