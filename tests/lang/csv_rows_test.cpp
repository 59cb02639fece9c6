#include "lang/vm/csv_rows.h"

#include <doctest/doctest.h>

#include <string>

using rob::lang::CsvRows;
using rob::lang::read_csv;
using rob::lang::Refusal;
using rob::lang::Type;
using rob::lang::TypeDetail;

namespace {

/// name: STRING, size: LENGTH, count: INT, at: POSE
const Type& part() {
  static const Type type = [] {
    static TypeDetail detail;
    detail.name = "part";
    detail.fields = {{"name", Type::string()},
                     {"size", Type::real(rob::lang::kLength)},
                     {"count", Type::integer()}};
    detail.slots = {.numbers = 2, .texts = 1};
    return Type{Type::Kind::Record, {}, &detail};
  }();
  return type;
}

/// The code and the message of what is wrong; empty where nothing is.
std::string wrong(const std::string& text, std::size_t rows = 1) {
  const auto read = read_csv("p.csv", text, part(), rows);
  const auto* const why = std::get_if<Refusal>(&read);
  return why == nullptr ? "" : why->code + " " + why->message;
}

bool begins(const std::string& text, const std::string& with) { return text.starts_with(with); }

}  // namespace

TEST_CASE("CSV is read as RFC 4180 says, with what programs of tables make of it") {
  const std::string text =
      "\xEF\xBB\xBFsize[cm],\"name\",count\r\n"
      "1.5,\"a, \"\"b\"\"\nc\",7\r\n"
      "\r\n"
      "20mm, d ,-3";
  const auto read = read_csv("p.csv", text, part(), 2);
  const auto* const rows = std::get_if<CsvRows>(&read);
  REQUIRE(rows != nullptr);
  CHECK(rows->texts == std::vector<std::string>{"a, \"b\"\nc", " d "});
  REQUIRE(rows->numbers.size() == 4);
  CHECK(rows->numbers[1].integer == 7);
  CHECK(rows->numbers[3].integer == -3);
  CHECK(rows->warnings.empty());
}

TEST_CASE("what is wrong in CSV is told with line and column, in code points") {
  const std::string head = "name,size,count\n";
  CHECK(wrong(head + "a,1mm,2\n").empty());
  CHECK(begins(wrong(head + "\xC3\xA4\xC3\xA4,1,2\n"), "E362 p.csv:2:4: '1' is not a length"));
  CHECK(begins(wrong(head + "a,1s,2\n"), "E362 p.csv:2:3: "));
  CHECK(begins(wrong(head + "a,1mm,2.5\n"), "E362 p.csv:2:7: "));
  CHECK(begins(wrong(head + "a,1mm,\n"), "E362 p.csv:2:7: "));
  CHECK(begins(wrong(head + "a,1mm,2 3\n"), "E362 p.csv:2:7: "));
  CHECK(begins(wrong(head + "a,1mm,9223372036854775808\n"), "E362 p.csv:2:7: "));
  CHECK(wrong(head + "a,1mm,-9223372036854775808\n").empty());
  CHECK(begins(wrong(head + "\"a\nb\",1,2\n"), "E362 p.csv:3:4: "));
  CHECK(begins(wrong(head + "a,1mm\n"), "E361 p.csv:2:3: "));
  CHECK(begins(wrong(head + "a,1mm,2,\n"), "E361 p.csv:2:9: "));
  CHECK(begins(wrong(head + "\"a,1mm,2\n"), "E361 p.csv:2:1: this quote is never closed"));
  CHECK(begins(wrong(head + "\"a\"b,1mm,2\n"), "E361 p.csv:2:4: "));
  CHECK(begins(wrong(head + "a\"b,1mm,2\n"), "E361 p.csv:2:2: "));
  CHECK(begins(wrong(head + "a\r,1mm,2\n"), "E361 p.csv:2:2: "));
  CHECK(begins(wrong(head + "a\xFF,1mm,2\n"), "E361 p.csv:2:2: this is no UTF-8"));
  CHECK(begins(wrong(head + std::string(70'000, 'a') + ",1mm,2\n"), "E361 p.csv:2:1: "));
  CHECK(begins(wrong(""), "E363 p.csv:1:1: there is no column name"));
  CHECK(begins(wrong("name,count\n"), "E363 p.csv:1:1: there is no column size"));
  CHECK(begins(wrong("name,count,size,SIZE\n"), "E363 p.csv:1:17: "));
  CHECK(begins(wrong("name,count,size[s]\n"), "E363 p.csv:1:12: "));
  CHECK(begins(wrong("name,count[mm],size\n"), "E363 p.csv:1:6: "));
  CHECK(begins(wrong(head + "a,1mm,2\n", 2), "E364 p.csv:3:1: "));
  CHECK(begins(wrong(head + "a,1mm,2\nb,1mm,2\n"), "E364 p.csv:3:1: "));
}

TEST_CASE("a column that no field asks for is a warning, with the field that may be meant") {
  const auto read = read_csv("p.csv", "name,size,count,cuont\na,1mm,2,x\n", part(), 1);
  const auto* const rows = std::get_if<CsvRows>(&read);
  REQUIRE(rows != nullptr);
  REQUIRE(rows->warnings.size() == 1);
  CHECK(rows->warnings[0].code == "W527");
  CHECK(rows->warnings[0].message.starts_with("p.csv:1:17: part has no field cuont"));
  CHECK(rows->warnings[0].help == "did you mean count?");
}
