#pragma once

#include <map>
#include <string>
#include <string_view>
#include <variant>

#include "lang/syntax/used_files.h"

namespace rob::test {

/// Files to USE that are no more than their texts, by name.
class TextFiles final : public lang::Sources {
 public:
  std::map<std::string, std::string, std::less<>> texts;

  const lang::SourceFile& program() const override { return program_; }
  std::variant<lang::SourceFile, lang::NoSource> find(std::string_view name,
                                                      const std::string& /*by*/) const override {
    const auto found = texts.find(name);
    if (found == texts.end()) return lang::NoSource{"there is no such file", ""};
    return lang::SourceFile{found->first + ".rob", found->first, found->second};
  }

 private:
  const lang::SourceFile program_{"main.rob", "main", ""};
};

}  // namespace rob::test
