#include "motion/robots/table_reader.h"

#include <algorithm>
#include <cstdio>
#include <stdexcept>

#include "base/nearest_words.h"
#include "motion/robots/quoted.h"
#include "motion/robots/robot_file_error.h"

namespace rob::motion {

namespace {

constexpr std::size_t kLongestName = 32;

std::string number_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

std::string in_quotes(const std::vector<std::string_view>& words) {
  std::string text;
  for (const std::string_view word : words) {
    if (!text.empty()) text += ", ";
    text += quoted(word);
  }
  return text;
}

/// The remedy for an unknown word.
std::string remedy(std::string_view word, const std::vector<std::string_view>& known) {
  const std::string_view close = suggest(word, known);
  if (close.empty()) return "; known are " + in_quotes(known);
  return "; did you mean " + quoted(close) + "?";
}

bool is_name(std::string_view text) {
  const auto letter = [](char c) { return c >= 'a' && c <= 'z'; };
  const auto later = [&](char c) { return letter(c) || (c >= '0' && c <= '9') || c == '_'; };
  return !text.empty() && text.size() <= kLongestName && letter(text.front()) &&
         std::all_of(text.begin(), text.end(), later);
}

}  // namespace

void fail_in_file(std::string_view file, const toml::source_position& place,
                  const std::string& message) {
  throw RobotFileError(std::string(file) + ":" + std::to_string(place.line) + ":" +
                       std::to_string(place.column) + ": " + message);
}

toml::table parsed_toml(std::string_view text, std::string_view file) {
  try {
    return toml::parse(text, file);
  } catch (const toml::parse_error& error) {
    fail_in_file(file, error.source().begin, std::string(error.description()));
  }
}

TableReader::TableReader(const toml::table& table, std::string_view file, std::string what,
                         std::vector<std::string_view> keys)
    : table_(&table), file_(file), what_(std::move(what)) {
  for (const auto& [key, value] : table) {
    if (std::find(keys.begin(), keys.end(), key.str()) != keys.end()) continue;
    const std::string place = what_.empty() ? "" : " in " + what_;
    fail_at(key.source().begin,
            "unknown key " + quoted(key.str()) + place + remedy(key.str(), keys));
  }
}

std::string TableReader::text(std::string_view key) const {
  const toml::node& node = need(key);
  const auto* value = node.as_string();
  if (value == nullptr) fail(key, "must be a text in quotation marks");
  return value->get();
}

std::string TableReader::name(std::string_view key) const {
  const std::string value = text(key);
  if (!is_name(value)) {
    fail(key, quoted(value) +
                  " is no name; write a small letter, then small letters, digits or _, at most " +
                  std::to_string(kLongestName));
  }
  return value;
}

std::string TableReader::path(std::string_view key) const {
  const std::string written = text(key);
  if (written.empty()) fail(key, "must be the name of a file");
  if (written.front() == '/') return written;
  return file_.substr(0, file_.rfind('/') + 1) + written;  // 0 where there is none
}

std::string TableReader::where(std::string_view key) const {
  const toml::source_position& place = need(key).source().begin;
  return file_ + ":" + std::to_string(place.line) + ":" + std::to_string(place.column) + ": ";
}

double TableReader::quantity(std::string_view key, Quantity quantity, Range range) const {
  return quantity_in(need(key), key, quantity, range);
}

double TableReader::quantity_in(const toml::node& node, std::string_view key, Quantity quantity,
                                Range range) const {
  const auto* written = node.as_string();
  if (written == nullptr) {
    const std::string unit(si_unit(quantity));
    fail_in(node, key, "must be a number with its unit, in quotation marks, as \"1 " + unit + "\"");
  }
  double value = 0;
  try {
    value = parse_quantity(written->get(), quantity);
  } catch (const std::invalid_argument& problem) {
    fail_in(node, key, problem.what());
  }
  if (value >= range.low && value <= range.high) return value;
  fail_in(node, key,
          quoted(written->get()) + " is out of range; it must lie from " + number_text(range.low) +
              " to " + number_text(range.high) + " " + std::string(si_unit(quantity)));
}

const toml::array& TableReader::list(std::string_view key, std::size_t count) const {
  const auto* values = need(key).as_array();
  if (values == nullptr || values->size() != count)
    fail(key, "must be a list of " + std::to_string(count) + ", as [first, second, …]");
  return *values;
}

std::vector<double> TableReader::quantities(std::string_view key, Quantity quantity, Range range,
                                            std::size_t count) const {
  std::vector<double> values;
  for (const toml::node& node : list(key, count))
    values.push_back(quantity_in(node, key, quantity, range));
  return values;
}

std::vector<double> TableReader::signs(std::string_view key, std::size_t count) const {
  std::vector<double> values;
  for (const toml::node& node : list(key, count)) {
    const auto* sign = node.as_integer();
    if (sign == nullptr || (sign->get() != 1 && sign->get() != -1))
      fail_in(node, key, "each must be 1 or -1");
    values.push_back(static_cast<double>(sign->get()));
  }
  return values;
}

double TableReader::number(std::string_view key, Range range) const {
  return number_in(need(key), key, range);
}

std::vector<double> TableReader::numbers(std::string_view key, Range range,
                                         std::size_t count) const {
  std::vector<double> values;
  for (const toml::node& node : list(key, count)) values.push_back(number_in(node, key, range));
  return values;
}

double TableReader::number_in(const toml::node& node, std::string_view key, Range range) const {
  const auto value = node.value<double>();
  if (value && *value >= range.low && *value <= range.high) return *value;
  fail_in(node, key,
          "must be a number from " + number_text(range.low) + " to " + number_text(range.high) +
              ", without quotation marks");
}

int TableReader::integer(std::string_view key, int low, int high) const {
  const auto* value = need(key).as_integer();
  if (value != nullptr && value->get() >= low && value->get() <= high)
    return static_cast<int>(value->get());
  fail(key, "must be a whole number from " + std::to_string(low) + " to " + std::to_string(high));
}

int TableReader::integer_or(std::string_view key, int low, int high, int fallback) const {
  return table_->contains(key) ? integer(key, low, high) : fallback;
}

bool TableReader::flag_or(std::string_view key, bool fallback) const {
  if (!table_->contains(key)) return fallback;
  const auto* value = need(key).as_boolean();
  if (value == nullptr) fail(key, "must be true or false, without quotation marks");
  return value->get();
}

int TableReader::choice(std::string_view key, const std::vector<std::string_view>& words) const {
  const std::string value = text(key);
  const auto found = std::find(words.begin(), words.end(), value);
  if (found != words.end()) return static_cast<int>(found - words.begin());
  fail(key, quoted(value) + " is not known" + remedy(value, words));
}

TableReader TableReader::table(std::string_view key, std::vector<std::string_view> keys) const {
  const auto* child = need(key).as_table();
  if (child == nullptr) fail(key, "must be a table");
  return TableReader(*child, file_, title(key), std::move(keys));
}

std::vector<TableReader> TableReader::tables(std::string_view key,
                                             const std::vector<std::string_view>& keys) const {
  std::vector<TableReader> readers;
  const toml::node* node = table_->get(key);
  if (node == nullptr) return readers;
  const auto* array = node->as_array();
  if (array == nullptr) fail(key, "must be written as tables [[" + std::string(key) + "]]");
  for (const toml::node& element : *array) {
    const auto* child = element.as_table();
    if (child == nullptr) fail(key, "must be written as tables [[" + std::string(key) + "]]");
    readers.emplace_back(*child, file_, std::string(key) + " " + std::to_string(readers.size() + 1),
                         keys);
  }
  return readers;
}

void TableReader::fail(std::string_view key, const std::string& problem) const {
  const toml::node* node = table_->get(key);
  fail_in(node == nullptr ? *table_ : *node, key, problem);
}

void TableReader::fail_in(const toml::node& node, std::string_view key,
                          const std::string& problem) const {
  fail_at(node.source().begin, title(key) + ": " + problem);
}

const toml::node& TableReader::need(std::string_view key) const {
  const toml::node* node = table_->get(key);
  if (node == nullptr) fail(key, "is missing");
  return *node;
}

void TableReader::fail_at(const toml::source_position& place, const std::string& message) const {
  fail_in_file(file_, place, message);
}

std::string TableReader::title(std::string_view key) const {
  return std::string(key) + (what_.empty() ? "" : " of " + what_);
}

}  // namespace rob::motion
