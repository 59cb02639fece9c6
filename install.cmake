# `cmake --install build --prefix P`: the program, and the layers that other programs can use with
# find_package(rob): Rob::lang, Rob::motion and Rob::drivers (docs/embedding.md).
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(rob_package ${CMAKE_INSTALL_LIBDIR}/cmake/rob)

install(TARGETS rob rob_geometry RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
foreach(layer lang motion drivers contact)
  set_target_properties(rob_${layer} PROPERTIES EXPORT_NAME ${layer})
  target_compile_features(rob_${layer} PUBLIC cxx_std_20)
endforeach()
install(TARGETS rob_lang rob_motion rob_drivers rob_contact EXPORT robTargets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
        INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT robTargets NAMESPACE Rob:: DESTINATION ${rob_package})
file(WRITE ${PROJECT_BINARY_DIR}/robConfig.cmake "include(CMakeFindDependencyMacro)
find_dependency(fmt)
find_dependency(Eigen3 3.4 NO_MODULE)
find_dependency(tomlplusplus)
include(\${CMAKE_CURRENT_LIST_DIR}/robTargets.cmake)
")
write_basic_package_version_file(${PROJECT_BINARY_DIR}/robConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/robConfig.cmake ${PROJECT_BINARY_DIR}/robConfigVersion.cmake
        DESTINATION ${rob_package})

# In the tree an include begins with its layer, in the package with rob/; the facades lang/lang.h
# and motion/motion.h are <rob/lang.h> and <rob/motion.h> there.
install(CODE "
  set(source \"${PROJECT_SOURCE_DIR}\")
  set(include \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_INCLUDEDIR}/rob\")
")
install(CODE [[
  foreach(layer base lang motion drivers)
    file(GLOB headers RELATIVE ${source} ${source}/${layer}/*.h ${source}/${layer}/*/*.h
         ${source}/${layer}/*/*.def ${source}/${layer}/*/*.inc)
    foreach(header IN LISTS headers)
      file(READ ${source}/${header} text)
      string(REGEX REPLACE "#include \"((base|lang|motion|drivers)/)" "#include \"rob/\\1" text "${text}")
      string(REGEX REPLACE "^lang/lang\\.h$" "lang.h" installed ${header})
      string(REGEX REPLACE "^motion/motion\\.h$" "motion.h" installed ${installed})
      file(WRITE ${include}/${installed} "${text}")
      list(APPEND CMAKE_INSTALL_MANIFEST_FILES ${include}/${installed})
    endforeach()
  endforeach()
]])

install(DIRECTORY docs/ DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES README.md LICENSE CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY examples DESTINATION ${CMAKE_INSTALL_DATADIR}/rob)
