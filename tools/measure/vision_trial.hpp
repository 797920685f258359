// One simulated robot before one box and one tag: how far from the truth is what its eyes say of them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "gaitway/instance/configuration.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::tools {

struct VisionTrial {
  double range_m = 1.0;  // from the camera, along the ground, to the box's near side and to the tag
  bool walks = false;    // towards them, at 0.2 m/s
  std::uint64_t seed = 1;
};

// What the pairs of pictures gave that were taken at that range, within 0.15 m.
struct VisionOutcome {
  std::vector<double> obstacle_error_m;   // of the middle of the box's near side
  std::vector<double> tag_range_error;    // share of the range
  std::vector<double> tag_place_error_m;  // of its middle, in odometry
  std::vector<double> delay_s;            // from the exposure to the topic
  int pairs = 0;
  int without_obstacle = 0, without_tag = 0;  // of these pairs
  int phantoms = 0;                           // boxes told, of all these pairs, with nothing there
  int false_tags = 0;
  std::string fault;  // told last; empty: none
};

struct VisionRobot {
  urdf::RobotModel model;
  core::Configuration plugins;
};

// Throws what the co-simulation throws.
[[nodiscard]] VisionOutcome run_vision_trial(const VisionRobot& robot, const VisionTrial& trial);

}  // namespace gaitway::tools
