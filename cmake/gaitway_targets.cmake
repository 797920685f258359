# The few functions with which a room declares its targets, so that each CMakeLists.txt stays a few lines.
include(gaitway_plugin_module)

# The public headers of a room: its include/ folder. The warnings apply to what we compile, not to our users.
# FREESTANDING: for a microcontroller, too, so without exceptions and run-time types.
function(gaitway_library name)
  cmake_parse_arguments(arg "FREESTANDING" "" "SOURCES;LINKS;PRIVATE_LINKS" ${ARGN})
  if(arg_SOURCES)
    add_library(gaitway_${name} STATIC ${arg_SOURCES})
    target_include_directories(gaitway_${name} PUBLIC "$<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>")
    target_link_libraries(gaitway_${name} PUBLIC ${arg_LINKS} PRIVATE ${arg_PRIVATE_LINKS})
    # Options alone, no link: the exported package must not name this target.
    target_compile_options(gaitway_${name} PRIVATE $<TARGET_PROPERTY:gaitway_compiler,INTERFACE_COMPILE_OPTIONS>)
    if(arg_FREESTANDING)
      target_compile_options(gaitway_${name} PRIVATE -fno-exceptions -fno-rtti)
    else()
      gaitway_use_precompiled(gaitway_${name} gaitway_precompiled)
    endif()
  else()
    add_library(gaitway_${name} INTERFACE)
    target_include_directories(gaitway_${name} INTERFACE "$<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>")
    target_link_libraries(gaitway_${name} INTERFACE ${arg_LINKS})
  endif()
  add_library(gaitway::${name} ALIAS gaitway_${name})
endfunction()

# A plug-in: lib/gaitway/plugins/libgaitway_plugin_<name>.so.
function(gaitway_plugin name)
  gaitway_plugin_module(gaitway_plugin_${name} ${ARGN})
  target_link_libraries(gaitway_plugin_${name} PRIVATE gaitway_compiler)
  gaitway_use_precompiled(gaitway_plugin_${name} gaitway_precompiled)
endfunction()

function(gaitway_executable name)
  cmake_parse_arguments(arg "" "" "SOURCES;LINKS" ${ARGN})
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE ${arg_LINKS} gaitway_compiler)
  gaitway_use_precompiled(${name} gaitway_precompiled)
endfunction()

# Under a sanitizer, optimising what large headers bring takes half of the compiler's time; what is no hot path does without.
function(gaitway_unoptimised_if_sanitized)
  foreach(target IN LISTS ARGN)
    if(GAITWAY_SANITIZE)
      target_compile_options(${target} PRIVATE -O0)
      set_target_properties(${target} PROPERTIES DISABLE_PRECOMPILE_HEADERS ON)  # they are optimised
    endif()
  endforeach()
endfunction()

# One test binary a room; every GoogleTest case becomes a ctest case. LABELS: long for what only --long runs.
function(gaitway_test name)
  cmake_parse_arguments(arg "" "TIMEOUT" "SOURCES;LINKS;LABELS" ${ARGN})
  if(NOT arg_TIMEOUT)
    set(arg_TIMEOUT 300)
  endif()
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE ${arg_LINKS} GTest::gtest_main GTest::gmock gaitway_compiler)
  gaitway_less_optimised(${name})
  gaitway_use_precompiled(${name} gaitway_precompiled_tests)
  set(properties TIMEOUT ${arg_TIMEOUT})
  if(arg_LABELS)
    list(APPEND properties LABELS ${arg_LABELS})
  endif()
  # The renderer's own threads live in a library that the thread sanitizer cannot see into.
  if(GAITWAY_SANITIZE MATCHES "thread")
    list(APPEND properties ENVIRONMENT "TSAN_OPTIONS=ignore_noninstrumented_modules=1")
  endif()
  if("long" IN_LIST arg_LABELS AND NOT GAITWAY_LONG_TESTS)
    set_target_properties(${name} PROPERTIES EXCLUDE_FROM_ALL TRUE)  # the same sources as the short ones, built again
    return()
  endif()
  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST PROPERTIES ${properties})
endfunction()

function(gaitway_benchmark name)
  cmake_parse_arguments(arg "" "" "SOURCES;LINKS" ${ARGN})
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE ${arg_LINKS} benchmark::benchmark_main gaitway_compiler)
  set_target_properties(${name} PROPERTIES UNITY_BUILD OFF)  # each file measures one thing, with constants of its own
  gaitway_use_precompiled(${name} gaitway_precompiled)
  add_dependencies(benchmarks ${name})
endfunction()
