# Third-party libraries: distribution packages, and the MuJoCo wheel that ./dev unpacks into .deps/mujoco.
find_package(Threads REQUIRED)
find_package(Eigen3 REQUIRED)
find_package(orocos_kdl REQUIRED)
find_package(urdfdom REQUIRED)
find_package(tinyxml2 REQUIRED)
find_package(yaml-cpp REQUIRED)
find_package(fmt REQUIRED)
find_package(CLI11 REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(Ceres 2.1 REQUIRED)
find_package(PNG REQUIRED)
find_package(ZLIB REQUIRED)
find_package(Python3 3.11 REQUIRED COMPONENTS Interpreter)
if(NOT GAITWAY_PART STREQUAL "run")
  find_package(Boost 1.74 REQUIRED)
  find_package(OpenSSL 3.0 REQUIRED)
endif()
if(GAITWAY_PART STREQUAL "tests")
  find_package(GTest REQUIRED)
  include(GoogleTest)
endif()
if(GAITWAY_BENCHMARKS)
  find_package(benchmark REQUIRED)
endif()

set(GAITWAY_MUJOCO_DIR "${PROJECT_SOURCE_DIR}/.deps/mujoco" CACHE PATH
    "Folder with libmujoco.so.4.0.0 and include/mujoco/mujoco.h (./dev setup fills the default)")
if(SKBUILD AND NOT EXISTS "${GAITWAY_MUJOCO_DIR}")  # pip has it beside what else it builds with
  execute_process(COMMAND "${Python3_EXECUTABLE}" -c "from importlib.metadata import distribution as d; print(d('mujoco-core').locate_file('mujoco'))"
    OUTPUT_VARIABLE GAITWAY_MUJOCO_DIR OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
endif()
set(gaitway_mujoco_library "${GAITWAY_MUJOCO_DIR}/libmujoco.so.4.0.0")
if(NOT EXISTS "${gaitway_mujoco_library}")
  message(FATAL_ERROR "MuJoCo 4.0.0 not found: ${gaitway_mujoco_library} is missing. "
                      "Run './dev setup', or set GAITWAY_MUJOCO_DIR to an unpacked mujoco-core 4.0.0 wheel.")
endif()
add_library(mujoco::mujoco SHARED IMPORTED)
set_target_properties(mujoco::mujoco PROPERTIES
  IMPORTED_LOCATION "${gaitway_mujoco_library}"
  INTERFACE_INCLUDE_DIRECTORIES "${GAITWAY_MUJOCO_DIR}/include")
