#pragma once

#include <string>
#include <vector>

#include "runtime/program/run_result.h"

namespace rob::runtime {

/// `rob fmt`: gives each file its canonical layout, or with `check_only` names those that differ
/// from it. A file with errors, and one that cannot be read or written, stays as it is; the others
/// are done all the same.
ExitCode format_files(const std::vector<std::string>& files, bool check_only);

}  // namespace rob::runtime
