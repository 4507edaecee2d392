# What every target of the project is compiled with. Sanitizers come from the presets (CMakePresets.json).
add_library(wardslam_compile_options INTERFACE)
target_compile_options(wardslam_compile_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion
  $<$<BOOL:${WARDSLAM_WARNINGS_AS_ERRORS}>:-Werror>)
