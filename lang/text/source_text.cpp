#include "lang/text/source_text.h"

#include <optional>
#include <string>

#include <fmt/format.h>

#include "lang/text/codes.h"
#include "lang/text/utf8.h"

namespace rob::lang {

namespace {

/// One kind of unreadable byte: where it was met first, and how often.
struct Finding {
  std::size_t first = 0;
  Place place;
  std::size_t count = 0;

  void note(std::size_t offset, const Place& where) {
    if (count++ == 0) {
      first = offset;
      place = where;
    }
  }
  std::string more() const { return count > 1 ? fmt::format(" (and {} more)", count - 1) : ""; }
};

/// Walks over a text character by character and remembers what cannot be read.
class Scan {
 public:
  Scan(std::string_view source, std::uint32_t file, TextParts parts)
      : source_(source), count_(parts), place_{count_.line(), 0, 1, file} {
    if (source.starts_with(kByteOrderMark)) offset_ = line_begin_ = kByteOrderMark.size();
  }

  void run() {
    while (offset_ < source_.size()) step();
    end_line();
  }

  bool report(Diagnostics& diagnostics) const {
    if (nul_.count > 0) {
      diagnostics.error(
          code::kNulByte, nul_.place,
          fmt::format("byte {} is NUL: this is not a text file{}", nul_.first, nul_.more()));
    }
    if (invalid_.count > 0) {
      diagnostics.error(
          code::kInvalidUtf8, invalid_.place,
          fmt::format("byte {} is not valid UTF-8{}", invalid_.first, invalid_.more()),
          "save the file as UTF-8");
    }
    if (lone_return_.count > 0) {
      diagnostics.error(code::kLoneCarriageReturn, lone_return_.place,
                        fmt::format("byte {} is a carriage return without a line feed{}",
                                    lone_return_.first, lone_return_.more()),
                        "end lines with LF or CR LF");
    }
    if (long_line_.count > 0) {
      diagnostics.error(code::kLineTooLong, long_line_.place,
                        fmt::format("the line is too long: more than {} bytes{}", kMaxLineBytes,
                                    long_line_.more()));
    }
    return nul_.count + invalid_.count + lone_return_.count + long_line_.count == 0;
  }

 private:
  void step() {
    const char byte = source_[offset_];
    ++place_.column;
    if (byte == '\n') {
      end_line();
      ++offset_;
      line_begin_ = offset_;
      count_.next(offset_);
      place_ = {count_.line(), 0, 1, place_.file};
      return;
    }
    if (byte == '\0') nul_.note(offset_, place_);
    if (byte == '\r' && !source_.substr(offset_ + 1).starts_with('\n')) {
      lone_return_.note(offset_, place_);
    }
    const std::size_t length = decode_utf8(source_.substr(offset_)).length;
    if (length == 0) invalid_.note(offset_, place_);
    offset_ += length == 0 ? 1 : length;
  }

  void end_line() {
    if (offset_ - line_begin_ > kMaxLineBytes) {
      long_line_.note(line_begin_, {place_.line, 1, 1, place_.file});
    }
  }

  std::string_view source_;
  std::size_t offset_ = 0;
  std::size_t line_begin_ = 0;
  LineCount count_;
  Place place_;
  Finding nul_;
  Finding invalid_;
  Finding lone_return_;
  Finding long_line_;
};

}  // namespace

bool check_source(std::string_view source, Diagnostics& diagnostics, std::uint32_t file,
                  TextParts parts) {
  if (source.size() > kMaxSourceBytes) {
    diagnostics.error(code::kFileTooLarge, Place{0, 0, 1, file},
                      fmt::format("the file is too large: {} bytes, at most {} are read",
                                  source.size(), kMaxSourceBytes));
    return false;
  }
  Scan scan(source, file, parts);
  scan.run();
  return scan.report(diagnostics);
}

}  // namespace rob::lang
