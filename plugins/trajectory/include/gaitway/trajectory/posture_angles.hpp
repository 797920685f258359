// Joint angles as people write them into a robot's files of motions and fall postures: by the joint's name,
// or of both sides at once.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gaitway/input/yaml_value.hpp"
#include "gaitway/urdf/body_joints.hpp"
#include "gaitway/urdf/forward_kinematics.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::trajectory {

struct JointAngle {
  int joint = 0;  // index into RobotModel::joints
  double angle_rad = 0.0;
};

// Reads the fields `joints: {NAME: angle in deg}` and `symmetric: {NAME: angle in deg}`. NAME of a symmetric
// angle is that of the left joint, with or without the `left_` that it may begin with; the right joint, which
// does the same there (urdf::BodyJoints), has the mirror image. Not thread-safe.
class PostureReader {
 public:
  explicit PostureReader(const urdf::RobotModel& robot);  // keeps a reference

  // Of the map that holds these fields; other fields are not looked at. Throws urdf::RobotError: an unknown
  // joint, one with two angles, an angle beyond its stops, joints that are no mirror images of each other.
  [[nodiscard]] std::vector<JointAngle> read(const input::YamlValue& map);

  // The mirror image of a posture. Throws std::invalid_argument that names a joint that has none.
  [[nodiscard]] std::vector<JointAngle> mirrored(const std::vector<JointAngle>& angles);

 private:
  [[nodiscard]] int joint_named(const input::YamlValue& value, const std::string& name) const;
  void add(const input::YamlValue& value, int joint, double angle_rad, std::vector<JointAngle>& angles) const;
  void add_both_sides(const input::YamlValue& value, const std::string& name,
                      std::vector<JointAngle>& angles);
  const urdf::BodyJoints& body();

  const urdf::RobotModel& robot_;
  urdf::ForwardKinematics home_;
  std::optional<urdf::BodyJoints> body_;  // once it is needed
};

}  // namespace gaitway::trajectory
