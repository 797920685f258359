# From an installation (or with -DGAITWAY_STAGE=OFF from the build tree): new-plugin, build, its test, a run with it.
# Arguments: BUILD, KIND, FOLDER (made anew), STAGE.
file(REMOVE_RECURSE "${FOLDER}")
file(MAKE_DIRECTORY "${FOLDER}")

function(run)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY "${FOLDER}" RESULT_VARIABLE result OUTPUT_VARIABLE output
                  ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${ARGN}\nended with ${result}:\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

set(prefix "${BUILD}")
if(STAGE)
  set(prefix "${FOLDER}/prefix")
  run("${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${prefix}")
  # Nothing may lead back to the build.
  file(RENAME "${prefix}" "${FOLDER}/moved")
  set(prefix "${FOLDER}/moved")
endif()
set(gaitway "${prefix}/bin/gaitway")

run("${gaitway}" new-plugin mine --kind ${KIND})
if(NOT output MATCHES "-Dgaitway_DIR=${prefix}/lib/cmake/gaitway")
  message(FATAL_ERROR "the next command does not name the package: ${output}")
endif()
run("${CMAKE_COMMAND}" -S mine -B mine/build "-Dgaitway_DIR=${prefix}/lib/cmake/gaitway")
run("${CMAKE_COMMAND}" --build mine/build)
run("${CMAKE_CTEST_COMMAND}" --test-dir mine/build --output-on-failure)
set(seconds 5)
if(KIND STREQUAL behaviour)
  set(seconds 15)  # its mission comes to its end
endif()
run("${gaitway}" run --with mine/build/libmine.so --seconds ${seconds} --no-pictures --out out)
if(NOT output MATCHES "mine \\(.*/mine/build/libmine.so\\) (replaces|is added)" OR NOT EXISTS "${FOLDER}/out/report.html")
  message(FATAL_ERROR "the run does not tell of the plug-in: ${output}")
endif()
file(REMOVE_RECURSE "${FOLDER}")
