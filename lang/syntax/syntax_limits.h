#pragma once

#include <cstddef>

/// How much of a text the parser reads.
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

}  // namespace rob::lang
