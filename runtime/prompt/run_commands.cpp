#include "runtime/prompt/run_commands.h"

#include <fmt/format.h>

#include "lang/syntax/robot_name.h"
#include "lang/text/ascii.h"
#include "runtime/prompt/line_numbers.h"
#include "runtime/prompt/session.h"
#include "runtime/run/foretell.h"
#include "runtime/run/text_report.h"

namespace rob::runtime::command {

namespace {

/// Under the robot's own law: what the program asks for must be that.
bool suits(Session& session, const LoadedProgram& program) {
  const motion::RobotModel& robot = session.robot().robot();
  const auto declared = lang::declared_robot(program.source);
  if (declared && declared->name != robot.name) {
    session.fail(fmt::format("the program is for {}; this is {}", declared->name, robot.name),
                 fmt::format(":robot {}", declared->name));
    return false;
  }
  const auto& law = program.compilation.law;
  const bool paul = law && law->law == lang::TransitionLaw::Paul;
  if (!law || (paul ? motion::Law::Paul : motion::Law::LookAhead) == robot.law) return true;
  session.fail(fmt::format("the program asks for another law; {} is under {}", robot.name,
                           motion::law_name(robot.law)),
               paul ? ":law paul" : ":law lookahead");
  return false;
}

void tell_findings(Session& session, const LoadedProgram& program) {
  for (const lang::Diagnostic& finding : program.compilation.diagnostics.all())
    session.screen().message(
        lang::render(finding, program.file, program.source, program.compilation.used));
}

/// The program in memory; none if it cannot run, which has been reported then.
std::optional<LoadedProgram> compiled(Session& session, std::size_t from, bool tells) {
  const Workshop& workshop = session.workshop();
  if (workshop.program.empty()) {
    session.fail("the program in memory is empty", ":record keeps what is typed, or :load FILE");
    return std::nullopt;
  }
  const std::string& file = workshop.file.name();
  const motion::RobotModel& robot = session.robot().robot();
  LoadedProgram program =
      compile_program(file.empty() ? "program" : file, workshop.program.text(), robot,
                      session.points_file(), robot.law, static_cast<std::uint32_t>(from));
  refuse_missing_points(program);
  refuse_what_an_arm_cannot(program);
  if (tells || !program.runnable()) tell_findings(session, program);
  if (!program.runnable()) {
    session.fail("the program has errors; nothing moves");
    return std::nullopt;
  }
  if (tells && file.empty() && !program.compilation.chunk->persists.empty()) {
    session.fail("the program keeps variables between runs, beside its file; it has no file yet",
                 ":save FILE");
    return std::nullopt;
  }
  if (!suits(session, program)) return std::nullopt;
  return program;
}

/// Starts the program, from a line on; 0: all of it.
void start(Session& session, std::size_t from, bool steps) {
  auto program = compiled(session, from, true);
  if (!program) return;
  const std::uint32_t begins = program->compilation.begins;
  if (from != 0 && begins != from) {
    return session.fail(fmt::format("no statement begins in line {} outside of all blocks", from),
                        begins == 0 ? "" : fmt::format("the next one begins in line {}", begins));
  }
  HoldPoints& points = session.robot().channels().hold_points;
  points.hold_at_each(steps);
  std::size_t index = 0;
  for (const std::uint32_t line : session.workshop().breakpoints) points.hold_at(index++, line);
  while (index < HoldPoints::kMost) points.hold_at(index++, 0);
  session.run(std::move(*program));
}

void foretell_from_here(Session& session, bool tells) {
  if (!session.stands(tells ? ":check" : ":time")) return;
  auto program = compiled(session, 0, false);
  if (!program) return;
  const auto& last = session.robot().reports().last();
  if (last) program->robot.start = last->sample.reference.q;
  const RunResult result =
      foretell(*program, program->robot, {.override_share = session.robot().override_share()});
  if (tells || result.error)
    session.screen().message(problems_text(result, program->source, program->compilation.used));
  std::string table;
  put_check_table(result, [&](std::string_view piece) { table += piece; });
  session.screen().result(table);
}

}  // namespace

void run(Session& session, const Words& words) {
  std::size_t from = 0;
  if (!words.empty()) {
    const auto line = words.size() == 2 && words[0] == "from"
                          ? line_number(words[1], session.workshop().program.size())
                          : std::nullopt;
    if (!line)
      return session.fail(":run takes nothing, or from and a line of the program", ":run from 3",
                          ExitCode::Usage);
    from = *line;
  }
  if (session.stands(":run")) start(session, from, false);
}

/// Where a program is under way it goes on, otherwise one is begun.
void step(Session& session, const Words&) {
  const LiveRobot& robot = session.robot();
  if (robot.held() && !robot.idle()) {
    session.robot().channels().hold_points.hold_at_each(true);
    return session.leave_hold();
  }
  if (session.stands(":step")) start(session, 0, true);
}

void back(Session& session, const Words&) { session.go_back(); }

void breakpoints(Session& session, const Words& words) {
  auto& lines = session.workshop().breakpoints;
  const ProgramText& program = session.workshop().program;
  if (words.empty()) {
    for (const std::uint32_t line : lines)
      session.screen().result(
          fmt::format("{:>4}* {}\n", line, line <= program.size() ? program.line(line) : ""));
    if (lines.empty()) session.screen().message("there are no breakpoints\n");
    return;
  }
  const bool off = words[0] == "off";
  if (off && words.size() == 1) return lines.clear();
  const auto line = line_number(words[off ? 1 : 0], program.size());
  if (!line) {
    return session.fail(fmt::format("there is no line {}", words.back()),
                        ":list shows the lines of the program", ExitCode::Usage);
  }
  if (off) {
    lines.erase(static_cast<std::uint32_t>(*line));
  } else if (lines.size() == HoldPoints::kMost) {
    session.fail(fmt::format("there are {} breakpoints already", HoldPoints::kMost),
                 ":break off LINE takes one out");
  } else {
    lines.insert(static_cast<std::uint32_t>(*line));
  }
}

void check(Session& session, const Words&) { foretell_from_here(session, true); }

void time(Session& session, const Words&) { foretell_from_here(session, false); }

}  // namespace rob::runtime::command
