# wardslam_manual(<program> [<page>]): installs a manual page and, unless a page is given, what makes bash complete the
# program's words. The program prints both itself, so that they say what its --help says.
find_program(WARDSLAM_GZIP gzip REQUIRED)
set(WARDSLAM_MANUALS ${PROJECT_BINARY_DIR}/share/man/man1)
set(WARDSLAM_COMPLETIONS ${PROJECT_BINARY_DIR}/share/bash-completion/completions)
file(MAKE_DIRECTORY ${WARDSLAM_MANUALS} ${WARDSLAM_COMPLETIONS})

function(wardslam_manual program)
  set(page ${WARDSLAM_MANUALS}/${program}.1)
  if(ARGN)
    set(make_page COMMAND ${CMAKE_COMMAND} -E copy ${ARGN} ${page})
    set(sources ${ARGN})
  else()
    set(completion ${WARDSLAM_COMPLETIONS}/${program})
    set(make_page
      COMMAND ${program} --generate man > ${page}
      COMMAND ${program} --generate bash-completion > ${completion})
    set(sources ${program})
    install(FILES ${completion} DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
    set_property(GLOBAL APPEND PROPERTY WARDSLAM_PROGRAMS ${program})
  endif()
  add_custom_command(OUTPUT ${page}.gz ${page} ${completion}
    ${make_page}
    COMMAND ${WARDSLAM_GZIP} -9nkf ${page}
    DEPENDS ${sources} VERBATIM)
  add_custom_target(${program}-manual ALL DEPENDS ${page}.gz)
  install(FILES ${page}.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
endfunction()
