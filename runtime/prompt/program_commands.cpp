#include "runtime/prompt/program_commands.h"

#include <fmt/format.h>

#include <algorithm>

#include "runtime/prompt/line_numbers.h"
#include "runtime/prompt/session.h"

namespace rob::runtime::command {

namespace {

/// The line that was named; none, and that is reported, if the program does not have it.
std::optional<std::size_t> named_line(Session& session, const std::string& word,
                                      std::size_t behind = 0) {
  const ProgramText& program = session.workshop().program;
  const auto line = line_number(word, program.size() + behind);
  if (line) return line;
  const std::string has = program.empty()
                              ? "the program in memory is empty"
                              : fmt::format("the program has the lines 1 to {}", program.size());
  session.fail(fmt::format("there is no line {}", word), has, ExitCode::Usage);
  return std::nullopt;
}

/// FROM and TO as they were named, FROM alone standing for itself.
struct Span {
  std::size_t first;
  std::size_t last;
};
std::optional<Span> named_span(Session& session, const Words& words) {
  const auto first = named_line(session, words[0]);
  if (!first) return std::nullopt;
  const auto last = words.size() > 1 ? named_line(session, words[1]) : first;
  if (!last) return std::nullopt;
  return Span{*first, std::max(*first, *last)};
}

void tell(Session& session, const std::string& what) { session.screen().message(what + "\n"); }

void show_lines(Session& session, Span span) {
  const Workshop& workshop = session.workshop();
  for (std::size_t i = span.first; i <= span.last; ++i) {
    const bool stops = workshop.breakpoints.contains(static_cast<std::uint32_t>(i));
    const std::string row =
        fmt::format("{:>4}{} {}", i, stops ? '*' : ' ', workshop.program.line(i));
    session.screen().result(row.substr(0, row.find_last_not_of(' ') + 1) + "\n");
  }
}

}  // namespace

void record(Session& session, const Words& words) {
  bool& records = session.workshop().records;
  if (!words.empty() && words[0] != "on" && words[0] != "off")
    return session.fail(":record takes on or off", "", ExitCode::Usage);
  records = words.empty() ? !records : words[0] == "on";
  session.screen().message(records ? "what is executed is kept as the program\n"
                                   : "nothing more is kept\n");
}

void list(Session& session, const Words& words) {
  const ProgramText& program = session.workshop().program;
  if (words.empty() && program.empty())
    return session.screen().message("the program in memory is empty\n");
  const auto span =
      words.empty() ? std::optional(Span{1, program.size()}) : named_span(session, words);
  if (span) show_lines(session, *span);
}

void edit(Session& session, const Words& words) {
  if (words.empty()) return session.fail(":edit takes a line and its text", "", ExitCode::Usage);
  const auto line = named_line(session, words[0]);
  if (!line) return;
  ProgramText& program = session.workshop().program;
  if (words.size() > 1) return tell(session, program.replace(*line, words[1]));
  session.propose(fmt::format(":edit {} {}", *line, program.line(*line)));
}

void insert(Session& session, const Words& words) {
  if (words.empty()) return session.fail(":insert takes a line and its text", "", ExitCode::Usage);
  const auto line = named_line(session, words[0], 1);
  if (line)
    tell(session, session.workshop().program.insert(*line, words.size() > 1 ? words[1] : ""));
}

void erase(Session& session, const Words& words) {
  if (words.empty())
    return session.fail(":delete takes a line, or the first and the last", "", ExitCode::Usage);
  if (const auto span = named_span(session, words))
    tell(session, session.workshop().program.erase(span->first, span->last));
}

void undo(Session& session, const Words&) {
  const auto done = session.workshop().program.undo();
  if (!done)
    return session.fail("nothing of the program is left to undo",
                        ":points undo takes back a point");
  if (done->renaming) session.rename_point(done->renaming->to, done->renaming->from);
  tell(session, "undone: " + done->what);
}

void redo(Session& session, const Words&) {
  const auto done = session.workshop().program.redo();
  if (!done) return session.fail("there is nothing to do again");
  if (done->renaming) session.rename_point(done->renaming->from, done->renaming->to);
  tell(session, "done again: " + done->what);
}

void begin_new(Session& session, const Words&) {
  session.workshop().program.set("", "another program begun");
  session.workshop().file.close();
  session.workshop().breakpoints.clear();
  tell(session, "the program in memory is empty");
}

namespace {

/// A PRINT a line for those that can be printed, "x = 20mm  // a length".
std::string printing(const std::vector<lang::DeclaredName>& names) {
  std::string entry;
  for (const lang::DeclaredName& name : names)
    entry += fmt::format("PRINT \"{0} = \", {0}, \"  // {1}\"\n", name.name, name.type);
  return entry;
}

}  // namespace

/// The language itself writes the values. A value that it cannot print is left out.
void variables(Session& session, const Words&) {
  if (!session.stands(":vars")) return;
  using Kind = lang::DeclaredName::Kind;
  std::vector<lang::DeclaredName> names;
  std::ranges::copy_if(session.text().names(), std::back_inserter(names), [](const auto& name) {
    return name.kind == Kind::Variable || name.kind == Kind::Const;
  });
  if (names.empty()) return session.screen().message("no variable has been declared\n");
  std::ranges::sort(names, {}, &lang::DeclaredName::name);
  const auto unprintable = [&](const lang::DeclaredName& name) {
    const bool prints = session.text().compile(printing({name})).runnable();
    if (!prints) session.screen().result(fmt::format("{}  // {}\n", name.name, name.type));
    return !prints;
  };
  LoadedProgram all = session.text().compile(printing(names));
  if (!all.runnable()) {
    std::erase_if(names, unprintable);
    all = session.text().compile(printing(names));
  }
  if (all.runnable()) session.carry_out_aside(std::move(all));
}

}  // namespace rob::runtime::command
