// The simulated robot as the API serves it.
#pragma once

#include <filesystem>

#include "gaitway/simulator/cosimulation.hpp"

namespace gaitway::api {

inline simulator::CosimulationOptions served_walk() {
  const std::filesystem::path source = GAITWAY_SOURCE_DIR;
  simulator::CosimulationOptions result;
  result.people_outside = true;
  result.main_controller.configuration = source / "core" / "config" / "walk.yaml";
  result.main_controller.plugin_path = {GAITWAY_PLUGIN_DIR};
  return result;
}

}  // namespace gaitway::api
