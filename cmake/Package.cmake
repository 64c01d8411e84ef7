# What `cmake --install` installs for `find_package(pliant)`: headers, archives, and their CMake
# targets. Users link pliant::pliant, which consists of the other targets. The compiler options of
# pliant do not affect them.

include(CMakePackageConfigHelpers)

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/pliant)
install(
  TARGETS pliant_library pliant_engine pliant_output pliant_case pliant_geometry pliant_scheduler
          pliant_kernels
  EXPORT pliant_targets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development
  INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(
  EXPORT pliant_targets
  NAMESPACE pliant::
  FILE pliantTargets.cmake
  DESTINATION ${package_folder} COMPONENT development)
install(DIRECTORY include/pliant ${PROJECT_BINARY_DIR}/include/pliant
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development FILES_MATCHING PATTERN "*.hpp")

configure_package_config_file(
  cmake/pliantConfig.cmake.in ${PROJECT_BINARY_DIR}/pliantConfig.cmake
  INSTALL_DESTINATION ${package_folder})
# Before 1.0 a minor version may change the interface.
write_basic_package_version_file(
  ${PROJECT_BINARY_DIR}/pliantConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/pliantConfig.cmake
              ${PROJECT_BINARY_DIR}/pliantConfigVersion.cmake DESTINATION ${package_folder}
        COMPONENT development)
