#include "runtime/cli/pictures.h"

#include <fmt/format.h>

#include <cstdint>
#include <set>
#include <string>

#include "runtime/cli/program_files.h"
#include "runtime/files/atomic_file.h"
#include "runtime/files/files.h"
#include "runtime/pictures/path_svg.h"
#include "runtime/pictures/report_page.h"
#include "runtime/run/output_file.h"
#include "runtime/words/version.h"

namespace rob::runtime {

namespace {

bool is_file(const std::string& output) { return !output.empty() && output != kStandardInput; }

/// Two of them would write over each other.
void refuse_same_outputs(const Options& options) {
  const std::vector<std::pair<const char*, const std::string*>> outputs = {
      {"--trace", &options.trace},
      {"--path", &options.path},
      {"--report", &options.report},
      {"--mcap", &options.mcap},
      {"--svg", &options.svg}};
  for (std::size_t i = 0; i < outputs.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (is_file(*outputs[i].second) && is_file(*outputs[j].second) &&
          same_file(*outputs[i].second, *outputs[j].second))
        throw UsageError(fmt::format("{} and {} name the same file, '{}'; name two files",
                                     outputs[j].first, outputs[i].first, *outputs[i].second));
}

}  // namespace

Pictures::Pictures(const Options& options, const std::vector<LoadedProgram>& programs)
    : options_(options) {
  refuse_overwriting_inputs("--report", options.report, options, programs);
  if (is_file(options.svg)) refuse_overwriting_inputs("--svg", options.svg, options, programs);
  refuse_same_outputs(options);
  if (!options.report.empty()) try_saving(options.report);
  if (is_file(options.svg)) try_saving(options.svg);
}

std::function<void(const Snapshot&)> Pictures::listener(const motion::RobotModel& robot) {
  way_.reset();
  if (!options_.report.empty()) curves_.emplace(robot);
  if (!options_.svg.empty() || options_.plot) way_.emplace(robot);
  if (!curves_ && !way_) return {};
  return [this](const Snapshot& snapshot) {
    if (curves_) curves_->take(snapshot);
    if (way_) way_->take(snapshot);
  };
}

std::function<void(const motion::JointVector&, int)> Pictures::target_listener() {
  if (!way_) return {};
  return [this](const motion::JointVector& target, int line) { way_->aim(target, line); };
}

void Pictures::save_report(const RunResult& result, const LoadedProgram& program) const {
  std::set<std::uint32_t> lines;
  for (const LineResult& line : result.lines) lines.insert(lang::tagged_place(line.line).line);
  const bool measured = options_.command == Options::Command::Run;
  const ReportAbout about{measured, options_.seed, source_lines(program, lines), kVersion};
  const RunCurves none(program.robot);
  save_file(options_.report, report_page(result, program.robot, curves_ ? *curves_ : none, about));
}

void Pictures::save(const RunResult& result, const LoadedProgram& program) const {
  if (!program.runnable()) return;
  if (!options_.report.empty()) save_report(result, program);
  if (!way_) return;
  constexpr int kColumns = 72;  // [choice] of the 80 that every terminal has
  constexpr int kRows = 20;
  if (options_.plot) put_result(path_plot(program.robot, *way_, kColumns, kRows));
  if (options_.svg.empty()) return;
  const std::string picture = path_svg(result, program.robot, *way_);
  if (is_file(options_.svg)) return save_file(options_.svg, picture);
  put_result(picture);
}

}  // namespace rob::runtime
