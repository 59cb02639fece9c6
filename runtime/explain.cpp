#include "runtime/explain.h"

#include <fmt/format.h>

#include <string_view>
#include <vector>

#include "lang/help/help.h"
#include "lang/text/ascii.h"
#include "lang/text/suggest.h"
#include "runtime/control/codes.h"
#include "runtime/program/console.h"

namespace rob::runtime {

namespace {

std::string suggestion(const std::string& word) {
  std::vector<std::string_view> topics = lang::help_topics();
  for (const CodeText& code : all_codes()) topics.push_back(code.code);
  return lang::did_you_mean(fmt::format("{}", fmt::join(lang::nearest(word, topics), " or ")));
}

}  // namespace

std::string explanation_of(const std::string& word) {
  for (const CodeText& code : all_codes()) {
    if (lang::same_word(code.code, word)) {
      return lang::help_text({code.code, code.title, code.explanation});
    }
  }
  return lang::help_on(word);
}

ExitCode explain(const std::string& word) {
  const std::string text = explanation_of(word);
  if (!text.empty()) {
    put_result(text);
    return ExitCode::Done;
  }
  const std::string meant = suggestion(word);
  put_error(fmt::format("there is no help on '{}'{}", lang::shortened(word),
                        meant.empty() ? "" : "; " + meant));
  put_message("rob --help lists the commands\n");
  return ExitCode::Usage;
}

}  // namespace rob::runtime
