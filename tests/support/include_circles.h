#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tests/support/source_files.h"

namespace rob::test {

/// The module of a file: its path without the extension. A header and what has its name, .cpp, .inc
/// or .def, are one.
std::string module_of(std::string_view path);

/// The greatest sets of modules in which each includes each other, directly or through others of
/// the set. Sets of one are no circles. Modules and sets are in the order of their names.
std::vector<std::vector<std::string>> include_circles(const std::vector<SourceFile>& files);

}  // namespace rob::test
