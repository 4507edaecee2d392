# What every target of the project is compiled with. Sanitizers come from the presets (CMakePresets.json).
add_library(wardslam_compile_options INTERFACE)
target_compile_options(wardslam_compile_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion
  $<$<BOOL:${WARDSLAM_WARNINGS_AS_ERRORS}>:-Werror>)

find_program(WARDSLAM_CCACHE ccache)
if(WARDSLAM_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${WARDSLAM_CCACHE})
endif()
