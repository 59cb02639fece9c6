# Turns the manual, docs/language.md, into text inside the library, one string for each chapter
# (see manual.h).
set(manual_file ${PROJECT_SOURCE_DIR}/docs/language.md)
set(ROB_EMBEDDED_MANUAL ${PROJECT_BINARY_DIR}/embedded_manual.cpp)
file(READ ${manual_file} manual)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${manual_file})
string(REPLACE "\n## " "\n)manual\",\n      R\"manual(## " manual "${manual}")
file(CONFIGURE OUTPUT ${ROB_EMBEDDED_MANUAL} CONTENT
"#include \"lang/help/manual.h\"

namespace rob::lang {

std::span<const std::string_view> embedded_manual() {
  static constexpr std::string_view chapters[] = {
      R\"manual(@manual@)manual\"};
  return chapters;
}

}  // namespace rob::lang
" @ONLY)
