#include <algorithm>
#include <array>
#include <cstdlib>
#include <optional>
#include <sstream>

#include "tests/support/golden.h"

namespace rob::test {
namespace {

struct Directive {
  std::string_view opening;
  Expectation::Kind kind;
};

constexpr std::array kDirectives = std::to_array<Directive>({
    {"expect: ", Expectation::Kind::Call},
    {"expect error: ", Expectation::Kind::Error},
    {"expect warning: ", Expectation::Kind::Warning},
    {"expect failure: ", Expectation::Kind::Failure},
    {"expect refusal: ", Expectation::Kind::Refusal},
});

/// Where the comment of a line begins. A text in the program may hold "//" too, so what looks like
/// a directive goes first.
std::size_t comment_of(std::string_view text) {
  for (const std::string_view opening : {"// expect", "// given", "//"}) {
    if (const auto at = text.find(opening); at != std::string_view::npos) return at;
  }
  return std::string_view::npos;
}

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// "pick: 40 20 10" or "pick in pallet: 40 20 10", in mm.
bool read_point(const std::string& name, std::istringstream values, GoldenScript& script) {
  constexpr double kMillimetre = 1e-3;  // m
  constexpr std::string_view kIn = " in ";
  const auto in = name.find(kIn);
  lang::PointTable::Point point{name.substr(0, in), "", {}};
  if (in != std::string::npos) point.frame = name.substr(in + kIn.size());
  auto& [x, y, z] = point.pose.position;
  if (!(values >> x >> y >> z)) return false;
  for (double* const length : {&x, &y, &z}) *length *= kMillimetre;
  script.points.points.push_back(std::move(point));
  return true;
}

/// "lift_up: OFF ON", "answer: 7mm", "later: 3" or "point pick: 40 20 10".
bool read_given(std::string_view text, GoldenScript& script) {
  const auto colon = text.find(':');
  if (colon == std::string_view::npos) return false;
  const std::string name(trimmed(text.substr(0, colon)));
  std::istringstream values{std::string(text.substr(colon + 1))};
  constexpr std::string_view kPoint = "point ";
  if (name.starts_with(kPoint)) {
    return read_point(name.substr(kPoint.size()), std::move(values), script);
  }
  if (name == "answer") {
    script.answers.emplace_back(trimmed(text.substr(colon + 1)));
    return true;
  }
  if (name == "later") return static_cast<bool>(values >> script.later);
  for (std::string value; values >> value;) {
    char* end = nullptr;
    const double number = std::strtod(value.c_str(), &end);
    const std::string_view unit = end;
    const bool analog = end != value.c_str() && (unit == "V" || unit == "N" || unit == "Nm");
    if (!analog && value != "ON" && value != "OFF") return false;
    script.signals[name].push_back(analog ? number : value == "ON" ? 1 : 0);
  }
  return !script.signals[name].empty();
}

bool read_comment(std::string_view comment, int line, GoldenScript& script) {
  constexpr std::string_view kGiven = "given ";
  if (comment.starts_with(kGiven)) return read_given(comment.substr(kGiven.size()), script);
  for (const Directive& directive : kDirectives) {
    if (!comment.starts_with(directive.opening)) continue;
    script.expectations.push_back(
        {.kind = directive.kind,
         .line = line,
         .text = std::string(trimmed(comment.substr(directive.opening.size())))});
    return true;
  }
  return !comment.starts_with("expect");
}

/// "// given file tools: PROC a()": what is behind the colon; nothing if it is no such line.
std::optional<std::string_view> read_line_of_file(std::string_view text, int line,
                                                  GoldenScript& script) {
  constexpr std::string_view kFile = "// given file ";
  if (!trimmed(text).starts_with(kFile)) return std::nullopt;
  text.remove_prefix(text.find(kFile) + kFile.size());
  const auto colon = text.find(':');
  if (colon == std::string_view::npos) return std::nullopt;
  const std::string name(text.substr(0, colon));
  text.remove_prefix(std::min(colon + 2, text.size()));
  auto file = std::ranges::find(script.files, name, &GoldenScript::File::name);
  if (file == script.files.end()) file = script.files.insert(file, {name, "", {}});
  file->text += std::string(text) + "\n";
  file->lines.push_back(line);
  return text;
}

}  // namespace

GoldenScript read_golden(std::string_view source) {
  GoldenScript script;
  int line = 0;
  int line_of_code = 0;
  while (!source.empty()) {
    std::string_view text = source.substr(0, source.find('\n'));
    source.remove_prefix(std::min(text.size() + 1, source.size()));
    ++line;
    if (const auto of_file = read_line_of_file(text, line, script)) text = *of_file;
    const auto slashes = comment_of(text);
    if (!trimmed(text.substr(0, slashes)).empty()) line_of_code = line;
    if (slashes == std::string_view::npos) continue;
    if (!read_comment(trimmed(text.substr(slashes + 2)), line_of_code, script)) {
      script.mistakes.push_back("line " + std::to_string(line) + ": cannot read " +
                                std::string(text.substr(slashes)));
    }
  }
  return script;
}

}  // namespace rob::test
