#include "runtime/prompt/session_text.h"

#include <utility>

#include "lang/text/ascii.h"
#include "lang/text/codes.h"
#include "runtime/files/text_lines.h"
#include "runtime/words/signature.h"

namespace rob::runtime {

namespace {

/// The name of the text in messages.
constexpr const char* kName = "prompt";

/// No word that a value could begin with.
bool is_unknown(const lang::Diagnostic& finding) {
  return finding.code == lang::code::kUnknownName || finding.code == lang::code::kUnknownFunction ||
         finding.code == lang::code::kValueExpected;
}

bool suggests(const lang::Diagnostic& finding) { return finding.help.starts_with("did you mean"); }

/// The message about a line that is no statement, or none that may be there.
bool may_be_value(const lang::Diagnostic& finding) {
  namespace code = lang::code;
  return finding.code == code::kUnknownStatement || finding.code == code::kStatementExpected ||
         finding.code == code::kAssignExpected || finding.code == code::kRoutineMisused;
}

}  // namespace

bool may_be_mended_below(const lang::Diagnostic& finding) {
  namespace code = lang::code;
  return finding.code == code::kUnclosedBlock || finding.code == code::kRescueMissing;
}

std::size_t find_word(std::string_view line, std::string_view word, std::size_t begin) {
  for (std::size_t i = begin; i < line.size();) {
    if (!lang::in_word(line[i])) {
      ++i;
      continue;
    }
    std::size_t end = i;
    while (end < line.size() && lang::in_word(line[end])) ++end;
    if (lang::same_word(line.substr(i, end - i), word)) return i;
    i = end;
  }
  return std::string_view::npos;
}

SessionText::SessionText(motion::RobotModel robot, std::string points_file)
    : robot_(std::move(robot)),
      signature_(signature_of(robot_)),
      points_file_(std::move(points_file)),
      sources_(kName) {}

LoadedProgram SessionText::compile(std::string_view entry, Knowing knowing, As as) const {
  return compile_entry(entries_, std::string(entry), robot_, signature_, points_file_, sources_,
                       knowing, as);
}

/// An expression with a mistake in it is one, too, unless its first word is unknown and a statement
/// may have been meant.
SessionText::Reading SessionText::read(std::string_view entry) const {
  Reading statements{compile(entry)};
  const auto& found = statements.compiled.compilation.diagnostics.all();
  if (statements.compiled.runnable() || found.empty() || !may_be_value(found.front()) ||
      found.front().place.line != line())
    return statements;
  Reading value{compile(entry, Knowing::Needed, As::Expression), As::Expression};
  if (value.compiled.runnable()) return value;
  const lang::Diagnostic& wrong = value.compiled.compilation.diagnostics.all().front();
  const bool in_first_word =
      wrong.place.line == line() && wrong.place.column <= entry.find_first_not_of(" \t") + 1;
  return in_first_word && is_unknown(wrong) && (!suggests(wrong) || suggests(found.front()))
             ? statements
             : value;
}

/// The missing part may still come.
std::string SessionText::wrong_in_open(std::string_view block, std::uint32_t first) const {
  const LoadedProgram compiled = compile(block);
  std::vector<std::string> lines = split_lines(block);
  std::string told;
  for (const lang::Diagnostic& one : compiled.compilation.diagnostics.all()) {
    const lang::Place& place = one.place;
    const bool here =
        place.file == 0 && place.line >= line() + first && place.line < line() + lines.size();
    if (!here || one.severity != lang::Severity::Error || may_be_mended_below(one)) continue;
    told += lang::render_line(one, kName, lines[place.line - line()]);
  }
  return told;
}

void SessionText::keep(std::string_view entry, const LoadedProgram& compiled) {
  entries_.keep(entry, compiled.compilation);
  for (const motion::Obstacle& obstacle : compiled.obstacles)
    signature_.declared.push_back(obstacle.name);
  add_typed(entry);
}

std::vector<std::string> SessionText::bodies() const {
  std::vector<std::string> bodies{"gripper", "part"};
  for (const auto* const some : {&signature_.bodies, &signature_.obstacles, &signature_.declared})
    bodies.insert(bodies.end(), some->begin(), some->end());
  return bodies;
}

void SessionText::pass_line(std::string_view line) {
  entries_.pass_line();
  add_typed(line);
}

void SessionText::add_typed(std::string_view text) {
  begins_.push_back(typed_.size());
  for (std::size_t at = text.find('\n'); at != std::string_view::npos; at = text.find('\n', at + 1))
    begins_.push_back(typed_.size() + at + 1);
  typed_.append(text) += '\n';
}

std::string_view SessionText::typed(std::uint32_t line) const {
  if (line == 0 || line > begins_.size()) return {};
  const std::string_view rest = std::string_view(typed_).substr(begins_[line - 1]);
  return rest.substr(0, rest.find('\n'));
}

std::string SessionText::rendered(const lang::Diagnostic& finding,
                                  const std::vector<lang::SourceFile>& used) const {
  if (finding.place.file != 0) return lang::render(finding, kName, "", used);
  return lang::render_line(finding, kName, typed(finding.place.line));
}

}  // namespace rob::runtime
