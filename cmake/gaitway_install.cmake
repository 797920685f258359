# What is installed and packaged, and the same layout and CMake package in the build tree. See
# process/include/gaitway/process/installation.hpp for the layout.
include(CMakePackageConfigHelpers)
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)  # packaging takes what is built; tests need not be

set(gaitway_package_folder lib/cmake/gaitway)
set(gaitway_built_package "${CMAKE_BINARY_DIR}/${gaitway_package_folder}")
set(gaitway_shipped_plugins gaitway_plugin_trajectory gaitway_plugin_kinematics gaitway_plugin_zmp gaitway_plugin_stability
    gaitway_plugin_navigation gaitway_plugin_behaviour gaitway_plugin_api)
set(gaitway_author_libraries facts geometry plugin msgclient_topics simulated_robot_headers process msgclient input urdf
    trajectory kinematics zmp stability behaviour behaviour_leaves behaviour_missions behaviour_plugin)

install(DIRECTORY urdf/humanoid22 DESTINATION share/gaitway/urdf)
set(gaitway_left_out "")
if(NOT TARGET gaitway_plugin_vision)
  set(gaitway_left_out PATTERN eyes.yaml EXCLUDE)  # of the plug-in that sees
endif()
install(DIRECTORY core/config tools/scenarios tools/worlds plugins/behaviour/missions tools/new_plugin/templates DESTINATION share/gaitway
  ${gaitway_left_out})
install(DIRECTORY "${CMAKE_BINARY_DIR}/share/gaitway/prepared_motions/humanoid22/" DESTINATION share/gaitway/urdf/humanoid22/motions)
install(DIRECTORY tools/calibrate/poses/ DESTINATION share/gaitway/calibration)
install(DIRECTORY docs/ DESTINATION share/doc/gaitway PATTERN CMakeLists.txt EXCLUDE)
install(FILES LICENSE DESTINATION share/doc/gaitway)
# A robot as a service, which nobody is made to have: docs/robot.md.
install(FILES tools/robot/systemd/gaitway-robot.service DESTINATION lib/systemd/system)
install(FILES tools/robot/systemd/gaitway.conf DESTINATION lib/sysusers.d)
install(FILES tools/robot/systemd/robot.env DESTINATION share/gaitway)

# Programs and what they load.
get_property(gaitway_programs GLOBAL PROPERTY gaitway_programs)
if(TARGET gaitway_plugin_vision)
  list(APPEND gaitway_shipped_plugins gaitway_plugin_vision)
endif()
foreach(program IN ITEMS gaitway ${gaitway_programs} main_controller gaitway_plugin_child message_controller virtual_robot user_interface)
  set_target_properties(${program} PROPERTIES INSTALL_RPATH "$ORIGIN/../lib/gaitway")
  install(TARGETS ${program} RUNTIME DESTINATION bin)
endforeach()
install(TARGETS ${gaitway_shipped_plugins} LIBRARY DESTINATION lib/gaitway/plugins)
set_target_properties(gaitway_simulated_robot PROPERTIES INSTALL_RPATH "$ORIGIN")
install(TARGETS gaitway_simulated_robot LIBRARY DESTINATION lib/gaitway)
install(FILES "${gaitway_mujoco_library}" DESTINATION lib/gaitway)

# Headers: the plug-in interface, and of msgclient what it includes.
install(DIRECTORY core/plugin/include/ DESTINATION include)
install(FILES msgclient/include/gaitway/msgclient/type_descriptor.hpp msgclient/include/gaitway/msgclient/bow_curve.hpp msgclient/include/gaitway/msgclient/trim_law.hpp
              "${CMAKE_BINARY_DIR}/msgclient/generated/gaitway/msgclient/topics.h"
              "${CMAKE_BINARY_DIR}/msgclient/generated/gaitway/msgclient/topics.hpp"
        DESTINATION include/gaitway/msgclient)
install(FILES simulator/include/gaitway/simulator/simulated_robot.hpp DESTINATION include/gaitway/simulator)
install(DIRECTORY facts/include/ geometry/include/ input/include/ urdf/include/ plugins/trajectory/include/ plugins/kinematics/include/ plugins/zmp/include/
                  plugins/stability/include/ behaviour/include/ plugins/behaviour/include/ DESTINATION include)

# The CMake package and the pkg-config file.
foreach(library IN LISTS gaitway_author_libraries)
  set_target_properties(gaitway_${library} PROPERTIES EXPORT_NAME ${library})
  install(TARGETS gaitway_${library} EXPORT gaitway ARCHIVE DESTINATION lib/gaitway INCLUDES DESTINATION include)
endforeach()
install(EXPORT gaitway NAMESPACE gaitway:: FILE gaitwayTargets.cmake DESTINATION ${gaitway_package_folder})
export(EXPORT gaitway NAMESPACE gaitway:: FILE "${gaitway_built_package}/gaitwayTargets.cmake")
configure_file(cmake/gaitwayConfig.cmake.in "${gaitway_built_package}/gaitwayConfig.cmake" @ONLY)
write_basic_package_version_file("${gaitway_built_package}/gaitwayConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
foreach(file IN ITEMS cmake/plugin.map cmake/gaitway_plugin_module.cmake msgclient/schema/generate_topics.cmake
        msgclient/schema/generate.py)
  configure_file(${file} "${gaitway_built_package}" COPYONLY)
  get_filename_component(name ${file} NAME)
  install(FILES "${gaitway_built_package}/${name}" DESTINATION ${gaitway_package_folder})
endforeach()
install(FILES "${gaitway_built_package}/gaitwayConfig.cmake" "${gaitway_built_package}/gaitwayConfigVersion.cmake"
        DESTINATION ${gaitway_package_folder})
configure_file(cmake/gaitway-plugin.pc.in "${CMAKE_BINARY_DIR}/lib/pkgconfig/gaitway-plugin.pc" @ONLY)
install(FILES "${CMAKE_BINARY_DIR}/lib/pkgconfig/gaitway-plugin.pc" DESTINATION lib/pkgconfig)

# One Debian package. Recommended: what building a plug-in and drawing pictures take.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "The Gaitway developers <gaitway@localhost>")
set(CPACK_PACKAGE_VENDOR "Gaitway")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA "${PROJECT_SOURCE_DIR}/tools/robot/systemd/postinst")
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${GAITWAY_MUJOCO_DIR}")
set(gaitway_recommended g++ cmake make libgtest-dev libgmock-dev libeigen3-dev liborocos-kdl-dev liburdfdom-dev
    libtinyxml2-dev libyaml-cpp-dev libfmt-dev zlib1g-dev libegl1 libgl1-mesa-dri)
list(JOIN gaitway_recommended ", " CPACK_DEBIAN_PACKAGE_RECOMMENDS)
include(CPack)
