#include "lang/syntax/parser.h"

#include "lang/syntax/expression_parser.h"
#include "lang/syntax/outline.h"
#include "lang/syntax/source_context.h"
#include "lang/syntax/statement_parser.h"
#include "lang/syntax/text_names.h"
#include "lang/syntax/token_reader.h"
#include "lang/syntax/tree_builder.h"
#include "lang/syntax/type_parser.h"
#include "lang/text/codes.h"
#include "lang/text/source_text.h"

/// Recursive descent: an object for each part of the grammar, one function a grammar rule, the rule
/// above it.
namespace rob::lang {

namespace {

/// Reads a text from its beginning to its end, or one statement of it.
class TextParser {
 public:
  TextParser(std::string_view source, Diagnostics& diagnostics, const SourceContext& context,
             PlainMotionsAs plain_motions)
      : tokens_(source, diagnostics, context.file, context.parts),
        tree_(tokens_, context.nodes),
        names_(tokens_, context),
        expressions_(tokens_, tree_, names_),
        types_(tokens_, tree_, names_, expressions_, context),
        printed_from_(context.printed_from),
        statements_(tokens_, tree_, names_, expressions_, types_, plain_motions) {}

  Program program();
  Block line_at(std::size_t offset, const Place& place);

 private:
  void items(Program& program);

  TokenReader tokens_;
  TreeBuilder tree_;
  TextNames names_;
  ExpressionParser expressions_;
  TypeParser types_;
  std::uint32_t printed_from_;
  StatementParser statements_;
};

Program TextParser::program() {
  Program program;
  try {
    items(program);
  } catch (const SyntaxError&) {
    // Reported; what stands after END is not read.
  } catch (const GiveUp&) {
    program.end = tokens_.place();
    program.whole = false;
  }
  statements_.finish(program);
  types_.finish(program);
  program.nodes = tree_.nodes();
  program.names = names_.count();
  return program;
}

// program = { NL } { item } [ "END" { NL } ] .
void TextParser::items(Program& program) {
  tokens_.begin();
  tokens_.skip_line_ends();
  while (!tokens_.at(TokenKind::EndOfFile) && !tokens_.at(Keyword::End)) {
    if (printed_from_ > 0 && tokens_.place().line >= printed_from_) {
      statements_.value_alone(program.statements);
    } else {
      statements_.statement(program.statements);
    }
    tokens_.skip_line_ends();
  }
  program.end = tokens_.place();
  // A file without END ends as if END stood on the line after its last one.
  if (tokens_.at(TokenKind::EndOfFile) && tokens_.place().column > 1) {
    program.end = Place{tokens_.place().line + 1, 1, 1, tokens_.place().file};
  }
  if (tokens_.at(Keyword::End)) tokens_.advance();
  tokens_.skip_line_ends();
  if (!tokens_.at(TokenKind::EndOfFile)) {
    tokens_.fail_here(code::kTextBehindEnd, "nothing may stand after END",
                      "END ends the whole program; blocks end with ENDIF, ENDWHILE, ENDFOR");
  }
}

Block TextParser::line_at(std::size_t offset, const Place& place) {
  Block block;
  try {
    tokens_.begin_at(offset, place);
    statements_.statement(block);
  } catch (const GiveUp&) {
    // So many errors are reported that no more is read.
  }
  return block;
}

}  // namespace

Program parse(std::string_view source, Diagnostics& diagnostics) {
  if (!check_source(source, diagnostics)) return {};
  const Outline outline = outline_of(source);
  return parse(source, diagnostics, {.outline = &outline});
}

Program parse(std::string_view source, Diagnostics& diagnostics, const SourceContext& context) {
  Program program = TextParser(source, diagnostics, context, PlainMotionsAs::Numbers).program();
  program.types = context.types;
  if (program.end.file == 0 && program.statements.empty() && program.routines.empty() &&
      !diagnostics.has_errors()) {
    diagnostics.warning(code::kEmptyProgram, Place{0, 0, 1}, "the program has no statement");
  }
  return program;
}

Block parse_line(std::string_view source, std::size_t offset, const Place& place,
                 Diagnostics& diagnostics) {
  const Outline nothing;
  return TextParser(source, diagnostics, {.file = place.file, .outline = &nothing},
                    PlainMotionsAs::Trees)
      .line_at(offset, place);
}

}  // namespace rob::lang
