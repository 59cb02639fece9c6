// Holds that modules stand above each other, never beside each other in a circle: who reads one
// would have to read them all.

#include <doctest/doctest.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tests/support/include_circles.h"
#include "tests/support/source_files.h"

using rob::test::include_circles;
using rob::test::module_of;

namespace {

using Circle = std::vector<std::string>;

std::string in_one_line(const Circle& circle) {
  std::string line;
  for (const std::string& module : circle) line += " " + module;
  return line;
}

/// Circles among files that are no more than their paths and what they include.
std::vector<Circle> circles_among(
    const std::vector<std::pair<std::string, std::vector<std::string_view>>>& files) {
  std::vector<rob::test::SourceFile> sources;
  for (const auto& [path, includes] : files) {
    sources.push_back({path, ""});
    for (const std::string_view include : includes) {
      sources.back().text += "#include \"" + std::string(include) + "\"\n";
    }
  }
  return include_circles(sources);
}

}  // namespace

TEST_CASE("no modules include each other in a circle") {
  REQUIRE(rob::test::layers().size() > 300);
  for (const Circle& circle : include_circles(rob::test::layers())) {
    FAIL_CHECK("these include each other:" << in_one_line(circle));
  }
}

TEST_CASE("a header and what has its name are one module") {
  CHECK(module_of("lang/vm/vm.h") == "lang/vm/vm");
  CHECK(module_of("lang/vm/vm.cpp") == module_of("lang/vm/vm.inc"));
  CHECK(module_of("lang/vm/vm.cpp") != module_of("lang/vm/vm_step.cpp"));
  CHECK(module_of("a.b/c") == "a.b/c");
  CHECK(circles_among({{"a.cpp", {"a.h", "a.def"}}, {"a.h", {"a.inc"}}}).empty());
}

TEST_CASE("a circle is found through sources and through others") {
  CHECK(circles_among({{"a.h", {"b.h"}}, {"b.h", {}}, {"b.cpp", {"b.h", "a.h"}}}) ==
        std::vector<Circle>{{"a", "b"}});
  CHECK(
      circles_among({{"c.h", {"b.h"}}, {"b.h", {"d.h", "a.h"}}, {"d.h", {}}, {"a.cpp", {"c.h"}}}) ==
      std::vector<Circle>{{"a", "b", "c"}});
  // Two circles that share a module are one; two that do not are two, even where one includes the
  // other.
  CHECK(circles_among({{"a.h", {"b.h", "c.h"}}, {"b.h", {"a.h"}}, {"c.h", {"a.h"}}}) ==
        std::vector<Circle>{{"a", "b", "c"}});
  CHECK(circles_among(
            {{"a.h", {"b.h"}}, {"b.h", {"a.h", "c.h"}}, {"c.h", {"d.h"}}, {"d.h", {"c.h"}}}) ==
        std::vector<Circle>{{"a", "b"}, {"c", "d"}});
}

TEST_CASE("where modules stand above each other there is no circle") {
  CHECK(
      circles_among({{"a.h", {"b.h", "c.h"}}, {"b.h", {"c.h", "d.h"}}, {"c.h", {"d.h"}}}).empty());
  CHECK(circles_among({{"a.h", {"a.h"}}}).empty());
}
