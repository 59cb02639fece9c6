#pragma once

#include <span>
#include <string_view>

#include "lang/values/types.h"

namespace rob::lang {

/// A type that the language has a word for.
struct NamedType {
  std::string_view name;  ///< BOOL, LENGTH, …
  Type type;
};

std::span<const NamedType> named_types();

/// The type of a word, in any case; null if this version has no such type.
const NamedType* named_type(std::string_view word);

}  // namespace rob::lang
