#pragma once

#include <string_view>

#include "runtime/command/program_effects.h"
#include "runtime/command/waits.h"
#include "runtime/files/data_files.h"

namespace rob::runtime {

/// The files of a program. Each line that it writes waits for its turn in motion order.
class FileDesk {
 public:
  FileDesk(const RobotLinks& links, EffectQueue& queue, const CommandedProgress& progress,
           ProgramEffects& effects, Waits& waits)
      : links_(links), queue_(queue), progress_(progress), effects_(effects), waits_(waits) {}

  /// Before the run; they must outlive it. Without them (null) the program has no files.
  void keep_files(DataFiles* files) { files_ = files; }
  DataFiles* files() const { return files_; }
  ProgramLog& log() const { return links_.log; }

  lang::Reply write(int line, std::string_view file, std::string_view text);
  /// It is no effect that could be bound to a motion or a WHEN.
  lang::Reply persist(int line, std::size_t variable, std::string_view value);
  /// At standstill, when all lines that were written before are there.
  lang::Reply read(int line, std::string_view file, std::string& text);
  lang::Reply exists(std::string_view file, bool& value);

 private:
  const RobotLinks& links_;
  EffectQueue& queue_;
  const CommandedProgress& progress_;
  ProgramEffects& effects_;
  Waits& waits_;
  DataFiles* files_ = nullptr;
};

/// The note of a value.
Note note_of(std::size_t variable, std::string_view value);
/// A line for a file, in motion order; or why it cannot be.
std::optional<Words> objection_to_line(DataFiles* files, std::string_view file,
                                       std::string_view text);

}  // namespace rob::runtime
