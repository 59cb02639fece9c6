#include "tests/support/channel_writers.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "tests/support/cpp_classes.h"
#include "tests/support/cpp_tokens.h"
#include "tests/support/include_circles.h"

namespace rob::test {

namespace {

using Paths = std::set<std::string>;

/// What a name stands for.
struct Target {
  std::string of;  ///< a class whose members are known; empty: one value
  Paths paths;     ///< from the root, where it may be
};
using Names = std::map<std::string, Target, std::less<>>;

bool writes(std::string_view method) {
  constexpr std::array<std::string_view, 16> kWriting{
      "store",    "fetch_add", "fetch_sub",
      "fetch_or", "fetch_and", "compare_exchange_strong",
      "push",     "slot",      "compare_exchange_weak",
      "assign",   "push_back", "emplace_back",
      "insert",   "clear",     "resize",
      "emplace"};
  return std::ranges::find(kWriting, method) != kWriting.end();
}

/// "SpscRing" of "const motion::SpscRing<T>"; empty of pointers and references.
std::string class_of(const std::string& type) {
  if (type.ends_with('*') || type.ends_with('&')) return "";
  const std::string name = type.substr(0, type.find('<'));
  const std::size_t begin = name.find_last_of(" :");
  return begin == std::string::npos ? name : name.substr(begin + 1);
}

std::string joined(const std::string& path, const std::string& member) {
  return path.empty() ? member : path + "." + member;
}

/// A file with the brackets of its tokens.
struct FileTokens {
  explicit FileTokens(const SourceFile& file)
      : module(module_of(file.path)),
        tokens(tokens_of(file.text, text_of)),
        partners(partners_of(tokens)) {}

  bool at(std::size_t i, std::string_view text) const {
    return i < tokens.size() && tokens[i].is(text);
  }
  bool at_word(std::size_t i) const {
    return i < tokens.size() && tokens[i].kind == CppToken::Kind::Word;
  }
  bool at_access(std::size_t i) const { return at(i, ".") || at(i, "->"); }
  /// The last token of what begins with a name: the name, or brackets behind it.
  std::size_t past_brackets(std::size_t i) const {
    while (at(i + 1, "[") || at(i + 1, "(")) i = partners[i + 1];
    return i;
  }
  /// The first token of a.b().c, by that of c.
  std::size_t begin_of_chain(std::size_t i) const {
    while (i >= 2 && at_access(i - 1)) {
      i -= 2;
      if (at(i, ")") || at(i, "]")) i = partners[i] - 1;
    }
    return i;
  }
  bool at_twice(std::size_t i, std::string_view sign) const {
    return at(i, sign) && at(i + 1, sign);
  }
  bool counts_before(std::size_t i) const {
    return i >= 2 && (at_twice(i - 2, "+") || at_twice(i - 2, "-"));
  }
  /// Whether `i` begins =, +=, ++ and the like.
  bool assigns(std::size_t i) const {
    constexpr std::array<std::string_view, 8> kOperators{"+", "-", "*", "/", "|", "&", "^", "<<"};
    if (at(i, "=") || at_twice(i, "+") || at_twice(i, "-")) return true;
    return at(i + 1, "=") &&
           std::ranges::any_of(kOperators, [&](std::string_view sign) { return at(i, sign); });
  }

  std::string module;
  std::vector<CppToken> tokens;
  std::vector<std::size_t> partners;
};

struct KnownClass {
  const FileTokens* file = nullptr;
  CppClass declared;
  bool twice = false;  ///< two classes have its name

  const CppMember* member(std::string_view name) const {
    const auto found = std::ranges::find(declared.members, name, &CppMember::name);
    return found == declared.members.end() ? nullptr : &*found;
  }
};

class WriterSearch {
 public:
  WriterSearch(const std::vector<SourceFile>& files, const std::string& root) {
    for (const SourceFile& file : files) files_.emplace_back(file);
    for (const FileTokens& file : files_) {
      for (const CppClass& one : classes_in(file.tokens)) {
        const bool twice = classes_.contains(one.name);
        classes_[one.name] = {&file, one, twice};
      }
    }
    hold(root, "");
  }

  ChannelWriters all() {
    Names everywhere;
    for (const FileTokens& file : files_) everywhere.merge(declared_in(file));
    for (const FileTokens& file : files_) {
      Names names = declared_in(file);
      names.insert(everywhere.begin(), everywhere.end());
      for (const std::string& path : written_in(file, names, 0, file.tokens.size())) {
        writers_[path].insert(file.module);
      }
    }
    return writers_;
  }

 private:
  const KnownClass& known(const std::string& name) const {
    const auto found = classes_.find(name);
    if (found == classes_.end() || found->second.twice) {
      throw std::runtime_error("there is no class " + name + ", or there are two");
    }
    return found->second;
  }

  /// Notes where from the root the values of a class are.
  void hold(const std::string& name, const std::string& path) {
    places_[name].insert(path);
    for (const CppMember& member : known(name).declared.members) {
      const std::string inner = joined(path, member.name);
      if (const std::string type = class_of(member.type); classes_.contains(type)) {
        hold(type, inner);
      } else {
        writers_[inner];
      }
    }
  }

  /// Names of objects of the classes that are held: "Channels& channels", with or without const.
  /// Not those of members of such classes themselves, which stand behind other names.
  Names declared_in(const FileTokens& file) const {
    Names names;
    if (std::ranges::any_of(places_,
                            [&](const auto& held) { return known(held.first).file == &file; })) {
      return names;
    }
    for (std::size_t i = 0; i < file.tokens.size(); ++i) {
      const auto held = places_.find(file.tokens[i].text);
      if (!file.at_word(i) || held == places_.end()) continue;
      std::size_t j = i + 1;
      while (file.at(j, "&") || file.at(j, "*") || file.at(j, "const")) ++j;
      if (file.at_word(j)) names[file.tokens[j].text] = {held->first, held->second};
    }
    return names;
  }

  /// What is written between two tokens. References that are made there get names, too.
  Paths written_in(const FileTokens& file, Names names, std::size_t begin, std::size_t end) const {
    Paths written;
    for (std::size_t i = begin; i < end; ++i) {
      const auto found = names.find(file.tokens[i].text);
      if (!file.at_word(i) || found == names.end()) continue;
      const std::size_t first = file.begin_of_chain(i);
      const std::size_t name = file.past_brackets(i);
      Target target = found->second;
      const Paths by_it = follow(file, i, target);  // up to its last token
      written.insert(by_it.begin(), by_it.end());
      // A name of an object alone is a pointer, or gets its meaning here.
      const bool itself = i > name || target.of.empty();
      if (itself && (file.counts_before(first) || file.assigns(i + 1))) {
        written.merge(values_of(target));
      }
      if (first >= 3 && file.at(first - 1, "=") && file.at(first - 3, "&") && file.at(i + 1, ";")) {
        names[file.tokens[first - 2].text] = target;
      }
    }
    return written;
  }

  Paths values_of(const Target& target) const {
    if (target.of.empty()) return target.paths;
    Paths values;
    for (const CppMember& member : known(target.of).declared.members) {
      values.merge(values_of(target_of(member, target.paths)));
    }
    return values;
  }

  /// From a name on to the end of what it begins: a.b().c; moves `i` and `target` there. Returns
  /// what a call at its end writes.
  Paths follow(const FileTokens& file, std::size_t& i, Target& target) const {
    for (i = file.past_brackets(i); file.at_access(i + 1) && file.at_word(i + 2);) {
      const std::string name = file.tokens[i + 2].text;
      const bool called = file.at(i + 3, "(");
      if (target.of.empty() && file.at(i + 1, "->")) target.paths.clear();  // what it points to
      i = file.past_brackets(i + 2);
      if (target.of.empty()) {
        if (called && writes(name)) return target.paths;
      } else if (const CppMember* const member = known(target.of).member(name)) {
        target = target_of(*member, target.paths);
      } else {
        return called ? written_by_call(target, name) : Paths();
      }
    }
    return {};
  }
  Target target_of(const CppMember& member, const Paths& holders) const {
    Target target;
    if (const std::string type = class_of(member.type); classes_.contains(type)) target.of = type;
    for (const std::string& path : holders) target.paths.insert(joined(path, member.name));
    return target;
  }

  Paths written_by_call(const Target& target, const std::string& name) const {
    const KnownClass& of = known(target.of);
    Names members;
    for (const CppMember& member : of.declared.members) {
      members[member.name] = target_of(member, target.paths);
    }
    Paths written;
    for (const CppMethod& method : of.declared.methods) {
      if (method.name != name) continue;
      if (of.file->at(method.end - 1, ";")) {
        throw std::runtime_error(target.of + "::" + name + " has no body in its class");
      }
      written.merge(written_in(*of.file, members, method.begin, method.end));
      for (std::size_t i = method.begin; i < method.end; ++i) {
        if (calls_another(*of.file, i, name)) {
          written.merge(written_by_call(target, of.file->tokens[i].text));
        }
      }
    }
    return written;
  }
  /// Whether a method of the same object is called, if there is one of that name.
  static bool calls_another(const FileTokens& file, std::size_t i, const std::string& name) {
    return file.at_word(i) && file.at(i + 1, "(") && !file.at_access(i - 1) &&
           !file.at(i - 1, "::") && !file.at(i, name);
  }

  std::vector<FileTokens> files_;
  std::map<std::string, KnownClass, std::less<>> classes_;
  std::map<std::string, Paths, std::less<>> places_;  ///< of the classes that are held
  ChannelWriters writers_;
};

}  // namespace

ChannelWriters channel_writers(const std::vector<SourceFile>& files, const std::string& root) {
  return WriterSearch(files, root).all();
}

}  // namespace rob::test
