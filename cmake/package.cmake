# `cpack` makes a Debian package of what is installed; dpkg-shlibdeps finds what it depends on.
set(WARDSLAM_PACKAGE_MAINTAINER "The WardSLAM developers <wardslam@example.org>"
  CACHE STRING "Who answers for the Debian package: Name <address>")

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME wardslam)
set(CPACK_PACKAGE_CONTACT ${WARDSLAM_PACKAGE_MAINTAINER})
set(CPACK_PACKAGE_VENDOR "The WardSLAM developers")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
# Goes below the description of the project.
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
"From the images of an RGB-D or stereo camera to the way of a robot and a map
of objects, leaving out what moves. Reads MRPT rawlogs, folders in the layout
of the TUM RGB-D benchmark, recordings of ROS, and live cameras; its filters are plug-ins for
MRPT's programs too. Contains programs, libraries, headers and configuration.")
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${CMAKE_LIBRARY_OUTPUT_DIRECTORY})
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS
  "libgl1-mesa-dri, libjs-dygraphs")  # pictures of a map without a display; plots of a report
set(CPACK_DEBIAN_PACKAGE_SUGGESTS
  "mrpt-apps, libmrpt-dev, libopencv-dev, libceres-dev, libeigen3-dev, libyaml-cpp-dev, cmake")  # to build on it
include(CPack)

# Debian wants licence and changes in these places, wherever else they are.
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
configure_file(share/debian/changelog.in share/debian/changelog @ONLY)
execute_process(COMMAND ${WARDSLAM_GZIP} -9nkf ${PROJECT_BINARY_DIR}/share/debian/changelog)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/wardslam RENAME copyright)
install(FILES ${PROJECT_BINARY_DIR}/share/debian/changelog.gz README.md CHANGELOG.md
  DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/wardslam)
