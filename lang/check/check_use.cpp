#include <fmt/core.h>

#include "lang/check/statement_checker.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"
#include "lang/text/suggest.h"

/// The parts of the checkers that know USE, and names of other files.
namespace rob::lang {

/// Where a file is USEd for the first time its declarations are checked, with its own names.
void StatementChecker::check(Use& use) {
  if (use.file == 0) return;
  const Place place = place_;
  const std::uint32_t user = scopes_.enter_file(use.file);
  for (Statement& statement : use.declarations) {
    uses_.next_statement();
    check(statement);
  }
  scopes_.enter_file(user);
  for (const Symbol* const own : scopes_.shared_with(use.file)) {
    warn_of_hiding(own->name, own->place, use.name);
  }
  scopes_.use(use.name, use.file);
  place_ = place;
}

void StatementChecker::warn_of_hiding(const std::string& name, const Place& place,
                                      const std::string& file) {
  diagnostics_.warning(code::kHidesUsed, place,
                       fmt::format("{0} hides the {0} of {1}", shortened(name), shortened(file)),
                       fmt::format("write {}.{} for that one, or give this one another name",
                                   shortened(file), shortened(name)));
}

/// A plain name that several USEd files declare.
bool ExpressionChecker::report_ambiguous(std::string_view name, Place place) {
  const std::vector<std::string> files = scopes_.files_with(name);
  if (files.size() < 2) return false;
  diagnostics_.error(code::kAmbiguousName, place,
                     fmt::format("{} is declared in {} and in {}", shortened(name),
                                 shortened(files[0]), shortened(files[1])),
                     fmt::format("write {0}.{2} or {1}.{2}", shortened(files[0]),
                                 shortened(files[1]), shortened(name)));
  return true;
}

/// `tools.x` where tools.rob has no x, or `tools` alone.
void ExpressionChecker::report_no_such_name(std::string_view name, Place place) {
  const std::size_t point = name.find('.');
  const std::string_view file = name.substr(0, point);
  if (point == std::string_view::npos) {
    diagnostics_.error(code::kUnknownName, place,
                       fmt::format("{} is a file that is USEd here, not a value", shortened(file)),
                       fmt::format("name what is meant of it: {}.x", shortened(file)));
    return;
  }
  if (!scopes_.is_file(file)) {
    diagnostics_.error(code::kUnknownName, place,
                       fmt::format("{} is no file that is USEd here", shortened(file)),
                       "a routine is called by its name alone, or behind the name of its file");
    return;
  }
  const std::string_view wanted = name.substr(point + 1);
  diagnostics_.error(
      code::kUnknownName, place,
      fmt::format("{} declares no {}, or not yet", shortened(file), shortened(wanted)),
      did_you_mean(suggest(wanted, scopes_.names_in(file))));
}

}  // namespace rob::lang
