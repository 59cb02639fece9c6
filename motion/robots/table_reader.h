#pragma once

#include <toml++/toml.h>

#include <string>
#include <string_view>
#include <vector>

#include "motion/robots/quantity.h"

namespace rob::motion {

/// The range in which a value must lie, both ends included. SI.
struct Range {
  double low = 0;
  double high = 0;
};

/// Reads one table of a robot file strictly: every key is known and of its type, every value within
/// its range. Everything that is wrong throws RobotFileError with file, line and column.
class TableReader {
 public:
  /// `what`: how messages call the table ("axis 2"); empty for the whole file. `keys`: all it may
  /// have; any other throws at once, with a suggestion.
  TableReader(const toml::table& table, std::string_view file, std::string what,
              std::vector<std::string_view> keys);

  bool has(std::string_view key) const { return table_->contains(key); }
  std::string text(std::string_view key) const;
  /// A name as programs write it: a small letter, then small letters, digits and _; at most 32.
  std::string name(std::string_view key) const;
  /// The name of a file, which stands beside the robot's unless it begins with a /.
  std::string path(std::string_view key) const;
  double quantity(std::string_view key, Quantity quantity, Range range) const;
  /// [value, value, …], `count` of them.
  std::vector<double> quantities(std::string_view key, Quantity quantity, Range range,
                                 std::size_t count) const;
  /// [1, -1, …], `count` of them.
  std::vector<double> signs(std::string_view key, std::size_t count) const;
  /// A number without a unit.
  double number(std::string_view key, Range range) const;
  /// [number, number, …], `count` of them.
  std::vector<double> numbers(std::string_view key, Range range, std::size_t count) const;
  int integer(std::string_view key, int low, int high) const;
  /// `fallback` where the key is missing.
  int integer_or(std::string_view key, int low, int high, int fallback) const;
  /// true or false; `fallback` where the key is missing.
  bool flag_or(std::string_view key, bool fallback) const;
  /// Which of `words` it is.
  int choice(std::string_view key, const std::vector<std::string_view>& words) const;
  TableReader table(std::string_view key, std::vector<std::string_view> keys) const;
  /// The tables [[key]]; none if the key is missing.
  std::vector<TableReader> tables(std::string_view key,
                                  const std::vector<std::string_view>& keys) const;

  /// From now on messages call the table so.
  void rename(std::string what) { what_ = std::move(what); }
  /// "file:line:column: " of the value of `key`.
  std::string where(std::string_view key) const;
  /// Throws: `problem` at the value of `key`, or at the table if it has none.
  [[noreturn]] void fail(std::string_view key, const std::string& problem) const;

 private:
  const toml::node& need(std::string_view key) const;
  const toml::array& list(std::string_view key, std::size_t count) const;
  double number_in(const toml::node& node, std::string_view key, Range range) const;
  double quantity_in(const toml::node& node, std::string_view key, Quantity quantity,
                     Range range) const;
  [[noreturn]] void fail_in(const toml::node& node, std::string_view key,
                            const std::string& problem) const;
  [[noreturn]] void fail_at(const toml::source_position& place, const std::string& message) const;
  std::string title(std::string_view key) const;

  const toml::table* table_;
  std::string file_;
  std::string what_;
};

/// The tables of a text. Throws RobotFileError for what is no TOML.
toml::table parsed_toml(std::string_view text, std::string_view file);

/// Throws RobotFileError "file:line:column: message".
[[noreturn]] void fail_in_file(std::string_view file, const toml::source_position& place,
                               const std::string& message);

}  // namespace rob::motion
