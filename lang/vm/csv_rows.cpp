#include "lang/vm/csv_rows.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "lang/syntax/written_value.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"
#include "lang/text/source_text.h"
#include "lang/text/suggest.h"
#include "lang/text/utf8.h"
#include "lang/values/pose_functions.h"
#include "lang/values/pose_slots.h"
#include "lang/values/units.h"

namespace rob::lang {
namespace {

constexpr std::size_t kLongestCsvLine = 65536;  // bytes

struct CsvPlace {
  std::size_t line = 1;
  std::size_t column = 1;  ///< in code points
};
struct CsvField {
  std::string text;
  CsvPlace place;
};
using CsvLine = std::vector<CsvField>;

/// Thrown where reading cannot go on.
struct CsvWrong {
  std::string_view code;
  CsvPlace place;
  std::string message;
  std::string help;
};

/// Takes lines of fields from a text.
class CsvText {
 public:
  explicit CsvText(std::string_view text) : text_(text) {
    if (text_.starts_with(kByteOrderMark)) text_.remove_prefix(kByteOrderMark.size());
  }

  /// The next line that is not empty; none at the end.
  std::optional<CsvLine> line();
  CsvPlace place() const { return place_; }

 private:
  CsvField field();
  void quoted(std::string& into);
  bool at_end_of_line() const {
    return text_.empty() || text_.front() == '\n' || text_.starts_with("\r\n");
  }
  void end_line();
  /// The next character, which is UTF-8.
  void take(std::string& into);
  void skip() {
    std::string ignored;
    take(ignored);
  }

  std::string_view text_;
  CsvPlace place_;
  std::size_t length_ = 0;  ///< of the line so far, bytes
};

[[noreturn]] void fail_form(const CsvPlace& place, std::string message, std::string help = "") {
  throw CsvWrong{code::kCsvForm, place, std::move(message), std::move(help)};
}

void CsvText::take(std::string& into) {
  const CodePoint point = decode_utf8(text_);
  if (point.length == 0) fail_form(place_, "this is no UTF-8", "save the file as UTF-8");
  into.append(text_.substr(0, point.length));
  const bool line_end = text_.front() == '\n';
  length_ = line_end ? 0 : length_ + point.length;
  if (length_ > kLongestCsvLine)
    fail_form({place_.line, 1}, fmt::format("this line is longer than {} bytes", kLongestCsvLine));
  place_ = line_end ? CsvPlace{place_.line + 1, 1} : CsvPlace{place_.line, place_.column + 1};
  text_.remove_prefix(point.length);
}

void CsvText::end_line() {
  if (text_.starts_with('\r')) skip();
  if (!text_.empty()) skip();
}

void CsvText::quoted(std::string& into) {
  const CsvPlace begin = place_;
  skip();
  for (;;) {
    if (text_.empty()) fail_form(begin, "this quote is never closed", "a quote in a text is \"\"");
    const bool quote = text_.front() == '"';
    if (quote) skip();
    if (quote && !text_.starts_with('"')) break;
    take(into);
  }
  if (!at_end_of_line() && !text_.starts_with(','))
    fail_form(place_, "',' or the end of the line expected after the closing quote",
              "a quote in a text is \"\"");
}

CsvField CsvText::field() {
  CsvField field{"", place_};
  if (text_.starts_with('"')) {
    quoted(field.text);
    return field;
  }
  while (!at_end_of_line() && text_.front() != ',') {
    if (text_.front() == '"')
      fail_form(place_, "a quote in a text without quotes",
                "put quotes around it, and write \"\" for each quote in it");
    if (text_.front() == '\r') fail_form(place_, "a line ends with LF or CR LF, not with CR alone");
    take(field.text);
  }
  return field;
}

std::optional<CsvLine> CsvText::line() {
  while (!text_.empty() && at_end_of_line()) end_line();
  if (text_.empty()) return std::nullopt;
  CsvLine line{field()};
  while (text_.starts_with(',')) {
    skip();
    line.push_back(field());
  }
  end_line();
  return line;
}

/// A column that the record asks for.
struct CsvColumn {
  std::string name;  ///< "place.x"
  Type type;         ///< of one slot
  std::size_t at = 0;
  std::string unit{};  ///< that the header gives it
};

void add_columns(const std::string& name, const Type& type, std::vector<CsvColumn>& columns) {
  if (type.is(Type::Kind::Record)) {
    for (const TypeDetail::Field& field : type.detail->fields)
      add_columns(name.empty() ? field.name : name + "." + field.name, field.type, columns);
    return;
  }
  if (type.is(Type::Kind::Vec) || type.is(Type::Kind::Pose)) {
    const Dimension way = type.is(Type::Kind::Vec) ? type.dimension : kLength;
    for (const char* const part : {".x", ".y", ".z"})
      columns.push_back({name + part, Type::real(way)});
    if (type.is(Type::Kind::Vec)) return;
    for (const char* const part : {".a", ".b", ".c"})
      columns.push_back({name + part, Type::real(kAngle)});
    return;
  }
  columns.push_back({name, type});
}

std::string_view without_blanks_around(std::string_view text) {
  while (text.starts_with(' ') || text.starts_with('\t')) text.remove_prefix(1);
  while (text.ends_with(' ') || text.ends_with('\t')) text.remove_suffix(1);
  return text;
}

/// The rows of one file.
class CsvReader {
 public:
  CsvReader(std::string_view text, const Type& record, std::optional<std::size_t> rows)
      : text_(text), record_(record), rows_(rows) {
    add_columns("", record, columns_);
  }

  CsvRows read();

 private:
  void header();
  void find(const CsvField& title, std::size_t at, std::vector<bool>& found);
  void row(const CsvLine& line);
  [[noreturn]] void fail_length(const CsvPlace& place, std::string_view found) const;
  void put(const Type& type, const CsvLine& line, std::size_t& next);
  Slot number(const CsvColumn& column, const CsvField& field) const;

  CsvText text_;
  const Type& record_;
  std::optional<std::size_t> rows_;  ///< how many there must be
  std::vector<CsvColumn> columns_;
  std::size_t width_ = 0;
  CsvRows result_;
};

void CsvReader::find(const CsvField& title, std::size_t at, std::vector<bool>& found) {
  std::string_view name = without_blanks_around(title.text);
  std::string_view unit;
  if (const std::size_t bracket = name.find('['); bracket != name.npos && name.ends_with(']')) {
    unit = name.substr(bracket + 1, name.size() - bracket - 2);
    name = without_blanks_around(name.substr(0, bracket));
  }
  const auto column = std::ranges::find_if(
      columns_, [&](const CsvColumn& one) { return same_word(one.name, name); });
  if (column == columns_.end()) {
    std::vector<std::string_view> names;
    for (const CsvColumn& one : columns_) names.push_back(one.name);
    result_.warnings.push_back(
        {.code = std::string(code::kCsvUnknownColumn),
         .message =
             fmt::format("{}:{}: {} has no field {}; the column is left out", title.place.line,
                         title.place.column, record_.detail->name, shortened(name)),
         .help = did_you_mean(suggest(name, names))});
    return;
  }
  const auto index = static_cast<std::size_t>(column - columns_.begin());
  if (found[index])
    throw CsvWrong{code::kCsvColumn, title.place,
                   fmt::format("{} is a column already", shortened(name)), ""};
  if (!unit.empty()) {
    const auto known = find_unit(unit);
    if (!column->type.is(Type::Kind::Real) || !known || known->dimension != column->type.dimension)
      throw CsvWrong{code::kCsvColumn, title.place,
                     fmt::format("{} is {}; it is not measured in {}", column->name,
                                 in_words(column->type), shortened(unit)),
                     ""};
  }
  found[index] = true;
  column->at = at;
  column->unit = unit;
}

void CsvReader::header() {
  const std::optional<CsvLine> titles = text_.line();
  std::vector<bool> found(columns_.size(), false);
  if (titles) {
    width_ = titles->size();
    for (std::size_t i = 0; i < titles->size(); ++i) find((*titles)[i], i, found);
  }
  const auto missing = std::ranges::find(found, false);
  if (missing == found.end()) return;
  const CsvColumn& column = columns_[static_cast<std::size_t>(missing - found.begin())];
  throw CsvWrong{code::kCsvColumn,
                 {1, 1},
                 fmt::format("there is no column {}", column.name),
                 "the first line names the columns"};
}

CsvRows CsvReader::read() {
  header();
  std::size_t& count = result_.count;
  while (const std::optional<CsvLine> line = text_.line()) {
    ++count;
    if (rows_ && count > *rows_)
      fail_length(line->front().place, fmt::format("this is row {}", count));
    row(*line);
  }
  if (rows_ && count < *rows_) fail_length(text_.place(), fmt::format("the file {} rows", count));
  return std::move(result_);
}

void CsvReader::fail_length(const CsvPlace& place, std::string_view found) const {
  throw CsvWrong{code::kCsvLength, place,
                 fmt::format("the variable has {} elements, and {}", *rows_, found),
                 "give the array the length of the file, or read into a LIST"};
}

void CsvReader::row(const CsvLine& line) {
  if (line.size() != width_) {
    const std::size_t at = line.size() > width_ ? width_ : line.size() - 1;
    fail_form(line[at].place,
              fmt::format("this line has {} fields, and the first line {}", line.size(), width_));
  }
  std::size_t next = 0;
  put(record_, line, next);
}

Slot CsvReader::number(const CsvColumn& column, const CsvField& field) const {
  const std::string_view text = without_blanks_around(field.text);
  std::optional<Slot> slot = read_scalar(text, column.type);
  if (!slot && !column.unit.empty())
    slot = read_scalar(std::string(text) + column.unit, column.type);
  if (slot) return *slot;
  throw CsvWrong{code::kCsvValue, field.place,
                 fmt::format("'{}' is not {}, such as {}: {} needs one", shortened(field.text),
                             in_words(column.type), example_of(column.type), column.name),
                 ""};
}

/// The slots of a value, from its columns.
void CsvReader::put(const Type& type, const CsvLine& line, std::size_t& next) {
  const auto one = [&] {
    const CsvColumn& column = columns_[next++];
    return number(column, line[column.at]);
  };
  switch (type.kind) {
    case Type::Kind::String: {
      const CsvColumn& column = columns_[next++];
      result_.texts.push_back(line[column.at].text);
      return;
    }
    case Type::Kind::Vec:
      for (int i = 0; i < 3; ++i) result_.numbers.push_back(one());
      return;
    case Type::Kind::Pose: {
      std::vector<Slot> parts;
      for (int i = 0; i < 6; ++i) parts.push_back(one());
      std::vector<Slot> pose(kPoseSlots);
      pose_functions::pose_of(parts, pose.front());
      result_.numbers.insert(result_.numbers.end(), pose.begin(), pose.end());
      return;
    }
    case Type::Kind::Record:
      for (const TypeDetail::Field& field : type.detail->fields) put(field.type, line, next);
      return;
    default:
      result_.numbers.push_back(one());
  }
}

}  // namespace

std::variant<CsvRows, Refusal> read_csv(std::string_view file, std::string_view text,
                                        const Type& record, std::optional<std::size_t> rows) {
  try {
    CsvRows read = CsvReader(text, record, rows).read();
    for (Refusal& warning : read.warnings)
      warning.message = fmt::format("{}:{}", shortened(file), warning.message);
    return read;
  } catch (const CsvWrong& wrong) {
    return Refusal{.code = std::string(wrong.code),
                   .message = fmt::format("{}:{}:{}: {}", shortened(file), wrong.place.line,
                                          wrong.place.column, wrong.message),
                   .help = wrong.help};
  }
}

}  // namespace rob::lang
