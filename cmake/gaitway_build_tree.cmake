# Files that programs read, linked into the build tree in the layout of an installation: see
# process/include/gaitway/process/installation.hpp.
function(gaitway_shared_folder name source)
  file(MAKE_DIRECTORY "${CMAKE_BINARY_DIR}/share/gaitway")
  file(CREATE_LINK "${PROJECT_SOURCE_DIR}/${source}" "${CMAKE_BINARY_DIR}/share/gaitway/${name}" SYMBOLIC)
endfunction()
gaitway_shared_folder(urdf urdf)
gaitway_shared_folder(config core/config)
gaitway_shared_folder(scenarios tools/scenarios)
gaitway_shared_folder(worlds tools/worlds)
gaitway_shared_folder(missions plugins/behaviour/missions)
gaitway_shared_folder(templates tools/new_plugin/templates)
gaitway_shared_folder(calibration tools/calibrate/poses)
