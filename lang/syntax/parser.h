#pragma once

#include <cstddef>
#include <string_view>

#include "lang/syntax/ast.h"
#include "lang/syntax/syntax_limits.h"
#include "lang/text/diagnostic.h"

/// Text in, syntax tree out. All errors of the text are reported, each once; what could not be
/// read is left out of the tree, and the rest of the tree is sound, so that the checker can go
/// on with it. Not for the tick.
namespace rob::lang {

struct SourceContext;

/// Reads a program. Where a declaration could not be read in full its names are still declared,
/// with the type Unknown, so that their uses draw no further messages.
Program parse(std::string_view source, Diagnostics& diagnostics);

/// The same of a text that is part of something, and that has passed check_source(). All that
/// `context` points to must outlive the call.
Program parse(std::string_view source, Diagnostics& diagnostics, const SourceContext& context);

/// Reads the statement of one line that begins at `offset`, at `place`, once more.
Block parse_line(std::string_view source, std::size_t offset, const Place& place,
                 Diagnostics& diagnostics);

}  // namespace rob::lang
