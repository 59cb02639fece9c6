# Turns every robot file in motion/robots into text inside the library (see robot_library.h).
file(GLOB robot_files CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/motion/robots/*.toml)
set(ROB_EMBEDDED_ROBOTS ${PROJECT_BINARY_DIR}/embedded_robots.cpp)
set(entries "")
foreach(file ${robot_files})
  get_filename_component(name ${file} NAME_WE)
  file(READ ${file} text)
  string(APPEND entries "    {\"${name}\", R\"toml(${text})toml\"},\n")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
endforeach()
file(CONFIGURE OUTPUT ${ROB_EMBEDDED_ROBOTS} CONTENT
"#include \"motion/robots/robot_library.h\"

namespace rob::motion {

std::span<const EmbeddedRobot> embedded_robots() {
  static constexpr EmbeddedRobot robots[] = {
@entries@  };
  return robots;
}

}  // namespace rob::motion
" @ONLY)
