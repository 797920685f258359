# gaitway_topic_types(<target> SCHEMA <file.toml> HEADER <folder/stem> [PREFIX <Name>]): an interface target whose headers
# <folder/stem>.h and .hpp are generated from the schema at build time. Plug-ins with topics of their own use it, too.
set(GAITWAY_TOPIC_GENERATOR "${CMAKE_CURRENT_LIST_DIR}/generate.py" CACHE INTERNAL "")

function(gaitway_topic_types target)
  cmake_parse_arguments(arg "" "SCHEMA;HEADER;PREFIX" "" ${ARGN})
  if(NOT arg_PREFIX)
    set(arg_PREFIX Standard)
  endif()
  get_filename_component(schema "${arg_SCHEMA}" ABSOLUTE)
  set(folder "${CMAKE_CURRENT_BINARY_DIR}/generated")
  set(stem "${folder}/${arg_HEADER}")
  add_custom_command(
    OUTPUT "${stem}.h" "${stem}.hpp"
    COMMAND Python3::Interpreter "${GAITWAY_TOPIC_GENERATOR}" "${schema}" --c-header "${stem}.h"
            --cpp-header "${stem}.hpp" --c-include "${arg_HEADER}.h" --prefix "${arg_PREFIX}"
    DEPENDS "${schema}" "${GAITWAY_TOPIC_GENERATOR}"
    COMMENT "Generating ${arg_HEADER}.h and .hpp" VERBATIM)
  add_custom_target(${target}_generate DEPENDS "${stem}.h" "${stem}.hpp")
  add_library(${target} INTERFACE)
  target_include_directories(${target} INTERFACE "$<BUILD_INTERFACE:${folder}>")
  add_dependencies(${target} ${target}_generate)
endfunction()
