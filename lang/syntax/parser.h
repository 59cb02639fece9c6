#pragma once

#include <cstddef>
#include <string_view>

#include "lang/syntax/ast.h"
#include "lang/text/diagnostic.h"

/// Text in, syntax tree out. All errors of the text are reported, each once; what could not be
/// read is left out of the tree, and the rest of the tree is sound, so that the checker can go
/// on with it. Not for the tick.
namespace rob::lang {

/// The most levels that blocks or expressions may be nested, and the greatest height of a tree.
/// [choice] far beyond what people write; the recursion of the checker, the compiler and the
/// destructors over a tree of this height fits any stack, sanitizers included.
inline constexpr int kMaxDepth = 200;

/// The most statements and expressions of one program; PlainMotions do not count. [choice] a tree
/// node takes some 200 bytes, so the greatest tree takes about 200 MB.
inline constexpr std::size_t kMaxNodes = 1'000'000;

/// The most names that one program declares: of variables, routines, parameters, fields and so on.
/// [choice] more than the variables of any program that people write; a declaration takes some
/// 1000 bytes in the tree and the checker, so all of them take at most about 65 MB.
inline constexpr std::size_t kMaxNames = 65'536;

/// After this many errors the rest of a text is not read: they are one mistake.
inline constexpr std::size_t kMaxSyntaxErrors = 1000;

/// Reads the statement of one line that begins at `offset`, at `place`, once more.
Block parse_line(std::string_view source, std::size_t offset, const Place& place,
                 Diagnostics& diagnostics);

/// Reads a program. Where a declaration could not be read in full its names are still declared,
/// with the type Unknown, so that their uses draw no further messages.
Program parse(std::string_view source, Diagnostics& diagnostics);

}  // namespace rob::lang
