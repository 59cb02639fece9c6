#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "lang/syntax/ast.h"
#include "lang/syntax/outline.h"
#include "lang/text/text_parts.h"

namespace rob::lang {

/// A file that a text USEs, read already.
struct Import {
  std::string name;        ///< as USE writes it
  std::uint32_t line = 0;  ///< of the USE
  std::uint32_t file = 0;
  Program* program = nullptr;
};

/// The program around a text, and what of it is known before it is parsed.
struct SourceContext {
  std::uint32_t file = 0;
  TextParts parts{};                 ///< of the text
  const Outline* outline = nullptr;  ///< of the text
  std::vector<Import> imports{};
  std::size_t nodes = 0;          ///< of the files that were read before
  std::size_t names = 0;          ///< the same
  std::size_t array_lengths = 0;  ///< the same
  /// From this line on expressions stand alone, and are printed; 0: they do nowhere.
  std::uint32_t printed_from = 0;
  /// The number of all of them.
  std::shared_ptr<TypeTable> types = std::make_shared<TypeTable>();
};

}  // namespace rob::lang
