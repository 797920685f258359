# What makes a build from nothing quick: the large headers of every file (standard library, fmt, Eigen; GoogleTest for the tests)
# compiled once, and, where CMAKE_UNITY_BUILD is on, files of one target compiled together. The preset `dev` has neither: there
# one changed file is one file to compile, and every file shows that it includes what it uses.
option(GAITWAY_PRECOMPILED_HEADERS "Compile the large headers once" ON)
set(CMAKE_UNITY_BUILD_BATCH_SIZE 10)
# One precompiled header serves libraries and programs: all are compiled position-independent in the same way.
set(CMAKE_CXX_COMPILE_OPTIONS_PIE "-fPIC")
# fmt's headers read this macro: a precompiled one demands the same answer everywhere.
add_compile_definitions(FMT_SHARED)

if(CMAKE_UNITY_BUILD)
  # A unity file includes sources, whose anonymous types gcc then takes for a header's.
  add_compile_options($<$<COMPILE_LANG_AND_ID:CXX,GNU>:-Wno-subobject-linkage>)
endif()

function(gaitway_precompiled_headers name)
  cmake_parse_arguments(arg "" "" "HEADERS;LINKS" ${ARGN})
  if(NOT GAITWAY_PRECOMPILED_HEADERS)
    return()
  endif()
  set(source "${CMAKE_BINARY_DIR}/precompiled/${name}.cpp")
  file(CONFIGURE OUTPUT "${source}" CONTENT "// Carries the precompiled headers of ${name}.\n")
  add_library(${name} OBJECT "${source}")
  target_link_libraries(${name} PRIVATE gaitway_compiler ${arg_LINKS})
  target_precompile_headers(${name} PRIVATE ${arg_HEADERS})
endfunction()

# What tests say is compiled in two thirds of the time so; what they test is optimised as it is released.
function(gaitway_less_optimised target)
  if(TARGET ${target})
    target_compile_options(${target} PRIVATE $<$<AND:$<COMPILE_LANGUAGE:CXX>,$<CONFIG:Release>>:-O1>)
  endif()
endfunction()

set(gaitway_large_headers
  <algorithm> <array> <atomic> <chrono> <cmath> <cstdint> <cstring> <deque> <filesystem> <fstream> <functional> <map> <memory> <numbers> <optional>
  <span> <stdexcept> <string> <string_view> <utility> <variant> <vector> <fmt/format.h> <Eigen/Core> <Eigen/Geometry>)
function(gaitway_declare_precompiled_headers)  # once the dependencies are known
  gaitway_precompiled_headers(gaitway_precompiled HEADERS ${gaitway_large_headers} LINKS fmt::fmt Eigen3::Eigen)
  if(GAITWAY_PART STREQUAL "tests")
    gaitway_precompiled_headers(gaitway_precompiled_tests HEADERS ${gaitway_large_headers} <gmock/gmock.h> <gtest/gtest.h>
      LINKS fmt::fmt Eigen3::Eigen GTest::gtest GTest::gmock)
    gaitway_less_optimised(gaitway_precompiled_tests)
  endif()
endfunction()

# A target that is compiled with other options than the precompiled headers goes without.
function(gaitway_use_precompiled target headers)
  get_target_property(sources ${target} SOURCES)
  if(GAITWAY_PRECOMPILED_HEADERS AND sources MATCHES "\\.cpp")
    target_precompile_headers(${target} REUSE_FROM ${headers})
  endif()
endfunction()
