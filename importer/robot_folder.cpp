// Writes what was found as the files that a robot's folder holds.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cmath>
#include <fstream>
#include <numbers>
#include <stdexcept>
#include <system_error>

#include "gaitway/facts/body_scale.hpp"
#include "gaitway/importer/import.hpp"
#include "gaitway/input/text.hpp"

namespace gaitway::importer {
namespace {

constexpr std::size_t kCollisionPoints = 48, kVisualPoints = 160;
constexpr double kSmallest_m = 0.004;  // a surface that is no longer is left out
constexpr double kLeastVolume_m3 = 1e-8;

std::string numbers(const Eigen::Vector3d& v) {
  const auto clean = [](double value) { return std::abs(value) < 1e-12 ? 0.0 : value; };
  return fmt::format("{:.12g} {:.12g} {:.12g}", clean(v.x()), clean(v.y()), clean(v.z()));
}

Eigen::Vector3d rpy_of(const Eigen::Matrix3d& r) {
  const double pitch = std::atan2(-r(2, 0), std::hypot(r(0, 0), r(1, 0)));
  constexpr double kLocked = 1e-9;
  if (std::hypot(r(0, 0), r(1, 0)) < kLocked) return {0.0, pitch, std::atan2(-r(0, 1), r(1, 1))};
  return {std::atan2(r(2, 1), r(2, 2)), pitch, std::atan2(r(1, 0), r(0, 0))};
}

std::string origin(const Eigen::Isometry3d& pose) {
  return fmt::format("<origin xyz=\"{}\" rpy=\"{}\"/>", numbers(pose.translation()),
                     numbers(rpy_of(pose.linear())));
}

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '&') {
      result += "&amp;";
    } else if (c == '<') {
      result += "&lt;";
    } else if (c == '"') {
      result += "&quot;";
    } else {
      result += c;
    }
  }
  return result;
}

// The file's name on one line, without what would end an XML comment.
std::string in_comment(const std::filesystem::path& file) {
  std::string name = input::terminal_text(file.filename().string());
  for (std::size_t at = name.find("--"); at != std::string::npos; at = name.find("--", at)) name[at] = '_';
  return name;
}

// A name as YAML takes it anywhere.
std::string quoted(const std::string& name) {
  const auto plain = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; };
  if (!name.empty() && std::all_of(name.begin(), name.end(), plain) &&
      std::isalpha(static_cast<unsigned char>(name[0])) != 0) {
    return name;
  }
  std::string result = "\"";
  for (const char c : name) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + "\"";
}

void write_text(const std::filesystem::path& file, const std::string& text) {
  std::ofstream stream(file, std::ios::binary);
  stream << text;
  stream.close();
  if (!stream) throw std::system_error(errno, std::generic_category(), file.string());
}

// Names come from strangers: what is no letter or digit stays out, and the link's number keeps apart what is
// then alike.
std::string file_name(std::size_t index, const std::string& link, const char* kind, std::size_t number) {
  std::string name;
  for (const char c : link) name += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  constexpr std::size_t kLongest = 60;
  name.resize(std::min(name.size(), kLongest));
  return fmt::format("{:02}_{}_{}_{}.stl", index, name, kind, number);
}

double volume_m3(const Surface& hull) {
  double six = 0.0;
  const Eigen::Vector3d& from = hull.point_m.front();
  for (const std::array<int, 3>& triangle : hull.triangle) {
    const auto corner = [&](std::size_t i) {
      return Eigen::Vector3d(hull.point_m[static_cast<std::size_t>(triangle[i])] - from);
    };
    six += corner(0).dot(corner(1).cross(corner(2)));
  }
  return six / 6.0;
}

class UrdfText {
 public:
  UrdfText(const ImportedRobot& imported, const std::filesystem::path& folder)
      : imported_(imported), robot_(imported.robot), folder_(folder) {}

  std::string write() {
    text_ = fmt::format(
        "<?xml version=\"1.0\"?>\n<!-- Made from {}: fixed joints merged, shapes as their convex hulls. -->\n"
        "<robot name=\"{}\">\n",
        in_comment(robot_.file), escaped(robot_.name));
    for (std::size_t i = 0; i < robot_.links.size(); ++i) add_link(i);
    for (std::size_t i = 0; i < robot_.joints.size(); ++i) add_joint(i);
    return text_ + "</robot>\n";
  }

 private:
  void add_link(std::size_t index) {
    const MakerLink& link = robot_.links[index];
    const Eigen::Matrix3d& i = link.inertia_kg_m2;
    text_ += fmt::format(
        "  <link name=\"{}\">\n    <inertial>\n      <origin xyz=\"{}\"/>\n      <mass value=\"{:.12g}\"/>\n"
        "      <inertia ixx=\"{:.12g}\" ixy=\"{:.12g}\" ixz=\"{:.12g}\" iyy=\"{:.12g}\" iyz=\"{:.12g}\" "
        "izz=\"{:.12g}\"/>\n"
        "    </inertial>\n",
        escaped(link.name), numbers(link.com_m), link.mass_kg, i(0, 0), i(0, 1), i(0, 2), i(1, 1), i(1, 2),
        i(2, 2));
    std::size_t number = 0;
    for (const VisualSurface& visual : link.visual) {
      const Eigen::Vector4d colour = visual.rgba.cwiseMax(0.0).cwiseMin(1.0);
      if (const std::string mesh =
              hull_file(visual.surface, index, link.name, "visual", number, kVisualPoints);
          !mesh.empty()) {
        text_ += fmt::format(
            "    <visual><geometry>{}</geometry><material name=\"{}_{}\"><color rgba=\"{:.3g} {:.3g} {:.3g} "
            "{:.3g}\"/></material></visual>\n",
            mesh, escaped(link.name), number, colour[0], colour[1], colour[2], colour[3]);
        ++number;
      }
    }
    if (!add_sole(link)) add_collision(index, link);
    text_ += "  </link>\n";
  }

  // A foot touches the ground with its sole alone: a box from there to half the height of the ankle.
  bool add_sole(const MakerLink& link) {
    for (std::size_t side = 0; side < 2; ++side) {
      if (imported_.plan.legs[side].foot != link.name) continue;
      const FoundSole& sole = imported_.soles[side];
      const double thickness_m = std::max(
          0.1 * sole.size_m.y(), -0.5 * (sole.pose.linear().transpose() * sole.pose.translation()).z());
      const Eigen::Isometry3d box =
          sole.pose * Eigen::Translation3d(sole.centre_m.x(), sole.centre_m.y(), 0.5 * thickness_m);
      text_ += fmt::format("    <collision>{}<geometry><box size=\"{}\"/></geometry></collision>\n",
                           origin(box), numbers({sole.size_m.x(), sole.size_m.y(), thickness_m}));
      return true;
    }
    return false;
  }

  void add_collision(std::size_t index, const MakerLink& link) {
    std::size_t number = 0;
    const auto add = [&](const Surface& surface) {
      if (const std::string mesh =
              hull_file(surface, index, link.name, "collision", number, kCollisionPoints);
          !mesh.empty()) {
        text_ += fmt::format("    <collision><geometry>{}</geometry></collision>\n", mesh);
        ++number;
      }
    };
    for (const Surface& surface : link.collision) add(surface);
    if (!link.collision.empty()) return;
    for (const VisualSurface& visual : link.visual) add(visual.surface);
  }

  // Empty for what is too small or flat to be a body.
  std::string hull_file(const Surface& surface, std::size_t index, const std::string& link, const char* kind,
                        std::size_t number, std::size_t most_points) {
    if (surface.point_m.size() < 4) return "";
    Eigen::Vector3d least = surface.point_m.front(), most = least;
    for (const Eigen::Vector3d& point : surface.point_m) {
      least = least.cwiseMin(point);
      most = most.cwiseMax(point);
    }
    if ((most - least).maxCoeff() < kSmallest_m) return "";
    Surface hull;
    try {
      hull = convex_hull(surface, most_points);
    } catch (const std::invalid_argument&) {
      return "";
    }
    if (volume_m3(hull) < kLeastVolume_m3) return "";
    const std::filesystem::path file = std::filesystem::path("meshes") / file_name(index, link, kind, number);
    std::filesystem::create_directories(folder_ / "meshes");
    write_stl(folder_ / file, hull);
    return fmt::format("<mesh filename=\"{}\"/>", file.string());
  }

  void add_joint(std::size_t index) {
    const MakerJoint& joint = robot_.joints[index];
    const DriveFigures& drive = imported_.drives[index];
    text_ += fmt::format(
        "  <joint name=\"{}\" type=\"revolute\">\n    <parent link=\"{}\"/>\n    <child link=\"{}\"/>\n    "
        "{}\n"
        "    <axis xyz=\"{}\"/>\n    <limit lower=\"{:.12g}\" upper=\"{:.12g}\" effort=\"{:.12g}\" "
        "velocity=\"{:.12g}\"/>\n"
        "  </joint>\n",
        escaped(joint.name), escaped(robot_.links[static_cast<std::size_t>(joint.parent_link)].name),
        escaped(robot_.links[static_cast<std::size_t>(joint.child_link)].name), origin(joint.origin),
        numbers(joint.axis), *joint.lower_rad, *joint.upper_rad, drive.torque_Nm,
        drive.reference_speed_rad_per_s);
  }

  const ImportedRobot& imported_;
  const MakerRobot& robot_;
  const std::filesystem::path& folder_;
  std::string text_;
};

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
        input::terminal_text(robot_.name), in_comment(robot_.file));
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
      text_ += fmt::format("  - {{name: {}, node: {}", quoted(joint.name), i + 1);
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
    for (const std::string& name : names) all.push_back(quoted(name));
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
          side == 0 ? "left" : "right", quoted(imported_.plan.legs[side].foot), at.x(), at.y(), at.z(),
          rpy_deg.x(), rpy_deg.y(), rpy_deg.z(), sole.size_m.x(), sole.size_m.y(), sole.centre_m.x(),
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
        imu.why, quoted(imu.link), imu.pose.translation().x(), imu.pose.translation().y(),
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

void write_robot_folder(const ImportedRobot& imported, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  write_text(folder / "robot.urdf", UrdfText(imported, folder).write());
  write_text(folder / "robot.yaml", NetworkText(imported).write());
}

}  // namespace gaitway::importer
