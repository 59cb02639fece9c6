#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "runtime/run/run_result.h"
#include "runtime/run/text_report.h"

namespace rob::runtime {

/// The documents of `rob run --json` and `rob check --json` (docs/cli.md), piece by piece, without
/// a line end after them. Times in s, rounded to 1 ns; places in mm, rounded to 1 nm; angles in
/// deg. `indent`: by how many blanks they are deeper than the document that they stand in.
void put_run_json(const RunResult& result, std::size_t indent, const Put& put);
void put_check_json(const RunResult& result, std::size_t indent, const Put& put);

/// As it is printed: UTF-8, whatever a program PRINTs, and nothing that a terminal would act on.
std::string json_text(const nlohmann::ordered_json& document);

/// An error, or null.
nlohmann::ordered_json problem_json(const std::optional<Problem>& problem);

}  // namespace rob::runtime
