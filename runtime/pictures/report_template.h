#pragma once

#include <string_view>

/// report.html and report.js, as the build has put them into the program.
namespace rob::runtime {

std::string_view report_template();
std::string_view report_script();
/// As hex digits: of report_script().
std::string_view report_script_sha256();

}  // namespace rob::runtime
