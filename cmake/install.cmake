# find_package(wardslam) for projects outside: one exported target per room; some only when asked for, as components.
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/wardslam)
install(EXPORT wardslam-targets NAMESPACE wardslam:: DESTINATION ${package_dir})
get_property(components GLOBAL PROPERTY WARDSLAM_COMPONENTS)
foreach(component IN LISTS components)
  install(EXPORT wardslam-${component}-targets NAMESPACE wardslam:: DESTINATION ${package_dir})
endforeach()
configure_package_config_file(cmake/wardslam-config.cmake.in ${PROJECT_BINARY_DIR}/wardslam-config.cmake
  INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/wardslam-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/wardslam-config.cmake ${PROJECT_BINARY_DIR}/wardslam-config-version.cmake
  DESTINATION ${package_dir})
install(DIRECTORY config DESTINATION ${CMAKE_INSTALL_DATADIR}/wardslam)
install(FILES share/models.yaml DESTINATION ${CMAKE_INSTALL_DATADIR}/wardslam)
install(DIRECTORY share/networks share/report share/reproduction DESTINATION ${CMAKE_INSTALL_DATADIR}/wardslam)
