// From a maker's URDF to a robot's folder: everything that is found, and the files that say it.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "gaitway/importer/body_plan.hpp"
#include "gaitway/importer/drive_figures.hpp"
#include "gaitway/importer/home_posture.hpp"
#include "gaitway/importer/maker_robot.hpp"
#include "gaitway/importer/sole.hpp"

namespace gaitway::importer {

struct ImportOptions {
  ReadOptions read;
  PlanHints plan;
  std::vector<std::string> held_still;  // joints that shall not move, by name
};

struct ImuPlace {
  std::string link;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  // of the sensor in that link
  std::string why;                                         // how it was found
};

// What is brought: in its base frame, physically sound, with no more joints than are moved.
struct ImportedRobot {
  MakerRobot robot;
  BodyPlan plan;
  std::array<FoundSole, 2> soles;
  HomePosture home;
  ImuPlace imu;
  std::vector<DriveFigures> drives;     // MakerRobot::joints' order
  std::vector<std::string> held_still;  // joints that were merged, by name
  std::vector<std::string> notes;       // what was done and guessed, a sentence each
};

// Throws input::InputError with file, line, element, value, rule and remedy for what can't be brought.
[[nodiscard]] ImportedRobot import_robot(const std::filesystem::path& file, const ImportOptions& options);

// The same with the knees bent by so much at most in the home posture.
[[nodiscard]] ImportedRobot with_knees_bent(const ImportedRobot& imported, double most_bend_rad);

// The same with at most `most` joints: the others, those that carry least first, are held still at home.
// Legs keep theirs. Throws std::invalid_argument for fewer than the legs' twelve.
[[nodiscard]] ImportedRobot with_fewer_joints(const ImportedRobot& imported, std::size_t most);

// Writes robot.urdf, robot.yaml (with a comment on every guess) and meshes/ into an empty folder. Throws
// std::system_error naming the file.
void write_robot_folder(const ImportedRobot& imported, const std::filesystem::path& folder);

}  // namespace gaitway::importer
