#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "runtime/run/load.h"

namespace rob::runtime {

/// A file that a command reads or keeps, and what it is for people: "the program".
struct InputFile {
  std::string path;
  std::string what;
};

/// Whether both names lead to one file, or would: neither needs to exist.
bool same_file(const std::string& a, const std::string& b);

/// The program, the files that it USEs, and its points, which need not be there yet.
std::vector<InputFile> inputs_of(const LoadedProgram& program);

/// Throws UsageError if the file that `option` names is one of these, by whatever name or link, or
/// lies where Rob keeps versions of programs and its own state. Opens nothing.
void refuse_overwriting(std::string_view option, const std::string& output,
                        const std::vector<InputFile>& inputs);

}  // namespace rob::runtime
