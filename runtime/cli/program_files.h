#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/cli/options.h"
#include "runtime/files/signal_script.h"
#include "runtime/run/console.h"
#include "runtime/run/json_report.h"
#include "runtime/run/load.h"
#include "runtime/run/machine.h"
#include "runtime/run/run_result.h"

/// The commands over program files have this in common: they read all files before the first
/// program starts, and show the results.
namespace rob::runtime {

/// The worse of two: the first that is not Done.
inline ExitCode worse(ExitCode a, ExitCode b) { return a == ExitCode::Done ? b : a; }

/// Writes what comes in small pieces in larger ones.
class Pieces {
 public:
  Pieces() = default;
  ~Pieces() { put_result(text_); }
  Pieces(const Pieces&) = delete;
  Pieces& operator=(const Pieces&) = delete;

  Put put() {
    return [this](std::string_view piece) {
      constexpr std::size_t kMost = 65536;  // bytes [choice]
      text_ += piece;
      if (text_.size() < kMost) return;
      put_result(text_);
      text_.clear();
    };
  }

 private:
  std::string text_;
};

using PutJson = void (*)(const RunResult& result, std::size_t indent, const Put& put);

/// Prints one document, or a list where several programs were named, however many of them ran.
void print_json(const Options& options, const std::vector<RunResult>& results, PutJson document);

/// Reads all programs before the first one starts: a file that cannot be read leaves nothing half
/// done. Throws as load_program() does.
std::vector<LoadedProgram> load_programs(const Options& options);

/// The signal script for each of the programs, which may use their names.
std::vector<SignalScript> load_scripts(const Options& options,
                                       const std::vector<LoadedProgram>& programs);

/// Throws UsageError if `output`, the file that `option` names, is one that the command reads or
/// that a program may keep.
void refuse_overwriting_inputs(std::string_view option, const std::string& output,
                               const Options& options, const std::vector<LoadedProgram>& programs);

/// The errors of the program or of its script, for people.
std::string problems_text(const RunResult& result, const LoadedProgram& program,
                          const SignalScript& script);

/// The program's machine, open, and the program as it fits to it.
OpenMachine machine_for(LoadedProgram& program, const Options& options);

}  // namespace rob::runtime
