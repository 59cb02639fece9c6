#include "runtime/cli/explain.h"

#include <fmt/format.h>

#include "lang/text/suggest.h"
#include "runtime/run/console.h"
#include "runtime/words/explanation.h"

namespace rob::runtime {

ExitCode explain(const std::string& word) {
  const std::string text = explanation_of(word);
  if (!text.empty()) {
    put_result(text);
    return ExitCode::Done;
  }
  const std::string meant = explained_near(word);
  put_error(fmt::format("there is no help on '{}'{}", lang::shortened(word),
                        meant.empty() ? "" : "; " + meant));
  put_message("rob --help lists the commands\n");
  return ExitCode::Usage;
}

}  // namespace rob::runtime
