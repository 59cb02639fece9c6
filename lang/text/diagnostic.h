#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rob::lang {

/// Where something stands in a source text. Lines and columns count from 1; a column is a
/// character (code point), not a byte. Line 0 means "the file as a whole", column 0 "the whole
/// line".
struct Place {
  std::uint32_t line = 0;
  std::uint32_t column = 0;
  std::uint32_t length = 1;
  std::uint32_t file = 0;  ///< 0: the program's own; n: the n-th of those that it USEs

  bool operator==(const Place&) const = default;
};

/// The most files that a program may USE, with those that they USE in turn. [choice] what the sign
/// bit and the lines leave of a tag.
inline constexpr std::uint32_t kMostUsedFiles = 31;

/// File and line of a place in one number, for the Machine and its reports; of the program's own
/// file it is the line. A file has less than 2^26 lines (source_text.h).
constexpr int line_tag(const Place& place) {
  return static_cast<int>((place.file << 26U) | place.line);
}
/// The place of a tag: a line as a whole.
constexpr Place tagged_place(int tag) {
  const auto bits = static_cast<std::uint32_t>(tag);
  return {bits & ((1U << 26U) - 1), 0, 0, bits >> 26U};
}

/// The order of the files, and in each of its text.
bool comes_before(const Place& a, const Place& b);

/// A text that a program USEs.
struct SourceFile {
  std::string name;      ///< for messages
  std::string identity;  ///< the same for the same file, whatever it is called
  std::string text;
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

/// Collects all that is found in a program, in the order of places.
class Diagnostics {
 public:
  /// A file with thousands of errors is one mistake: after this many the rest is only counted.
  static constexpr std::size_t kMost = 100;

  /// Message and help are kept as a terminal may safely show them.
  void add(Diagnostic diagnostic);
  void error(std::string_view code, Place place, std::string message, std::string help = "");
  void warning(std::string_view code, Place place, std::string message, std::string help = "");

  bool has_errors() const { return errors_ > 0; }
  std::size_t error_count() const { return errors_; }
  /// Whether an error has been found in these lines, of one file; after kMost errors it says yes.
  bool has_error_between(const Place& first, const Place& last) const;
  /// Sets the name of the next file that the program USEs.
  void name_file(std::string name) { file_names_.push_back(std::move(name)); }
  /// "line 5" for a message about `from`; "line 5 of tools.rob" where that is another file.
  std::string line_of(const Place& place, const Place& from) const;

  /// Sorted by place; equal places keep the order in which they were found.
  const std::vector<Diagnostic>& all() const { return all_; }
  std::size_t left_out() const { return left_out_; }

 private:
  std::vector<Diagnostic> all_;
  std::vector<std::string> file_names_;
  std::size_t errors_ = 0;
  std::size_t left_out_ = 0;
};

/// The text a person reads: "file:line:col: error[E101]: …", the source line (at most 200 bytes of
/// it) with a caret under the place, and the help. `source` may be empty.
std::string render(const Diagnostic& diagnostic, std::string_view file_name,
                   std::string_view source);

/// The same where the line that it is about is at hand.
std::string render_line(const Diagnostic& diagnostic, std::string_view file_name,
                        std::string_view line);

/// The same for a program that USEs files.
std::string render(const Diagnostic& diagnostic, std::string_view file_name,
                   std::string_view source, std::span<const SourceFile> used);

}  // namespace rob::lang
