#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rob::test {

/// A file of the repository, as text.
struct SourceFile {
  std::string path;  ///< from the root of the project, with '/'
  std::string text;
};

struct Include {
  std::string path;     ///< "motion/space/pose.h", "fmt/format.h"
  bool angled = false;  ///< <…>: not of this project
};

/// The text of a file of the repository, whose path counts from the root. Throws
/// std::runtime_error where it cannot be read.
std::string text_of(const std::string& path);

/// The lines of a page of the manual, without its shown programs and commands.
std::vector<std::string> prose_of(const std::string& page);

/// What is compiled in these folders of the root and below them: .h, .cpp, and what these include
/// in pieces, .def and .inc. In the order of their paths.
std::vector<SourceFile> sources_in(const std::vector<std::string>& folders);

/// The folders of the product that are there.
std::vector<std::string> layer_folders();

/// The sources of the product.
std::vector<SourceFile> layers();

/// The includes of a text, in its order, wherever they stand.
std::vector<Include> includes_of(std::string_view text);

}  // namespace rob::test
