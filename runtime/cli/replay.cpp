#include "runtime/cli/replay.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>

#include "runtime/cli/run_files.h"
#include "runtime/files/files.h"
#include "runtime/record/mcap_reader.h"
#include "runtime/record/recorded_run.h"
#include "runtime/run/console.h"

namespace rob::runtime {

namespace {

namespace fs = std::filesystem;

/// A new folder that disappears with the object.
class PassingFolder {
 public:
  PassingFolder() {
    std::string pattern = (fs::temp_directory_path() / "rob-replay-XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr)
      throw FileError(fmt::format("cannot make a folder '{}': {}", pattern, std::strerror(errno)));
    path_ = pattern;
  }
  ~PassingFolder() {
    std::error_code ignored;  // what is left in the temporary folder does no harm
    fs::remove_all(path_, ignored);
  }
  PassingFolder(const PassingFolder&) = delete;
  PassingFolder& operator=(const PassingFolder&) = delete;

  std::string file(const char* name) const { return (path_ / name).string(); }

 private:
  fs::path path_;
};

/// The same command, on the virtual clock, with a record of its own.
Options repeated(const RecordedOptions& recorded, const Options& asked, const std::string& record) {
  Options options;
  options.command = Options::Command::Run;
  options.files = {recorded.program};
  options.robot = recorded.robot;
  if (!recorded.law.empty())
    options.law = recorded.law == motion::law_name(motion::Law::Paul) ? motion::Law::Paul
                                                                      : motion::Law::LookAhead;
  options.signals = recorded.signals;
  options.seed = recorded.seed;
  options.cell = recorded.cell;
  options.override_share = recorded.override_share;
  options.date = recorded.date;
  options.data = asked.data;
  options.fast = true;
  options.json = true;  // prints nothing while it runs
  options.mcap = record;
  return options;
}

}  // namespace

ExitCode replay_record(const Options& asked) {
  const PassingFolder folder;
  const RecordedOptions how =
      unpack(McapReader(asked.replay).attachments(), folder.file("program"));
  const std::string again = folder.file("again.mcap");
  const Options options = repeated(how, asked, again);
  const ExitCode end = run_silently(options);
  if (end != ExitCode::Done && end != ExitCode::Fault && end != ExitCode::Interrupted) return end;
  const Comparison comparison = compare_records(asked.replay, again, how.virtual_clock);
  const char* const remark =
      how.virtual_clock ? "" : "; it was recorded in real time, where what is measured differs";
  if (comparison.differs_from) {
    put_result(
        fmt::format("{}: differs from t = {} s on, after {} references that are the same{}\n",
                    asked.replay, *comparison.differs_from, comparison.references, remark));
    return ExitCode::ProgramError;
  }
  put_result(fmt::format("{}: the same, all {} references bit for bit{}\n", asked.replay,
                         comparison.references, remark));
  return ExitCode::Done;
}

}  // namespace rob::runtime
