#include "runtime/run/text_report.h"

#include <fmt/format.h>

#include <optional>

#include "lang/text/visible.h"
#include "runtime/run/slow_places.h"
#include "runtime/words/units.h"

namespace rob::runtime {

using lang::on_one_line;

namespace {

std::string miss(const std::optional<double>& mm) {
  return mm ? fmt::format("{:.1f} mm", *mm) : "";
}

/// The planned time of a line or a run, s; empty where it was not foretold.
template <typename Result>
std::string planned(const Result& result) {
  return result.foretold ? fmt::format("{:.2f}", result.planned) : "";
}

std::string decides(const LineResult& line) {
  return line.decides ? fmt::format("{:.2f}", *line.decides) : "";
}

/// mm: what rounding leaves of an exact target.
constexpr double kNoMiss = 1e-9;

std::string remark(const LineResult& line) {
  std::string text = line.exact && line.miss_planned.value_or(1) < kNoMiss ? "   (STOP)" : "";
  if (line.count > 1) text += fmt::format("   {} times", line.count);
  return text;
}

std::string calling(const lang::CallSite& site) {
  switch (site.by) {
    case lang::CallSite::By::When:
      return "the handler of the WHEN in";
    case lang::CallSite::By::Start:
      return fmt::format("TASK {}, started in", site.routine);
    default:
      return fmt::format("{}, called in", site.routine);
  }
}

}  // namespace

std::string calls_text(const Problem& problem) {
  const std::vector<lang::CallSite>& calls = problem.calls;
  constexpr std::size_t kMost = 10;
  std::string text;
  for (std::size_t i = 0; i < calls.size() && i < kMost; ++i) {
    const lang::Place place = lang::tagged_place(calls[i].line);
    text += fmt::format("  in {} line {}", calling(calls[i]), place.line);
    text +=
        place.file == 0 ? "\n" : fmt::format(" of {}\n", on_one_line(problem.used[place.file - 1]));
  }
  if (calls.size() > kMost) text += fmt::format("  and {} calls more\n", calls.size() - kMost);
  return text;
}

namespace {

/// Above the first line of a USEd file stands its name.
std::string file_heading(const RunResult& result, const LineResult& line, int before) {
  const std::uint32_t file = lang::tagged_place(line.line).file;
  const bool first = lang::tagged_place(before).file != file;
  return file > 0 && first ? fmt::format("  {}\n", on_one_line(result.used[file - 1])) : "";
}

std::uint32_t line_number(const LineResult& line) { return lang::tagged_place(line.line).line; }

/// "line 7, 133 mm on: 12 of 200 mm/s; axis j4 speed near the wrist singularity".
std::string slow_places_text(const RunResult& result) {
  std::string text;
  for (const SlowPlace& place : result.slow_places) {
    const lang::Place line = lang::tagged_place(place.line);
    text += text.empty() ? "slowest: " : "         ";
    text += fmt::format("line {}{}, {}{} mm on: {} of {} mm/s; {}\n", line.line,
                        line.file == 0 ? "" : " of " + on_one_line(result.used[line.file - 1]),
                        place.corner ? "in a corner " : "", shown(place.at, 1),
                        shown(place.speed, 1), shown(place.asked, 1), cause_of(place));
  }
  return text;
}

}  // namespace

void put_check_table(const RunResult& result, const Put& put) {
  if (result.lines.empty()) return put("nothing moves\n");
  put("   line  starts   takes   decides at   corner missed by\n");
  int before = 0;
  std::size_t left = result.lines.size();
  for (const LineResult& line : result.lines) {
    std::string row =
        fmt::format("{:>6}  {:>6.2f}  {:>7.2f}  {:>9}  {:>11}{}", line_number(line), line.starts,
                    line.planned, decides(line), miss(line.miss_planned), remark(line));
    if (--left == 0) row = fmt::format("{:<47}   total {:.2f} s", row, result.planned);
    put(file_heading(result, line, before) + row.substr(0, row.find_last_not_of(' ') + 1) + "\n");
    before = line.line;
  }
  put(slow_places_text(result));
}

void put_run_table(const RunResult& result, const Put& put) {
  if (!result.lines.empty()) {
    put("                  takes            corner missed by\n"
        "   line  starts   planned measured   planned  measured\n");
  }
  int before = 0;
  for (const LineResult& line : result.lines) {
    const std::string row =
        fmt::format("{:>6}  {:>6.2f}  {:>8} {:>8.2f}  {:>8}  {:>8}{}", line_number(line),
                    line.starts, planned(line), line.measured, miss(line.miss_planned),
                    miss(line.miss_measured), remark(line));
    put(file_heading(result, line, before) + row.substr(0, row.find_last_not_of(' ') + 1) + "\n");
    before = line.line;
  }
  const std::string foretold = result.foretold ? "planned " + planned(result) + " s, " : "";
  put(fmt::format("{}: {}measured {:.2f} s, {} cycles, {} late, worst lateness {:.2f} ms\n",
                  result.status, foretold, result.measured, result.cycles, result.late_cycles,
                  result.worst_lateness * 1e3));
}

std::string problems_text(const RunResult& result, std::string_view source,
                          std::span<const lang::SourceFile> used) {
  std::string text;
  bool told = false;
  for (const lang::Diagnostic& finding : result.findings) {
    text += lang::render(finding, result.file, source, used);
    told = told || finding.severity == lang::Severity::Error;
  }
  if (result.findings_left_out > 0) {
    text += fmt::format("{}: and {} more\n", on_one_line(result.file), result.findings_left_out);
  }
  if (result.error && !told) {
    const Problem& e = *result.error;
    text += lang::render({lang::Severity::Error, e.code, e.place, e.message, e.help}, result.file,
                         source, used);
  }
  if (result.error) text += calls_text(*result.error);
  if (result.error && !told && !result.stands.empty()) {
    text += fmt::format("  the robot stands at {}\n", result.stands);
  }
  return text;
}

}  // namespace rob::runtime
