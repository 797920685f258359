# Language level, warnings and code generation shared by every target, as the interface target gaitway_compiler.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_C_STANDARD 11)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_CXX_VISIBILITY_PRESET hidden)
set(CMAKE_C_VISIBILITY_PRESET hidden)
set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/bin")
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/lib/gaitway/plugins")

if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM)
  set(CMAKE_C_COMPILER_LAUNCHER "${CCACHE_PROGRAM}")
  set(CMAKE_CXX_COMPILER_LAUNCHER "${CCACHE_PROGRAM}")
endif()

add_library(gaitway_compiler INTERFACE)
target_compile_options(gaitway_compiler INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wcast-align
  $<$<COMPILE_LANGUAGE:CXX>:-Wnon-virtual-dtor>
  # gcc 12 takes the concatenation of a literal and a string for overlapping memory (its bug 105651).
  $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-Wno-restrict>
  # Unloadable plug-ins: a unique symbol would pin the library in memory for ever.
  $<$<CXX_COMPILER_ID:GNU>:-fno-gnu-unique>
  # The same bits on every build: no fused multiply-add that depends on the optimiser's mood.
  -ffp-contract=off
  # Two build directories give the same binaries.
  "-ffile-prefix-map=${CMAKE_SOURCE_DIR}=.")
if(GAITWAY_WARNINGS_AS_ERRORS)
  target_compile_options(gaitway_compiler INTERFACE -Werror)
endif()
if(GAITWAY_SANITIZE)
  # What they add to the code makes gcc 12 see strings written beyond their ends, and members of std::regex used before they are set.
  target_compile_options(gaitway_compiler INTERFACE -fsanitize=${GAITWAY_SANITIZE} -fno-omit-frame-pointer
    $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-Wno-array-bounds> $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-Wno-stringop-overflow>
    $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-Wno-maybe-uninitialized>)
  target_link_options(gaitway_compiler INTERFACE -fsanitize=${GAITWAY_SANITIZE})
  # Eigen pads what it allocates under the address sanitizer; a distribution's Ceres, which is linked into the same program, does not,
  # and frees what was padded. Allocations are aligned without padding, too.
  target_compile_options(gaitway_compiler INTERFACE -DEIGEN_MALLOC_ALREADY_ALIGNED=1)
  if(GAITWAY_SANITIZE MATCHES "undefined")
    target_compile_options(gaitway_compiler INTERFACE -fno-sanitize-recover=undefined)
    # A third of the compile time goes into checks of every pointer that is followed: the address sanitizer sees null and freed
    # ones, too, and the fuzz targets (clang) look at alignment in all that decodes.
    target_compile_options(gaitway_compiler INTERFACE
      $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-fno-sanitize=null,alignment,object-size,vptr>)
  endif()
  if(GAITWAY_SANITIZE MATCHES "thread")
    # Asio's stand-alone fences are what this sanitizer cannot see; what they guard is guarded by its locks, too.
    target_compile_options(gaitway_compiler INTERFACE -DBOOST_ASIO_DISABLE_FENCED_BLOCK)
  endif()
endif()
