#include <doctest/doctest.h>

#include "tests/lang/parsing.h"

using namespace rob::lang;

TEST_CASE("a list holds expressions, on as many lines as it wants") {
  CHECK(expression("[1, a+2, [b]]") == "[1;(a + 2);[b;];]");
  CHECK(expression("[\n  1,\n  2\n][i]") == "[1;2;][i]");
}

TEST_CASE("the type of an array knows its element and where its length stands") {
  const Parsed p = parsed("VAR a: ARRAY[2 * n] OF ARRAY[3] OF LENGTH");
  const Type type = p.statement<Declaration>().type.value();
  REQUIRE(type.is(Type::Kind::Array));
  CHECK(type.detail->element.is(Type::Kind::Array));
  CHECK(type.detail->element.detail->element == Type::real(kLength));
  const auto written = static_cast<std::size_t>(type.detail->written);
  CHECK(shown(p.program.array_lengths.at(written).length) == "(2 * n)");
}

TEST_CASE("a record may be named as a type before it is read") {
  const Parsed p = parsed("VAR p: Part\nRECORD part\n  a, b: INT\n  c: TIME\nENDRECORD");
  const auto& record = p.statement<RecordDeclaration>(1);
  CHECK(p.statement<Declaration>().type == Type{Type::Kind::Record, {}, record.detail});
  REQUIRE(record.groups.size() == 2);
  CHECK(record.groups[0].names[1].name == "b");
  CHECK(record.groups[1].type == Type::real(kTime));
}
