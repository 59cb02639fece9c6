#include "runtime/prompt/file_commands.h"

#include <fmt/format.h>

#include <filesystem>
#include <limits>

#include "runtime/files/atomic_file.h"
#include "runtime/files/files.h"
#include "runtime/files/points_file.h"
#include "runtime/files/text_lines.h"
#include "runtime/prompt/line_diff.h"
#include "runtime/prompt/line_numbers.h"
#include "runtime/prompt/session.h"

namespace rob::runtime::command {

namespace {

std::string file_in(const Words& words, const std::string& otherwise) {
  if (words.empty()) return otherwise;
  const std::string& text = words.front();
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string::npos) return otherwise;
  return text.substr(first, text.find_last_not_of(" \t") + 1 - first);
}

/// The points that the program was taught with go beside it.
struct PointsBeside {
  std::string from;
  std::string to;
  bool needed = false;
};

PointsBeside points_beside(Session& session, const std::string& file, bool replace) {
  PointsBeside beside{session.points_file(), points_file_of(file)};
  if (beside.from.empty() || beside.from == beside.to) return beside;
  beside.needed = !load_points(beside.from, session.robot().robot()).points.empty();
  if (beside.needed && !replace && std::filesystem::exists(beside.to)) {
    throw FileError(fmt::format("'{}' is there already, with other points; :save! {} replaces them",
                                beside.to, file));
  }
  return beside;
}

/// The program and its points cannot be where the session writes its trace.
bool is_traced(Session& session, const std::string& file) {
  for (const std::string& name : {file, points_file_of(file)}) {
    if (!session.traces_to(name)) continue;
    session.fail(fmt::format("'{}' is the trace of this session", name), "name another file",
                 ExitCode::Usage);
    return true;
  }
  return false;
}

void save_as(Session& session, const Words& words, bool replace) {
  ProgramFile& own = session.workshop().file;
  const std::string file = file_in(words, own.name());
  if (file.empty())
    return session.fail("the program has no file yet", ":save FILE", ExitCode::Usage);
  if (is_traced(session, file) || !session.stands(":save")) return;
  const PointsBeside beside = points_beside(session, file, replace);
  own.save(file, session.workshop().program.text(), replace);
  if (beside.needed) save_file(beside.to, read_file(beside.from, kMostPointsBytes));
  session.follow_points(beside.to);
  session.screen().message(
      fmt::format("saved '{}', {} lines\n", file, session.workshop().program.size()));
}

/// The version that was named; none, and that is reported, if the program has no such one.
std::optional<std::string> named_version(Session& session, const Words& words) {
  const ProgramFile& file = session.workshop().file;
  const auto number =
      words.empty() ? std::nullopt : line_number(words[0], std::numeric_limits<int>::max());
  if (!number) {
    session.fail("which version?", ":archive lists them by number", ExitCode::Usage);
    return std::nullopt;
  }
  if (file.name().empty()) {
    session.fail("the program has no file yet, and no versions", ":save FILE");
    return std::nullopt;
  }
  return file.archive().text(file.name(), static_cast<int>(*number));
}

}  // namespace

void save(Session& session, const Words& words) { save_as(session, words, false); }

void save_over(Session& session, const Words& words) { save_as(session, words, true); }

void load(Session& session, const Words& words) {
  const std::string file = file_in(words, "");
  if (file.empty()) return session.fail(":load takes a file", "", ExitCode::Usage);
  if (is_traced(session, file) || !session.stands(":load")) return;
  Workshop& workshop = session.workshop();
  ProgramFile loaded = workshop.file;
  const std::string text = loaded.load(file);
  session.follow_points(points_file_of(file));
  workshop.file = loaded;
  workshop.program.set(text, fmt::format("'{}' loaded", file));
  workshop.breakpoints.clear();
  session.screen().message(fmt::format("loaded '{}', {} lines\n", file, workshop.program.size()));
}

void archive(Session& session, const Words&) {
  const ProgramFile& file = session.workshop().file;
  if (file.name().empty())
    return session.fail("the program has no file yet, and no versions", ":save FILE");
  const auto versions = file.archive().versions(file.name());
  for (const Archive::Version& one : versions)
    session.screen().result(fmt::format("{:>4}  {}  {} lines\n", one.number, one.saved, one.lines));
  if (versions.empty()) session.screen().message("there is no version before this one\n");
}

void compare(Session& session, const Words& words) {
  const auto text = named_version(session, words);
  if (!text) return;
  const auto before = split_lines(*text);
  const auto now = split_lines(session.workshop().program.text());
  for (const DiffLine& line : line_diff(before, now))
    session.screen().result(fmt::format("{} {}\n", line.sign, line.text));
}

void restore(Session& session, const Words& words) {
  const auto text = named_version(session, words);
  if (!text) return;
  ProgramText& program = session.workshop().program;
  program.set(*text, fmt::format("version {} restored", words[0]));
  session.screen().message(
      fmt::format("version {} is the program in memory, {} lines\n", words[0], program.size()));
}

}  // namespace rob::runtime::command
