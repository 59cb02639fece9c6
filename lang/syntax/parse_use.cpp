#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "lang/syntax/parser_impl.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"

/// The parser's rule for USE, and for names of other files.
namespace rob::lang {

// decl = "USE" IDENT eol .
void Parser::use_statement(Block& block) {
  const Place place = current_.place;
  if (!open_blocks_.empty()) {
    report(code::kOnlyTopLevel, place, "USE can stand only outside all blocks",
           fmt::format("write it before the {} of line {}", spelling(open_blocks_.front().opener),
                       open_blocks_.front().place.line));
  }
  advance();
  if (!at(TokenKind::Word)) {
    fail_here(code::kNameExpected,
              fmt::format("the name of a file expected after USE, not {}", described(current_)),
              "USE tools brings in what tools.rob declares");
  }
  Use use;
  use.name = current_.text;
  advance();
  if (at(TokenKind::Dot)) {
    fail_here(code::kLineEndExpected, "USE takes the name of a file without its ending",
              fmt::format("USE {}", shortened(use.name)));
  }
  if (const Import* const import = import_named(use.name)) {
    use.file = import->file;
    use.declarations = std::exchange(import->program->statements, {});
  }
  add(block, place, std::move(use));
}

const Import* Parser::import_named(std::string_view name) const {
  const auto found = std::ranges::find_if(
      imports_, [&](const Import& import) { return same_word(import.name, name); });
  return found == imports_.end() ? nullptr : &*found;
}

/// `tools.grip`, where `tools` is a USEd file: one name, with its point.
bool Parser::at_foreign_name() const {
  return at(TokenKind::Word) && next_.kind == TokenKind::Dot && outline_.names_file(current_.text);
}

std::string Parser::foreign_name() {
  std::string name(current_.text);
  advance();
  advance();
  if (!at(TokenKind::Word)) {
    fail_here(code::kNameExpected, fmt::format("a name of {} expected after '.', not {}",
                                               shortened(name), described(current_)));
  }
  name += '.';
  name += current_.text;
  advance();
  return name;
}

/// The detail of a type that one of the USEd files declares; null if none does, or this text.
const TypeDetail* Parser::imported_type(std::string_view name, const Place& place,
                                        const TypeTable::Named& types) {
  const std::string key = to_upper(name);
  if (outline_.types.contains(key)) return nullptr;
  const Import* found = nullptr;
  for (const Import& import : imports_) {
    if (!types.contains({import.file, key})) continue;
    if (found != nullptr) {
      report(code::kAmbiguousName, place,
             fmt::format("{} is a type of {} and of {}", shortened(name), shortened(found->name),
                         shortened(import.name)),
             "rename one of them");
      break;
    }
    found = &import;
  }
  return found == nullptr ? nullptr : types.at({found->file, key});
}

}  // namespace rob::lang
