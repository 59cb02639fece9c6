#pragma once

#include <string_view>

namespace rob::runtime {

/// Where a prompt writes. Texts end with their line's end.
class Screen {
 public:
  virtual ~Screen() = default;
  virtual void result(std::string_view text) = 0;   ///< what was asked for: standard output
  virtual void message(std::string_view text) = 0;  ///< for people: standard error
};

}  // namespace rob::runtime
