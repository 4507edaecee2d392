# wardslam_room(<name> [ON_REQUEST] PUBLIC <targets...> PRIVATE <targets...>)
#
# One room: the library wardslam::<name>, made of every src/*.cpp beside the calling CMakeLists.txt,
# with its public headers under include/wardslam/<name>/.
# ON_REQUEST: projects outside get it by find_package(wardslam COMPONENTS <name>) only.
function(wardslam_room room)
  cmake_parse_arguments(ROOM "ON_REQUEST" "" "PUBLIC;PRIVATE" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS src/*.cpp)
  add_library(wardslam_${room} ${sources})
  add_library(wardslam::${room} ALIAS wardslam_${room})
  target_include_directories(wardslam_${room}
    PUBLIC $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
    PRIVATE src)
  target_link_libraries(wardslam_${room}
    PUBLIC ${ROOM_PUBLIC}
    PRIVATE ${ROOM_PRIVATE} $<BUILD_INTERFACE:wardslam_compile_options>)
  target_compile_features(wardslam_${room} PUBLIC cxx_std_17)
  set_target_properties(wardslam_${room} PROPERTIES
    EXPORT_NAME ${room} VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}
    POSITION_INDEPENDENT_CODE ON INSTALL_RPATH "$ORIGIN")
  set(export wardslam-targets)
  if(ROOM_ON_REQUEST)
    set(export wardslam-${room}-targets)
    set_property(GLOBAL APPEND PROPERTY WARDSLAM_COMPONENTS ${room})
  endif()
  install(TARGETS wardslam_${room} EXPORT ${export}
    LIBRARY DESTINATION ${WARDSLAM_LIBDIR} ARCHIVE DESTINATION ${WARDSLAM_LIBDIR})
  set_property(GLOBAL APPEND PROPERTY WARDSLAM_ROOMS ${room})
  if(IS_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/include)  # a room that is only loaded has none
    install(DIRECTORY include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
  endif()
endfunction()

# wardslam_program(<name> [MANUAL <page>] SOURCES <files...> LIBRARIES <targets...>): an installed executable. It must
# parse its command line with apps/support/command_line.h, which prints its manual page, or bring a MANUAL.
function(wardslam_program program)
  cmake_parse_arguments(PROGRAM "" "MANUAL" "SOURCES;LIBRARIES" ${ARGN})
  add_executable(${program} ${PROGRAM_SOURCES})
  target_link_libraries(${program} PRIVATE ${PROGRAM_LIBRARIES} wardslam_compile_options)
  set_target_properties(${program} PROPERTIES INSTALL_RPATH "$ORIGIN/../${WARDSLAM_LIBDIR}")
  install(TARGETS ${program})
  wardslam_manual(${program} ${PROGRAM_MANUAL})
endfunction()
