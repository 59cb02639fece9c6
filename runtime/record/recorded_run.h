#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "motion/robots/robot_model.h"
#include "runtime/record/recorded_file.h"
#include "runtime/run/load.h"
#include "runtime/time/wall_time.h"

namespace rob::runtime {

/// A run needs this to be repeated, besides its files. A record has it as `options.json`.
struct RecordedOptions {
  std::string program;  ///< here and below: where it is in the record's folder
  std::string robot;    ///< as the command line named it; empty: the program's own
  std::string law;      ///< the same
  std::string signals;  ///< the script; empty: none
  std::uint64_t seed = 0;
  std::optional<std::uint64_t> cell;
  double override_share = 1;
  WallTime date{};
  bool virtual_clock = false;
};

/// The files that a program is made of before it runs: sources, points, values, robot file, signal
/// script, options.json. Their names are base names; options.json says where they were, seen from
/// the folder in which all sources are. `robot_file`, `script_file`: empty where there is none.
/// Throws FileError.
std::vector<RecordedFile> files_of_run(const LoadedProgram& program, RecordedOptions options,
                                       const std::string& robot_file,
                                       const std::string& script_file);

/// Writes such files into a folder, where they were, and says what options.json says. Throws
/// FileError if they are not those of a run.
RecordedOptions unpack(const std::vector<RecordedFile>& files, const std::string& folder);

/// Whether two records have the same references, bit for bit.
struct Comparison {
  std::int64_t references = 0;           ///< that are the same
  std::optional<double> differs_from{};  ///< s: the time of the first that is not
};
/// `measured`: and the same measurements, which differ where a clock of the world passes. Throws
/// FileError.
Comparison compare_records(const std::string& first, const std::string& second, bool measured);

}  // namespace rob::runtime
