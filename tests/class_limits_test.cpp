// Holds the size of every class of the product: what one object may own, and how much it may do.

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "tests/support/cpp_classes.h"
#include "tests/support/cpp_tokens.h"
#include "tests/support/source_files.h"

namespace {

constexpr int kMostMethods = 60;
constexpr int kMostMembers = 25;
/// A class with so few functions is plain data: one can read it from top to bottom.
constexpr int kMethodsOfData = 2;
constexpr int kMostMembersOfData = 40;

/// The size of a class, and the place where it begins.
struct ClassSize {
  std::string name;
  std::string place;  ///< "motion/path/joint_path.h:20"
  int methods = 0;
  int members = 0;
};

bool is_too_large(const ClassSize& size) {
  const bool data = size.methods <= kMethodsOfData;
  return size.methods > kMostMethods || size.members > (data ? kMostMembersOfData : kMostMembers);
}

/// A class contains what it includes from .inc and .def files.
std::vector<ClassSize> classes_of_layers() {
  std::vector<ClassSize> all;
  for (const rob::test::SourceFile& file : rob::test::layers()) {
    if (!file.path.ends_with(".h") && !file.path.ends_with(".cpp")) continue;
    const auto tokens = rob::test::tokens_of(file.text, rob::test::text_of);
    for (const rob::test::CppClass& one : rob::test::classes_in(tokens)) {
      all.push_back({one.name, file.path + ":" + std::to_string(one.line),
                     static_cast<int>(one.methods.size()), static_cast<int>(one.members.size())});
    }
  }
  return all;
}

}  // namespace

TEST_CASE("no class has more than 60 methods or 25 members, plain data no more than 40") {
  const std::vector<ClassSize> all = classes_of_layers();
  REQUIRE(all.size() > 300);
  for (const ClassSize& one : all) {
    CHECK_MESSAGE(!is_too_large(one), one.place << ": " << one.name << " has " << one.methods
                                                << " methods and " << one.members
                                                << " members: split it by state");
  }
}

TEST_CASE("a class at its limit is not too large, one above it is") {
  const auto too_large = [](int methods, int members) {
    return is_too_large({"A", "a.h:1", methods, members});
  };
  CHECK_FALSE(too_large(60, 25));
  CHECK(too_large(61, 0));
  CHECK(too_large(3, 26));
  CHECK_FALSE(too_large(2, 40));
  CHECK(too_large(2, 41));
}
