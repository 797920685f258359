# gaitway_plugin_module(<target> SOURCES … [LINKS …]): a plug-in as a shared library with its entry symbol visible and
# nothing else. For this tree and for the projects that find the installed package.
set(GAITWAY_PLUGIN_MAP "${CMAKE_CURRENT_LIST_DIR}/plugin.map" CACHE INTERNAL "")

function(gaitway_plugin_module target)
  cmake_parse_arguments(arg "" "" "SOURCES;LINKS" ${ARGN})
  add_library(${target} MODULE ${arg_SOURCES})
  target_link_libraries(${target} PRIVATE gaitway::plugin ${arg_LINKS})
  target_compile_features(${target} PRIVATE cxx_std_20)
  # A unique symbol would pin the library in memory for ever.
  target_compile_options(${target} PRIVATE $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-fno-gnu-unique>)
  target_link_options(${target} PRIVATE "LINKER:--version-script=${GAITWAY_PLUGIN_MAP}" "LINKER:--exclude-libs,ALL")
  set_target_properties(${target} PROPERTIES LINK_DEPENDS "${GAITWAY_PLUGIN_MAP}" POSITION_INDEPENDENT_CODE ON
    C_VISIBILITY_PRESET hidden CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
endfunction()
