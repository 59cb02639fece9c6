#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "runtime/run/run_result.h"

namespace rob::runtime {

/// Takes a report piece by piece: a program may have a million lines.
using Put = std::function<void(std::string_view piece)>;

/// The output of `rob check`: a line each with start, duration, decision point and corner miss.
void put_check_table(const RunResult& result, const Put& put);
/// The output of `rob run` at the end: the same, the measured values beside it, and the totals.
void put_run_table(const RunResult& result, const Put& put);

/// The routines that an error happened in. [choice] ten of them: a recursion may be 1000 deep.
std::string calls_text(const Problem& problem);

/// The findings and the error of a result, each as lang::render writes it.
/// `source`: of the program; `used`: what it USEs.
std::string problems_text(const RunResult& result, std::string_view source,
                          std::span<const lang::SourceFile> used = {});

}  // namespace rob::runtime
