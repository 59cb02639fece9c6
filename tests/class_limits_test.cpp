// Holds the size of every class of the product: what one object may own, and how much it may do.

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <string_view>
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

struct ClassSize {
  std::string name;
  int line = 0;  ///< where it begins; a list does not say it
  int methods = 0;
  int members = 0;
};

ClassSize size_of(const rob::test::CppClass& one) {
  return {one.name, one.line, static_cast<int>(one.methods.size()),
          static_cast<int>(one.members.size())};
}

bool is_too_large(const ClassSize& size) {
  const bool data = size.methods <= kMethodsOfData;
  return size.methods > kMostMethods || size.members > (data ? kMostMembersOfData : kMostMembers);
}

/// A class of a layer, with its size.
struct LayerClass {
  std::string layer;
  ClassSize size;
  std::string path{};  ///< of the file in which it begins; a list does not say it
};

/// The classes that are still too large, each as it is. No class may be added, and no number
/// raised.
const std::vector<LayerClass>& still_too_large() {
  static const std::vector<LayerClass> classes = {};
  return classes;
}

std::string words_for(const ClassSize& size) {
  return size.name + " has " + std::to_string(size.methods) + " methods and " +
         std::to_string(size.members) + " members";
}

/// Empty, or what is wrong with the size of a class that stands in a list of large ones as
/// `listed`; null: it does not.
std::string complaint_about(const ClassSize& size, const ClassSize* listed) {
  if (!is_too_large(size)) {
    return listed == nullptr ? "" : words_for(size) + ": take it from the list";
  }
  if (listed == nullptr) return words_for(size) + ": split it by what it owns";
  if (size.methods > listed->methods || size.members > listed->members) {
    return words_for(size) + ": it has grown";
  }
  const bool shrunk = size.methods < listed->methods || size.members < listed->members;
  return shrunk ? words_for(size) + ": lower its entry in the list" : "";
}

bool same(const LayerClass& a, const LayerClass& b) {
  return a.layer == b.layer && a.size.name == b.size.name;
}

const ClassSize* entry_of(const LayerClass& one) {
  for (const LayerClass& entry : still_too_large()) {
    if (same(one, entry)) return &entry.size;
  }
  return nullptr;
}

/// What .inc and .def files bring comes with the class that includes them.
std::vector<LayerClass> classes_of_layers() {
  std::vector<LayerClass> all;
  for (const rob::test::SourceFile& file : rob::test::layers()) {
    if (!file.path.ends_with(".h") && !file.path.ends_with(".cpp")) continue;
    const std::string layer = file.path.substr(0, file.path.find('/'));
    const auto tokens = rob::test::tokens_of(file.text, rob::test::text_of);
    for (const rob::test::CppClass& one : rob::test::classes_in(tokens)) {
      all.push_back({layer, size_of(one), file.path});
    }
  }
  return all;
}

}  // namespace

TEST_CASE("no class has more than 60 methods or 25 members, plain data no more than 40") {
  const std::vector<LayerClass> all = classes_of_layers();
  REQUIRE(all.size() > 300);
  for (const LayerClass& one : all) {
    const std::string complaint = complaint_about(one.size, entry_of(one));
    CHECK_MESSAGE(complaint.empty(), one.path << ":" << one.size.line << ": " << complaint);
  }
}

TEST_CASE("each class in the list of large ones is one class that is there") {
  const std::vector<LayerClass> all = classes_of_layers();
  for (const LayerClass& entry : still_too_large()) {
    const auto count =
        std::ranges::count_if(all, [&](const LayerClass& one) { return same(one, entry); });
    CHECK_MESSAGE(count == 1, entry.layer << " has " << count << " classes " << entry.size.name);
  }
}

TEST_CASE("a class at its limit is not too large, one above it is") {
  const auto too_large = [](int methods, int members) {
    return !complaint_about({"A", 1, methods, members}, nullptr).empty();
  };
  CHECK_FALSE(too_large(60, 25));
  CHECK(too_large(61, 0));
  CHECK(too_large(3, 26));
  CHECK_FALSE(too_large(2, 40));
  CHECK(too_large(2, 41));
}

TEST_CASE("a class in the list of large ones stands there as it is") {
  const ClassSize listed{"A", 1, 70, 30};
  const auto complains = [&](int methods, int members) {
    return !complaint_about({"A", 1, methods, members}, &listed).empty();
  };
  CHECK_FALSE(complains(70, 30));
  CHECK(complains(71, 30));
  CHECK(complains(69, 31));
  CHECK(complains(69, 30));
  CHECK(complains(70, 25));
  CHECK(complains(60, 25));
}
