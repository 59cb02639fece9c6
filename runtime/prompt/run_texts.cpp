#include "runtime/prompt/run_texts.h"

#include <fmt/format.h>

#include <algorithm>

#include "lang/text/visible.h"
#include "runtime/files/text_lines.h"

namespace rob::runtime {

void RunTexts::keep(std::uint32_t line, const LoadedProgram& program) {
  runs_[line] = {program.file, program.source, program.compilation.used};
}

std::string RunTexts::rendered(const lang::Diagnostic& finding, std::uint32_t line) const {
  const Run& run = runs_.at(line);
  return lang::render(finding, run.file, run.source, run.used);
}

std::string RunTexts::beginning_of(lang::Place place) const {
  const Run& run = runs_.rbegin()->second;
  const bool main = place.file == 0;
  const auto lines = split_lines(main ? run.source : run.used.at(place.file - 1).text);
  const std::string text = place.line <= lines.size() ? lines[place.line - 1] : "";
  return fmt::format("{}line {} begins: {}",
                     main ? "" : lang::on_one_line(run.used.at(place.file - 1).name) + " ",
                     place.line, text.substr(std::min(text.find_first_not_of(" \t"), text.size())));
}

}  // namespace rob::runtime
