#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace rob::test {

/// A piece of a C++ text.
struct CppToken {
  enum class Kind {
    Word,      ///< a name or a keyword
    Number,    ///< 1'000.5e-3
    Text,      ///< a literal in quotes, of whatever kind
    Sign,      ///< :: -> ## << <= >= == != && || or one character; so >> is two of them
    Directive  ///< a whole directive of the preprocessor; never among the tokens of tokens_of()
  };
  Kind kind = Kind::Sign;
  std::string text;
  int line = 0;  ///< from 1, in the file in which it stands

  bool is(std::string_view other) const { return kind != Kind::Text && text == other; }
};

/// The text of an included file, by the name in its quotes.
using ReadIncluded = std::function<std::string(const std::string& name)>;

/// The tokens of a C++ text, as the compiler meets them: without comments, with what .inc and .def
/// files bring in the place where they are included, and with the macros that the text itself
/// defines replaced by what they mean. It does not know other macros, and takes all branches of an
/// #if.
std::vector<CppToken> tokens_of(std::string_view text, const ReadIncluded& read);

}  // namespace rob::test
