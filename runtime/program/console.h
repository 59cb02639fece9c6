#pragma once

#include <string_view>

namespace rob::runtime {

/// Results for standard output, messages for people on standard error. Neither ever stops a robot:
/// a reader that has gone away or a full disk is remembered, and reported when the run is over.
void put_result(std::string_view text);
void put_message(std::string_view text);

/// False if a result could not be written.
bool results_written();

}  // namespace rob::runtime
