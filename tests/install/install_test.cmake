# Run by CTest, see CMakeLists.txt beside it. LD_LIBRARY_PATH stays unset: what is installed must find its own parts.
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  message(STATUS "${ARGN}\n${output}")
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "failed (${result}): ${ARGN}")
  endif()
endfunction()

unset(ENV{LD_LIBRARY_PATH})
unset(ENV{WARDSLAM_DATA_DIR})
file(REMOVE_RECURSE ${WORK})
string(REPLACE "," ";" rooms "${ROOMS}")
string(REPLACE "," ";" components "${COMPONENTS}")

run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix)
run(${CMAKE_COMMAND} -S ${CONSUMER} -B ${WORK}/build -D CMAKE_PREFIX_PATH=${WORK}/prefix "-D ROOMS=${rooms}"
    "-D COMPONENTS=${components}"
    -D CMAKE_BUILD_TYPE=${BUILD_TYPE} -D CMAKE_CXX_FLAGS=${CXX_FLAGS} -D WARDSLAM_VERSION=${VERSION})
run(${CMAKE_COMMAND} --build ${WORK}/build)
run(${WORK}/build/consumer ${WORK}/prefix)
run(${WORK}/build/slam_only)
if(SHARED_LIBS)
  run(${CMAKE_COMMAND} -D PROGRAM=${WORK}/build/slam_only -D LIBRARIES=${WORK}/prefix/${LIBDIR}
      -P ${CMAKE_CURRENT_LIST_DIR}/no_windows.cmake)
endif()

# A filter of somebody else's, built outside and loaded by the installed program.
run(${CMAKE_COMMAND} -S ${EXAMPLES}/range_filter -B ${WORK}/range_filter/build -D CMAKE_PREFIX_PATH=${WORK}/prefix
    -D CMAKE_BUILD_TYPE=${BUILD_TYPE} -D CMAKE_CXX_FLAGS=${CXX_FLAGS})
run(${CMAKE_COMMAND} --build ${WORK}/range_filter/build)
file(COPY ${EXAMPLES}/range_filter/range_filter.yaml DESTINATION ${WORK}/range_filter)
run(${WORK}/prefix/bin/rawlog-synth -o ${WORK}/ward.rawlog --seconds 0.5 --rate 10)
run(${WORK}/prefix/bin/wardslam run ${WORK}/ward.rawlog --config ${WORK}/range_filter/range_filter.yaml
    --out ${WORK}/run)
file(READ ${WORK}/run/summary.json summary)
string(JSON share GET "${summary}" dynamic_keypoint_fraction)
if(share LESS_EQUAL 0 OR share GREATER_EQUAL 1)
  message(FATAL_ERROR "the range filter left out a share of ${share} of the key points")
endif()

# A program of somebody else's with WardSLAM in it.
run(${CMAKE_COMMAND} -S ${EXAMPLES}/embedding -B ${WORK}/embedding -D CMAKE_PREFIX_PATH=${WORK}/prefix
    -D CMAKE_BUILD_TYPE=${BUILD_TYPE} -D CMAKE_CXX_FLAGS=${CXX_FLAGS})
run(${CMAKE_COMMAND} --build ${WORK}/embedding)
run(${WORK}/embedding/embedding ${WORK}/ward.rawlog ${WORK}/ward_labels/masks ${EXAMPLES}/embedding/embedding.ini)

# MRPT's metric maps, a semantic one among them, made by somebody else's program.
run(${WORK}/prefix/bin/rawlog-annotate ${WORK}/ward.rawlog --masks ${WORK}/ward_labels/masks --embed
    -o ${WORK}/embedded.rawlog)
run(${CMAKE_COMMAND} -S ${EXAMPLES}/metric_map -B ${WORK}/metric_map -D CMAKE_PREFIX_PATH=${WORK}/prefix
    -D CMAKE_BUILD_TYPE=${BUILD_TYPE} -D CMAKE_CXX_FLAGS=${CXX_FLAGS})
run(${CMAKE_COMMAND} --build ${WORK}/metric_map)
run(${WORK}/metric_map/metric_map ${WORK}/embedded.rawlog ${WORK}/run/trajectory.txt
    ${EXAMPLES}/metric_map/metric_map.ini ${WORK}/metric_map/maps)
file(GLOB written ${WORK}/metric_map/maps*)
if(NOT written)
  message(FATAL_ERROR "examples/metric_map wrote no map")
endif()

# A SLAM program written against MRPT's interface: the camera goes the way that `wardslam run` says.
run(${CMAKE_COMMAND} -S ${EXAMPLES}/map_builder -B ${WORK}/map_builder -D CMAKE_PREFIX_PATH=${WORK}/prefix
    -D CMAKE_BUILD_TYPE=${BUILD_TYPE} -D CMAKE_CXX_FLAGS=${CXX_FLAGS})
run(${CMAKE_COMMAND} --build ${WORK}/map_builder)
file(WRITE ${WORK}/map_builder/map_builder.ini
     "[MappingApplication]\nCSemanticMap_count = 1\noctoMap_count = 1\n[WardSLAM]\ndeterministic = true\n")
run(${WORK}/map_builder/map_builder ${WORK}/map_builder/map_builder.ini ${WORK}/ward.rawlog ${WORK}/map_builder/ward)
run(${WORK}/prefix/bin/wardslam run ${WORK}/ward.rawlog --deterministic --out ${WORK}/map_builder/run)
run(${CMAKE_COMMAND} -E compare_files ${WORK}/map_builder/ward.txt ${WORK}/map_builder/run/trajectory.txt)
run(${WORK}/map_builder/map_builder ${EXAMPLES}/../config/mrpt/map_builder.ini ${WORK}/ward.rawlog
    ${WORK}/map_builder/again)
foreach(name ward.simplemap ward.png again.simplemap)
  if(NOT EXISTS ${WORK}/map_builder/${name})
    message(FATAL_ERROR "examples/map_builder did not write ${name}")
  endif()
endforeach()

# The plug-in in MRPT's own program, where there is one.
find_program(rawlog_edit rawlog-edit)
if(rawlog_edit)
  file(GLOB_RECURSE plugin ${WORK}/prefix/*/libwardslam-mrpt.so)
  execute_process(COMMAND ${rawlog_edit} -p ${plugin} -i ${WORK}/embedded.rawlog --info OUTPUT_VARIABLE info
                  ERROR_VARIABLE info)
  if(NOT info MATCHES "RGBD_SEM */ *[1-9]")
    message(FATAL_ERROR "rawlog-edit does not read what rawlog-annotate embedded:\n${info}")
  endif()
endif()

# Installed programs start from their new place and find their libraries.
file(GLOB programs ${WORK}/prefix/bin/*)
foreach(program IN LISTS programs)
  run(${program} --help)
endforeach()
