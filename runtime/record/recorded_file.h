#pragma once

#include <string>

namespace rob::runtime {

/// A file inside a record: its name there, what it is (a media type), and its text.
struct RecordedFile {
  std::string name;
  std::string media_type;
  std::string text;
};

}  // namespace rob::runtime
