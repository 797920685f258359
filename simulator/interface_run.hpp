// Runs the virtual robot on a CAN interface in real time.
#pragma once

#include <filesystem>
#include <string>

#include "gaitway/simulator/plant.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::simulator {

struct InterfaceRun {
  std::string interface;
  std::filesystem::path summary;   // empty: the terminal
  std::filesystem::path walk_log;  // empty: none
  std::filesystem::path sent_log;  // empty: none
  PlantOptions plant;
  double seconds = 0.0;  // 0: until told to stop
  int priority = 0;      // SCHED_FIFO
};

// Returns when its time is over or it is told to stop. Throws can::BusError when the interface cannot be used
// at the start, std::runtime_error when a file cannot be written.
void run_on_interface(const urdf::RobotModel& robot, const InterfaceRun& options);

}  // namespace gaitway::simulator
