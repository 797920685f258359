// What the robot was calibrated with, as a page wants it.
#pragma once

#include "gaitway/page/asset_table.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::page {

// Adds /calibration.json: when it was made, each joint's zero, the trunk's centre of mass, the cells' gains,
// each with its standard deviation, and how the IMU sits. null: nothing is known, and the robot is as
// described; `there` says whether it has a calibration at all. Angles in rad, lengths in m. Throws
// urdf::RobotError for a damaged file.
void add_calibration(AssetTable& table, const urdf::RobotModel& robot);

}  // namespace gaitway::page
