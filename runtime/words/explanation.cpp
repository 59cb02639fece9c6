#include "runtime/words/explanation.h"

#include <fmt/format.h>

#include <string_view>
#include <vector>

#include "lang/help/help.h"
#include "lang/text/ascii.h"
#include "lang/text/suggest.h"
#include "runtime/words/codes.h"

namespace rob::runtime {

std::string explanation_of(const std::string& word) {
  for (const CodeText& code : all_codes()) {
    if (lang::same_word(code.code, word)) {
      return lang::help_text({code.code, code.title, code.explanation});
    }
  }
  return lang::help_on(word);
}

std::string explained_near(const std::string& word) {
  std::vector<std::string_view> topics = lang::help_topics();
  for (const CodeText& code : all_codes()) topics.push_back(code.code);
  return lang::did_you_mean(fmt::format("{}", fmt::join(lang::nearest(word, topics), " or ")));
}

}  // namespace rob::runtime
