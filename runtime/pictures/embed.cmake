# Turns the page of reports into texts inside the library (see report_template.h).
set(report_folder ${PROJECT_SOURCE_DIR}/runtime/pictures)
set(ROB_EMBEDDED_REPORT ${PROJECT_BINARY_DIR}/embedded_report.cpp)
file(READ ${report_folder}/report.html report_html)
file(READ ${report_folder}/report.js report_js)
string(SHA256 report_js_sha256 "${report_js}")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${report_folder}/report.html
                                                               ${report_folder}/report.js)
file(CONFIGURE OUTPUT ${ROB_EMBEDDED_REPORT} CONTENT
"#include \"runtime/pictures/report_template.h\"

namespace rob::runtime {

std::string_view report_template() { return R\"page(@report_html@)page\"; }
std::string_view report_script() { return R\"page(@report_js@)page\"; }
std::string_view report_script_sha256() { return \"@report_js_sha256@\"; }

}  // namespace rob::runtime
" @ONLY)
