// What a robot's body measures in, from its description.
#include "gaitway/instance/parameter_unit.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::core {

BodyUnits body_units_of(const std::filesystem::path& robot_directory) {
  const urdf::RobotModel robot = urdf::load_robot(robot_directory);
  return {.hip_height_m = robot.hip_height_m, .mass_kg = robot.total_mass_kg()};
}

}  // namespace gaitway::core
