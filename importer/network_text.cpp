// The network file of a robot that was brought: what a URDF cannot say, with a comment on every guess.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include "gaitway/facts/body_scale.hpp"
#include "gaitway/importer/import.hpp"
#include "gaitway/input/written_text.hpp"
#include "robot_text.hpp"

namespace gaitway::importer {
namespace {

// What each of the legs' twelve joints brings home of the sensors.
struct LegNode {
  const char* channels;
};
constexpr std::array<std::array<LegNode, 6>, 2> kLegNodes{
    {{{{"angular_velocity_x, angular_velocity_y"},
       {"angular_velocity_z, none"},
       {"none, none"},
       {"none, none"},
       {"left_cell_front_left, left_cell_front_right"},
       {"left_cell_rear_left, left_cell_rear_right"}}},
     {{{"acceleration_x, acceleration_y"},
       {"acceleration_z, none"},
       {"none, none"},
       {"none, none"},
       {"right_cell_front_left, right_cell_front_right"},
       {"right_cell_rear_left, right_cell_rear_right"}}}}};

class NetworkText {
 public:
  explicit NetworkText(const ImportedRobot& imported)
      : imported_(imported),
        robot_(imported.robot),
        scale_(imported.home.hip_height_m, total_mass_kg(imported.robot)),
        zero_(link_poses(robot_, std::vector<double>(robot_.joints.size(), 0.0))) {}

  std::string write() {
    text_ = fmt::format(
        "# The network file of {}: what a URDF cannot say. Controllers, wire units, motors, sensors, "
        "standing posture.\n"
        "# Every key ends in its unit; angles are in degrees (_deg), everything else is SI.\n"
        "# Written from {}. What is marked 'guess' the URDF does not say: correct it where you know "
        "better.\n",
        robot_.name, in_comment(robot_.file));
    for (const std::string& note : imported_.notes) text_ += fmt::format("# - {}\n", note);
    add_defaults();
    add_joints();
    add_legs_and_feet();
    add_sensors();
    return text_;
  }

 private:
  void add_defaults() {
    const DriveFigures& leg = imported_.drives[index_of_joint(imported_.plan.legs[0].joints[3])];
    text_ += fmt::format(
        "\n# What holds for every joint that does not say otherwise: the left knee's.\n"
        "# guess: servo, armature, damping and friction are a working robot's in units of this body's mass "
        "and hip height.\n"
        "defaults:\n  count_deg: {:.4g}\n  encoder_counts_per_turn: 200000   # guess\n  servo: {}\n  motor: "
        "{}\n  home_deg: 0\n",
        leg.count_deg, servo(leg), motor(leg));
  }
  static std::string servo(const DriveFigures& drive) {
    return fmt::format("{{stiffness_Nm_per_rad: {:.4g}, damping_Nms_per_rad: {:.4g}}}",
                       drive.stiffness_Nm_per_rad, drive.damping_Nms_per_rad);
  }
  static std::string motor(const DriveFigures& drive) {
    return fmt::format(
        "{{torque_limit_Nm: {:.12g}, speed_limit_rad_per_s: {:.12g}, armature_kg_m2: {:.3g}, "
        "damping_Nms_per_rad: {:.3g}, friction_Nm: {:.3g}}}",
        drive.torque_Nm, drive.motor_speed_rad_per_s, drive.armature_kg_m2, drive.motor_damping_Nms_per_rad,
        drive.friction_Nm);
  }

  [[nodiscard]] std::size_t index_of_joint(const std::string& name) const {
    return static_cast<std::size_t>(*robot_.joint_index(name));
  }

  // Trims: hips and ankles, roll and pitch, left before right.
  [[nodiscard]] int trim_of(std::size_t side, std::size_t place) const {
    const auto turns_about = [&](std::size_t which, Eigen::Index axis) {
      const MakerJoint& joint = robot_.joints[index_of_joint(imported_.plan.legs[side].joints[which])];
      return std::abs((zero_[static_cast<std::size_t>(joint.child_link)].linear() * joint.axis)[axis]);
    };
    const auto best = [&](std::size_t from, std::size_t to, Eigen::Index axis) {
      std::size_t most = from;
      for (std::size_t i = from; i < to; ++i) {
        if (turns_about(i, axis) > turns_about(most, axis)) most = i;
      }
      return most;
    };
    const std::array<std::size_t, 4> trimmed{best(0, 3, 0), best(0, 3, 1), best(4, 6, 1), best(4, 6, 0)};
    const auto found = std::find(trimmed.begin(), trimmed.end(), place);
    return found == trimmed.end()
               ? -1
               : static_cast<int>(2 * (found - trimmed.begin()) + static_cast<std::ptrdiff_t>(side));
  }

  void add_joints() {
    text_ +=
        "\n# Parents before children: this order is the order of every joint array. node: the joint's local "
        "controller on "
        "the bus;\n# channels: the two sensor channels of its feedback frame (guess); trim_channel: its "
        "place in the "
        "trim frame.\njoints:\n";
    for (std::size_t i = 0; i < robot_.joints.size(); ++i) {
      const MakerJoint& joint = robot_.joints[i];
      text_ += fmt::format("  - {{name: {}, node: {}", input::yaml_text(joint.name), i + 1);
      for (std::size_t side = 0; side < 2; ++side) {
        const auto& leg = imported_.plan.legs[side].joints;
        const auto found = std::find(leg.begin(), leg.end(), joint.name);
        if (found == leg.end()) continue;
        const auto place = static_cast<std::size_t>(found - leg.begin());
        text_ += fmt::format(", channels: [{}]", kLegNodes[side][place].channels);
        if (const int trim = trim_of(side, place); trim >= 0)
          text_ += fmt::format(", trim_channel: {}", trim);
      }
      const DriveFigures& drive = imported_.drives[i];
      text_ += fmt::format(", home_deg: {:.10g}, count_deg: {:.4g},\n     servo: {},\n     motor: {}}}",
                           home_deg(i), drive.count_deg, servo(drive), motor(drive));
      if (!drive.guessed.empty()) text_ += fmt::format("   # guess: {}", fmt::join(drive.guessed, ", "));
      text_ += "\n";
    }
  }
  // Within the limits, however it is rounded.
  [[nodiscard]] double home_deg(std::size_t i) const {
    constexpr double kDegree = 180.0 / std::numbers::pi;
    const double angle_deg = imported_.home.angle_rad[i] * kDegree;
    return std::abs(angle_deg) < 1e-7 ? 0.0 : angle_deg;
  }

  static std::string list(const std::array<std::string, 6>& names) {
    std::vector<std::string> all;
    for (const std::string& name : names) all.push_back(input::yaml_text(name));
    return fmt::format("[{}]", fmt::join(all, ", "));
  }

  void add_legs_and_feet() {
    text_ += fmt::format("\n# Each leg from the base to the foot.\nlegs:\n  left: {}\n  right: {}\n",
                         list(imported_.plan.legs[0].joints), list(imported_.plan.legs[1].joints));
    text_ +=
        "\n# The sole frame lies on the ground below the ankle, x forward, z up; centre_m is the middle of "
        "the sole rectangle in "
        "it.\n# One force cell in each corner, cell_inset_m from both edges (guess).\nfeet:\n";
    for (std::size_t side = 0; side < 2; ++side) {
      const FoundSole& sole = imported_.soles[side];
      const Eigen::Vector3d& at = sole.pose.translation();
      const Eigen::Vector3d rpy_deg = rpy_of(sole.pose.linear()) * 180.0 / std::numbers::pi;
      text_ += fmt::format(
          "  {}: {{link: {}, sole_position_m: [{:.6g}, {:.6g}, {:.6g}], sole_rotation_rpy_deg: [{:.6g}, "
          "{:.6g}, {:.6g}],\n"
          "         size_m: [{:.5g}, {:.5g}], centre_m: [{:.5g}, {:.5g}], cell_inset_m: {:.3g}}}   # {}\n",
          side == 0 ? "left" : "right", input::yaml_text(imported_.plan.legs[side].foot), at.x(), at.y(),
          at.z(), rpy_deg.x(), rpy_deg.y(), rpy_deg.z(), sole.size_m.x(), sole.size_m.y(), sole.centre_m.x(),
          sole.centre_m.y(), 0.06 * sole.size_m.minCoeff(), sole.source);
    }
  }

  void add_sensors() {
    const ImuPlace& imu = imported_.imu;
    const Eigen::Vector3d rpy_deg = rpy_of(imu.pose.linear()) * 180.0 / std::numbers::pi;
    text_ += fmt::format(
        "\n# Gyro and accelerometer: {}.\nimu: {{link: {}, position_m: [{:.6g}, "
        "{:.6g}, {:.6g}], "
        "rotation_rpy_deg: [{:.6g}, {:.6g}, {:.6g}]}}\n",
        imu.why, input::yaml_text(imu.link), imu.pose.translation().x(), imu.pose.translation().y(),
        imu.pose.translation().z(), rpy_deg.x(), rpy_deg.y(), rpy_deg.z());
    const double force = scale_.factor("N");
    text_ += fmt::format(
        "\n# Sensor unit for one count of a 16-bit channel (guess).\nchannel_scale: {{force_N: {:.3g}, "
        "angular_velocity_rad_per_s: 0.001, acceleration_m_per_s2: 0.005}}\n\n"
        "trim: {{count_deg: 0.05, slew_deg_per_s: {:.4g}, limit_deg: 6.35}}\n\nnetwork: {{profile: full}}\n\n"
        "standing: {{hip_height_m: {:.9g}}}      # of the hip axes above the soles in the home posture\n\n"
        "# For the simulated robot: standard deviations of the sensors' noise, ground contact, time step "
        "(guess).\nsimulation:\n"
        "  noise: {{angular_velocity_rad_per_s: 0.01, acceleration_m_per_s2: 0.15, inclination_rad: 0.003, "
        "force_N: {:.3g}}}\n"
        "  contact: {{friction: 0.8}}\n  physics_step_s: 0.001\n",
        0.01 * force, 200.0 * scale_.factor("1/s"), imported_.home.hip_height_m, 0.2 * force);
  }

  const ImportedRobot& imported_;
  const MakerRobot& robot_;
  facts::BodyScale scale_;
  std::vector<Eigen::Isometry3d> zero_;
  std::string text_;
};

}  // namespace

Eigen::Vector3d rpy_of(const Eigen::Matrix3d& r) {
  const double pitch = std::atan2(-r(2, 0), std::hypot(r(0, 0), r(1, 0)));
  constexpr double kLocked = 1e-9;
  if (std::hypot(r(0, 0), r(1, 0)) < kLocked) return {0.0, pitch, std::atan2(-r(0, 1), r(1, 1))};
  return {std::atan2(r(2, 1), r(2, 2)), pitch, std::atan2(r(1, 0), r(0, 0))};
}

std::string in_comment(const std::filesystem::path& file) {
  std::string name = input::one_line(file.filename().string());
  for (std::size_t at = name.find("--"); at != std::string::npos; at = name.find("--", at)) name[at] = '_';
  return name;
}

std::string network_text(const ImportedRobot& imported) {
  return NetworkText(imported).write();
}

}  // namespace gaitway::importer
