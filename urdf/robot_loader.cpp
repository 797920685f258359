// Joins robot.urdf and robot.yaml into one robot model.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <stdexcept>

#include "gaitway/input/complaint.hpp"
#include "gaitway/urdf/forward_kinematics.hpp"
#include "gaitway/urdf/leg_joints.hpp"
#include "robot_files.hpp"

namespace gaitway::urdf {
namespace {

KDL::Vector vector_of(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

KDL::Frame frame_of(const Eigen::Isometry3d& pose) {
  const Eigen::Matrix3d r = pose.linear();
  return {KDL::Rotation(r(0, 0), r(0, 1), r(0, 2), r(1, 0), r(1, 1), r(1, 2), r(2, 0), r(2, 1), r(2, 2)),
          vector_of(pose.translation())};
}

KDL::RigidBodyInertia inertia_of(const Link& link) {
  const Eigen::Matrix3d& i = link.inertia_kg_m2;
  return KDL::RigidBodyInertia(link.mass_kg, vector_of(link.com_m),
                               KDL::RotationalInertia(i(0, 0), i(1, 1), i(2, 2), i(0, 1), i(0, 2), i(1, 2)));
}

// Segments bear the links' names, KDL joints the joints'. The model's links and joints must be complete.
KDL::Tree make_kdl_tree(const RobotModel& model) {
  KDL::Tree tree(model.links.front().name);
  for (const Joint& joint : model.joints) {
    const Link& parent = model.links[static_cast<std::size_t>(joint.parent_link)];
    const Link& child = model.links[static_cast<std::size_t>(joint.child_link)];
    const KDL::Frame origin = frame_of(joint.origin);
    const KDL::Joint kdl_joint(joint.name, origin.p, origin.M * vector_of(joint.axis), KDL::Joint::RotAxis);
    tree.addSegment(KDL::Segment(child.name, kdl_joint, origin, inertia_of(child)), parent.name);
  }
  return tree;
}

constexpr double kHeightTolerance_m = 0.001;
constexpr double kLevelTolerance_rad = 0.01;

class Assembly {
 public:
  Assembly(const UrdfFile& urdf, const NetworkFile& network) : urdf_(urdf), network_(network) {}

  RobotModel assemble(const std::filesystem::path& directory, CalibrationUse calibration) {
    model_.name = urdf_.name;
    model_.directory = directory;
    add_link(urdf_.base_link, -1);
    for (const NetworkJoint& drive : network_.joints) {
      add_joint(drive);
    }
    require_all_joints();
    for (const Side side : kSides) {
      add_leg(static_cast<std::size_t>(side));
    }
    model_.imu = network_.imu;
    model_.imu.link = find_link(network_.imu_link, network_.imu_line, "imu.link");
    model_.noise = network_.noise;
    model_.parts_deviation = network_.parts_deviation;
    model_.contact = network_.contact;
    model_.trim = network_.trim;
    model_.network = network_.network;
    model_.physics_step_s = network_.physics_step_s;
    model_.hip_height_m = network_.hip_height_m;
    check_standing();
    check_inclinometer();
    const std::filesystem::path found = directory / "calibration.yaml";
    if (calibration == CalibrationUse::applied && std::filesystem::exists(found)) {
      apply_calibration_file(found, model_);
    }
    model_.tree = make_kdl_tree(model_);
    return std::move(model_);
  }

 private:
  [[noreturn]] void refuse_network(int line, const std::string& field, const std::string& value,
                                   const std::string& rule, const std::string& remedy) const {
    input::refuse({network_.file, line, field, value, rule, remedy});
  }

  void add_link(const std::string& name, int parent_joint) {
    const auto found = std::find_if(urdf_.links.begin(), urdf_.links.end(),
                                    [&name](const Link& link) { return link.name == name; });
    link_of_name_[name] = static_cast<int>(model_.links.size());
    model_.links.push_back(*found);
    model_.links.back().parent_joint = parent_joint;
  }

  // The URDF's half of a joint of the network file.
  const UrdfJoint& geometry_of(const NetworkJoint& drive) const {
    std::vector<std::string> names;
    for (const UrdfJoint& candidate : urdf_.joints) {
      if (candidate.joint.name == drive.joint.name) {
        return candidate;
      }
      names.push_back(candidate.joint.name);
    }
    refuse_network(drive.line, "joint name", "'" + drive.joint.name + "'",
                   "there is no such joint in " + urdf_.file.filename().string(),
                   input::suggest(drive.joint.name, names));
  }

  void add_joint(const NetworkJoint& drive) {
    const UrdfJoint& geometry = geometry_of(drive);
    check_drive(urdf_, geometry, network_, drive);
    const auto parent = link_of_name_.find(geometry.parent_link);
    if (parent == link_of_name_.end()) {
      refuse_network(
          drive.line, "joints", "'" + drive.joint.name + "'",
          fmt::format("its parent link '{}' hangs on a joint further down: parents come before children",
                      geometry.parent_link),
          "Move the joint below the one that carries this link");
    }
    Joint joint = drive.joint;
    joint.origin = geometry.joint.origin;
    joint.axis = geometry.joint.axis.normalized();
    joint.lower_rad = geometry.joint.lower_rad;
    joint.upper_rad = geometry.joint.upper_rad;
    joint.velocity_limit_rad_per_s = geometry.joint.velocity_limit_rad_per_s;
    joint.parent_link = parent->second;
    joint.child_link = static_cast<int>(model_.links.size());
    add_link(geometry.child_link, static_cast<int>(model_.joints.size()));
    model_.joints.push_back(joint);
    model_.channels.push_back(drive.channels);
  }

  void require_all_joints() const {
    std::vector<std::string> listed;
    for (const Joint& joint : model_.joints) {
      listed.push_back(joint.name);
    }
    for (const UrdfJoint& candidate : urdf_.joints) {
      const std::string& name = candidate.joint.name;
      if (std::find(listed.begin(), listed.end(), name) == listed.end()) {
        input::refuse({urdf_.file, candidate.line, "joint", "'" + name + "'",
                       "the joint has no local controller in " + network_.file.filename().string(),
                       "Add it to 'joints' there. Nearest name there: '" +
                           input::nearest_name(name, listed).value_or("none") + "'"});
      }
    }
  }

  int find_link(const std::string& name, int line, const std::string& field) const {
    if (const auto found = link_of_name_.find(name); found != link_of_name_.end()) {
      return found->second;
    }
    std::vector<std::string> names;
    for (const Link& link : model_.links) {
      names.push_back(link.name);
    }
    refuse_network(line, field, "'" + name + "'",
                   "there is no such link in " + urdf_.file.filename().string(), input::suggest(name, names));
  }

  // Six joints, each hanging on the one before, the first on the base, the last carrying the foot.
  void add_leg(std::size_t side) {
    const std::string prefix = side == 0 ? "left" : "right";
    Foot& foot = model_.feet[side];
    foot = network_.feet[side];
    foot.link = find_link(network_.foot_link[side], network_.foot_line[side], "feet." + prefix + ".link");
    std::vector<std::string> names;
    for (const Joint& joint : model_.joints) {
      names.push_back(joint.name);
    }
    int link = 0;
    const std::vector<std::string>& chain = network_.leg_joints[side];
    for (std::size_t i = 0; i < chain.size(); ++i) {
      const auto found = std::find(names.begin(), names.end(), chain[i]);
      const std::string field = fmt::format("legs.{}[{}]", prefix, i);
      if (found == names.end()) {
        refuse_network(network_.leg_line[side], field, "'" + chain[i] + "'", "there is no such joint",
                       input::suggest(chain[i], names));
      }
      const auto index = static_cast<std::size_t>(found - names.begin());
      const Joint& joint = model_.joints[index];
      if (joint.parent_link != link) {
        refuse_network(
            network_.leg_line[side], field, "'" + chain[i] + "'",
            fmt::format("must hang on the link '{}'", model_.links[static_cast<std::size_t>(link)].name),
            "List the leg's six joints from the base to the foot");
      }
      model_.legs[side].joints[i] = static_cast<int>(index);
      link = joint.child_link;
    }
    if (link != foot.link) {
      refuse_network(
          network_.foot_line[side], "feet." + prefix + ".link", "'" + network_.foot_link[side] + "'",
          fmt::format("the leg ends at the link '{}'", model_.links[static_cast<std::size_t>(link)].name),
          "Name the link behind the last of the leg's six joints");
    }
  }

  LegJoints leg_joints(const ForwardKinematics& home, Side side) const {
    try {
      return {model_, home, side};
    } catch (const std::invalid_argument& lacking) {
      const auto leg = static_cast<std::size_t>(side);
      refuse_network(
          network_.leg_line[leg], fmt::format("legs.{}", side == Side::left ? "left" : "right"), "",
          lacking.what(),
          "List six joints: three of the hip (yaw, roll and pitch in any order), the knee, two of the "
          "ankle; check their axes in the URDF");
    }
  }

  // In the home posture the soles are level, as far below the hips as the file says.
  void check_standing() const {
    const ForwardKinematics home(model_);
    for (const Side side : kSides) {
      const char* name = side == Side::left ? "left" : "right";
      const Joint& hip_pitch =
          model_.joints[static_cast<std::size_t>(leg_joints(home, side)[LegJoint::hip_pitch])];
      const Eigen::Isometry3d sole = home.sole_pose(side);
      const double height_m = home.link_position_m(hip_pitch.child_link).z() - sole.translation().z();
      if (std::acos(std::min(1.0, sole.linear()(2, 2))) > kLevelTolerance_rad) {
        refuse_network(network_.hip_height_line, "standing", "",
                       fmt::format("in the home posture the {} sole is not level", name),
                       "Choose home_deg of hip pitch, knee and ankle pitch so that they cancel");
      }
      if (std::abs(height_m - model_.hip_height_m) > kHeightTolerance_m) {
        refuse_network(
            network_.hip_height_line, "standing.hip_height_m", fmt::format("{:g}", model_.hip_height_m),
            fmt::format("in the home posture the {} hip is {:.4f} m above the sole", name, height_m),
            "Make home_deg of the leg and this height agree");
      }
    }
  }

  // Roll and pitch of a sensor that lies on its side or its back jump by a turn in the middle of their range.
  void check_inclinometer() const {
    constexpr double kUpright = 0.5;  // cosine of 60 deg
    const ForwardKinematics home(model_);
    const Eigen::Matrix3d sensor = home.link_rotation(model_.imu.link) * model_.imu.pose.linear();
    if (!model_.carries(SensorKind::inclination) && model_.imu.inclinometer == Inclinometer::pendulum) {
      refuse_network(network_.imu_line, "imu.inclinometer", "pendulum",
                     "no joint carries inclination channels", "Name its channels, or leave this key out");
    }
    if (!model_.carries(SensorKind::inclination) || sensor(2, 2) > kUpright) return;
    refuse_network(
        network_.imu_line, "imu.rotation_rpy_deg", "",
        fmt::format("in the home posture the sensor's z axis is {:.0f} deg from up, and an inclinometer "
                    "tells no roll and pitch there",
                    std::acos(std::clamp(sensor(2, 2), -1.0, 1.0)) * 180.0 / std::numbers::pi),
        "Leave the inclination channels out: they are derived from gyro and accelerometer");
  }

  const UrdfFile& urdf_;
  const NetworkFile& network_;
  RobotModel model_;
  std::map<std::string, int> link_of_name_;
};

}  // namespace

RobotModel load_robot(const std::filesystem::path& directory, CalibrationUse calibration) {
  const UrdfFile urdf = read_urdf_file(directory / "robot.urdf");
  const NetworkFile network = read_network_file(directory / "robot.yaml");
  return Assembly(urdf, network).assemble(directory, calibration);
}

}  // namespace gaitway::urdf
