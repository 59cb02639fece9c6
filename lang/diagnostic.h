#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rob::lang {

/// Where something stands in a source text. Lines and columns count from 1; a column is a
/// character (code point), not a byte. Line 0 means "the file as a whole", column 0 "the whole
/// line".
struct Place {
  std::uint32_t line = 0;
  std::uint32_t column = 0;
  std::uint32_t length = 1;

  bool operator==(const Place&) const = default;
};

enum class Severity { Error, Warning, Note };

/// One thing that is wrong or doubtful in a program: where, what, and how to mend it.
struct Diagnostic {
  Severity severity = Severity::Error;
  std::string code;  ///< "E101"; the list stands in codes.def
  Place place;
  std::string message;  ///< one line, no full stop
  std::string help;     ///< the remedy, or empty
};

/// Collects all that is found in one file, in the order of places.
class Diagnostics {
 public:
  /// A file with thousands of errors is one mistake: after this many the rest is only counted.
  static constexpr std::size_t kMost = 100;

  void add(Diagnostic diagnostic);
  void error(std::string_view code, Place place, std::string message, std::string help = "");
  void warning(std::string_view code, Place place, std::string message, std::string help = "");

  bool has_errors() const { return errors_ > 0; }
  std::size_t error_count() const { return errors_; }
  /// Sorted by place; equal places keep the order in which they were found.
  const std::vector<Diagnostic>& all() const { return all_; }
  std::size_t left_out() const { return left_out_; }

 private:
  std::vector<Diagnostic> all_;
  std::size_t errors_ = 0;
  std::size_t left_out_ = 0;
};

/// The text a person reads: "file:line:col: error[E101]: …", the source line (at most 200 bytes of
/// it) with a caret under the place, and the help. `source` may be empty.
std::string render(const Diagnostic& diagnostic, std::string_view file_name,
                   std::string_view source);

}  // namespace rob::lang
