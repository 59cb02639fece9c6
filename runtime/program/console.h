#pragma once

#include <string_view>

namespace rob::runtime {

/// Results for standard output, messages for people on standard error. A full disk is remembered,
/// and reported when the run is over.
void put_result(std::string_view text);
void put_message(std::string_view text);

/// Whoever read the results has closed the pipe: nobody waits for the rest of the run.
bool reader_has_gone();

/// False if a result could not be written.
bool results_written();

}  // namespace rob::runtime
