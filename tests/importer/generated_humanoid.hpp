// A humanoid as a maker might describe it, written from numbers: any size, any order of the hip's and the
// ankle's joints, any sign of an axis, any axes of the root's frame.
#pragma once

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

#include "gaitway/facts/facts.hpp"
#include "gaitway/importer/maker_robot.hpp"

namespace gaitway::importer::test {

enum class FootShape { box, cylinder, corner_spheres, tapered_mesh };

struct Range {
  double lower_rad = 0.0, upper_rad = 0.0;
};

// What a drive is rated at; zero: the description does not say.
struct Rating {
  double torque = 0.0;  // of mass x gravity x hip height
  double speed = 0.0;   // of sqrt(gravity / hip height)
};

struct Humanoid {
  double hip_height_m = 0.9;  // of the straight leg above the sole
  double mass_kg = 60.0;
  std::array<int, 3> hip = {0, 1, 2};  // 0: yaw, 1: roll, 2: pitch
  std::array<int, 2> ankle = {0, 1};   // 0: pitch, 1: roll
  std::uint32_t turned_axes = 0;       // bit i: the leg's i-th joint turns about the negative axis
  // From one of the hip's axes to the next, of the hip height: ahead and back, outwards and down twice.
  double hip_offset = 0.0, hip_aside = 0.0, hip_drop = 0.0;
  double half_hip_width = 0.1;  // of the hip height
  // Axes of the base (x forward, y left, z up) in the frame in which everything is written.
  Eigen::Matrix3d base_in_root = Eigen::Matrix3d::Identity();
  bool plain_names = true;          // else names that tell nothing
  bool fixed_joints = false;        // a fixed joint and a link without mass between thigh and shin
  bool massless_hip_links = false;  // the links between the hip's axes weigh nothing
  FootShape foot = FootShape::box;
  double foot_length = 0.26, foot_width = 0.12, foot_ahead = 0.04;  // of the hip height
  int arm_joints = 4;                                               // of each arm
  double arm_share = 0.05;                                          // of the mass, of each arm
  double leg_share = 0.18;                                          // of the mass, of each leg
  double base_share = 0.15;                                         // of the mass; the chest has the rest
  double gyration = 0.040825;                                       // of each link, of the hip height
  double thigh = 0.46;                                              // of the hip height
  double right_shin_less = 0.0;                                     // than the left one, of the hip height
  std::array<Range, 3> hip_range{{{-0.8, 0.8}, {-0.7, 0.7}, {-1.9, 1.9}}};  // yaw, roll, pitch
  double most_knee_rad = 2.3;
  std::array<Range, 2> ankle_range{{{-1.2, 1.2}, {-0.6, 0.6}}};  // pitch, roll
  std::array<Rating, 3> rating{};                                // of hips, knees, ankles
  bool toes = false;
  bool imu_frame = false;
  // Damage.
  bool endless_knees = false, symmetric_knees = false, no_mass = false, no_ankle_roll = false;
  bool legs_on_waist = false, four_legs = false, all_fixed = false, unsound_inertia = false;
};

inline constexpr double kAnkleHeight = 0.08;  // of the hip height

// What the foot touches the ground with, about the ankle in the base's axes, counter-clockwise.
inline std::vector<Eigen::Vector2d> outline_of_foot(const Humanoid& of) {
  const double x = 0.5 * of.foot_length * of.hip_height_m, y = 0.5 * of.foot_width * of.hip_height_m;
  const double heel = of.foot == FootShape::tapered_mesh ? 0.6 : 1.0;
  std::vector<Eigen::Vector2d> outline{{-x, -heel * y}, {x, -y}, {x, y}, {-x, heel * y}};
  if (of.foot == FootShape::cylinder) {
    outline.clear();
    constexpr int kCorners = 720;
    for (int i = 0; i < kCorners; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / kCorners;
      outline.emplace_back(x * std::cos(angle), x * std::sin(angle));
    }
  }
  for (Eigen::Vector2d& corner : outline) corner.x() += of.foot_ahead * of.hip_height_m;
  return outline;
}

class HumanoidUrdf {
 public:
  // Meshes are written into `folder`.
  HumanoidUrdf(const Humanoid& of, const std::filesystem::path& folder) : of_(of), folder_(folder) {}

  std::string write() {
    text_ = "<robot name=\"generated\">\n";
    add_link("base", of_.base_share, {0.0, 0.0, 0.05}, box({0.0, 0.0, 0.05}, {0.15, 0.22, 0.15}));
    std::string hips = "base";
    if (of_.legs_on_waist) {
      add_joint("waist", "base", "pelvis", 2, {0.0, 0.0, 0.0}, {-1.0, 1.0});
      add_link("pelvis", 0.02, {0.0, 0.0, 0.0}, "");
      hips = "pelvis";
    }
    for (const int side : {1, -1}) {
      add_leg(hips, side, 0.0, side > 0 ? "left_" : "right_");
      if (of_.four_legs) add_leg(hips, side, -0.6, side > 0 ? "left_rear_" : "right_rear_");
      add_arm(side, side > 0 ? "left_" : "right_");
    }
    add_trunk();
    return text_ + "</robot>\n";
  }

 private:
  // Names that tell nothing differ from each other all the same.
  [[nodiscard]] std::string named(const std::string& plain) const {
    if (of_.plain_names) return plain;
    return fmt::format("part-{:08x}", static_cast<std::uint32_t>(std::hash<std::string>{}(plain)));
  }
  // Lengths come in units of the hip height, along the base's axes.
  [[nodiscard]] std::string place(const Eigen::Vector3d& share) const {
    return numbers(of_.base_in_root * share * of_.hip_height_m);
  }
  static std::string numbers(const Eigen::Vector3d& v) {
    return fmt::format("{:.12g} {:.12g} {:.12g}", v.x(), v.y(), v.z());
  }
  [[nodiscard]] std::string origin(const Eigen::Vector3d& share) const {
    const Eigen::Matrix3d& r = of_.base_in_root;
    const double pitch = std::atan2(-r(2, 0), std::hypot(r(0, 0), r(1, 0)));
    const bool locked = std::hypot(r(0, 0), r(1, 0)) < 1e-9;
    const Eigen::Vector3d rpy(locked ? 0.0 : std::atan2(r(2, 1), r(2, 2)), pitch,
                              locked ? std::atan2(-r(0, 1), r(1, 1)) : std::atan2(r(1, 0), r(0, 0)));
    return fmt::format("<origin xyz=\"{}\" rpy=\"{}\"/>", place(share), numbers(rpy));
  }
  [[nodiscard]] std::string shape(const Eigen::Vector3d& at, const std::string& geometry) const {
    return "<collision>" + origin(at) + "<geometry>" + geometry + "</geometry></collision>";
  }
  [[nodiscard]] std::string box(const Eigen::Vector3d& at, const Eigen::Vector3d& size) const {
    return shape(at, fmt::format("<box size=\"{}\"/>", numbers(size * of_.hip_height_m)));
  }

  // Its CoM, and its inertia, the same about all axes.
  void add_link(const std::string& name, double mass_share, const Eigen::Vector3d& com,
                const std::string& shapes) {
    text_ += fmt::format("<link name=\"{}\">", named(name));
    if (mass_share > 0.0 && !of_.no_mass) {
      const double mass_kg = mass_share * of_.mass_kg;
      const double moment = mass_kg * std::pow(of_.gyration * of_.hip_height_m, 2);
      text_ += fmt::format(
          "<inertial>{}<mass value=\"{:.12g}\"/><inertia ixx=\"{:.12g}\" ixy=\"0\" ixz=\"0\" iyy=\"{:.12g}\" "
          "iyz=\"0\" izz=\"{:.12g}\"/></inertial>",
          origin(com), mass_kg, of_.unsound_inertia ? 5.0 * moment : moment, moment, moment);
    }
    text_ += shapes + "</link>\n";
  }
  void add_joint(const std::string& name, const std::string& parent, const std::string& child, int axis,
                 const Eigen::Vector3d& at, Range range, bool turned = false, bool endless = false,
                 const Rating& rating = {}) {
    const double sign = turned ? -1.0 : 1.0;
    const char* type = of_.all_fixed ? "fixed" : endless ? "continuous" : "revolute";
    text_ += fmt::format(
        "<joint name=\"{}\" type=\"{}\"><parent link=\"{}\"/><child link=\"{}\"/><origin xyz=\"{}\"/>"
        "<axis xyz=\"{}\"/>{}</joint>\n",
        named(name), type, named(parent), named(child), place(at),
        numbers(of_.base_in_root * Eigen::Vector3d::Unit(axis) * sign),
        endless
            ? ""
            : fmt::format("<limit lower=\"{:.6g}\" upper=\"{:.6g}\" effort=\"{:.6g}\" velocity=\"{:.6g}\"/>",
                          turned ? -range.upper_rad : range.lower_rad,
                          turned ? -range.lower_rad : range.upper_rad,
                          rating.torque * of_.mass_kg * facts::kGravity_m_per_s2 * of_.hip_height_m,
                          rating.speed * std::sqrt(facts::kGravity_m_per_s2 / of_.hip_height_m)));
  }
  void add_fixed(const std::string& name, const std::string& parent, const std::string& child,
                 const Eigen::Vector3d& at) {
    text_ += fmt::format(
        "<joint name=\"{}\" type=\"fixed\"><parent link=\"{}\"/><child link=\"{}\"/><origin "
        "xyz=\"{}\"/></joint>\n",
        named(name), named(parent), named(child), place(at));
  }

  // The parts of a leg of 0.18.
  [[nodiscard]] double leg_part(double share) const { return share * of_.leg_share / 0.18; }
  // Given for the left leg; the right one is its mirror image: about yaw and roll it turns the other way.
  [[nodiscard]] static Range range(const Range& left, std::size_t axis, int side) {
    constexpr std::size_t kPitch = 2;
    return side > 0 || axis == kPitch ? left : Range{-left.upper_rad, -left.lower_rad};
  }
  void add_leg(const std::string& root, int side, double forward, const std::string& prefix) {
    static constexpr std::array<const char*, 3> kHipNames{"hip_yaw", "hip_roll", "hip_pitch"};
    static constexpr std::array<int, 3> kHipAxes{2, 0, 1};
    const auto turned = [this](int joint) { return (of_.turned_axes >> joint & 1U) != 0; };
    std::string parent = root;
    Eigen::Vector3d at(forward, side * of_.half_hip_width, 0.0);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto which = static_cast<std::size_t>(of_.hip[i]);
      const std::string child = prefix + (i == 2 ? "thigh" : fmt::format("hip_{}", i));
      add_joint(prefix + kHipNames[which], parent, child, kHipAxes[which], at,
                range(of_.hip_range[which], which, side), turned(static_cast<int>(i)), false, of_.rating[0]);
      if (i < 2) add_link(child, of_.massless_hip_links ? 0.0 : leg_part(0.015), {0.0, 0.0, 0.0}, "");
      at = {i == 0 ? of_.hip_offset : -of_.hip_offset, side * of_.hip_aside, -of_.hip_drop};
      parent = child;
    }
    const double thigh = of_.thigh,
                 shin = 1.0 - kAnkleHeight - thigh - (side < 0 ? of_.right_shin_less : 0.0);
    add_link(parent, leg_part(0.08), {0.0, 0.0, -0.4 * thigh},
             box({0.0, 0.0, -0.5 * thigh}, {0.09, 0.09, 0.7 * thigh}));
    if (of_.fixed_joints) {
      add_fixed(prefix + "plate", parent, prefix + "adapter", {0.0, 0.0, -0.5 * thigh});
      add_link(prefix + "adapter", 0.0, {0.0, 0.0, 0.0}, "");
      parent = prefix + "adapter";
    }
    add_joint(prefix + "knee", parent, prefix + "shin", 1,
              {0.0, 0.0, of_.fixed_joints ? -0.5 * thigh : -thigh},
              {of_.symmetric_knees ? -of_.most_knee_rad : 0.0, of_.most_knee_rad}, turned(3),
              of_.endless_knees, of_.rating[1]);
    add_link(prefix + "shin", leg_part(0.05), {0.0, 0.0, -0.4 * shin},
             box({0.0, 0.0, -0.5 * shin}, {0.07, 0.07, 0.7 * shin}));
    add_ankle(prefix, shin, side);
  }
  void add_ankle(const std::string& prefix, double shin, int side) {
    const auto add = [&](int which, const std::string& parent, const std::string& child, double down,
                         int bit) {
      const bool pitch = which == 0;
      add_joint(prefix + (pitch ? "ankle_pitch" : "ankle_roll"), parent, child, pitch ? 1 : 0,
                {0.0, 0.0, -down}, pitch ? of_.ankle_range[0] : range(of_.ankle_range[1], 1, side),
                (of_.turned_axes >> bit & 1U) != 0, false, of_.rating[2]);
    };
    std::string parent = prefix + "shin";
    if (!of_.no_ankle_roll) {
      add(of_.ankle[0], parent, prefix + "ankle", shin, 4);
      add_link(prefix + "ankle", of_.massless_hip_links ? 0.0 : leg_part(0.005), {0.0, 0.0, 0.0}, "");
      parent = prefix + "ankle";
    }
    add(of_.no_ankle_roll ? 0 : of_.ankle[1], parent, prefix + "foot", of_.no_ankle_roll ? shin : 0.0, 5);
    add_link(prefix + "foot", leg_part(0.015), {0.5 * of_.foot_ahead, 0.0, -0.5 * kAnkleHeight},
             foot(prefix));
    if (!of_.toes) return;
    add_joint(prefix + "toe", prefix + "foot", prefix + "toes", 1,
              {of_.foot_ahead + 0.5 * of_.foot_length, 0.0, -0.9 * kAnkleHeight}, {-0.5, 0.5});
    add_link(prefix + "toes", leg_part(0.002), {0.01, 0.0, 0.0}, "");
  }

  std::string foot(const std::string& prefix) const {
    const double ahead = of_.foot_ahead, height = 0.4 * kAnkleHeight;
    const Eigen::Vector3d middle(ahead, 0.0, -kAnkleHeight + 0.5 * height);
    switch (of_.foot) {
      case FootShape::box:
        return box(middle, {of_.foot_length, of_.foot_width, height});
      case FootShape::cylinder:
        return shape(middle,
                     fmt::format("<cylinder radius=\"{:.12g}\" length=\"{:.12g}\"/>",
                                 0.5 * of_.foot_length * of_.hip_height_m, height * of_.hip_height_m));
      case FootShape::corner_spheres: {
        const double radius = 0.1 * of_.foot_width;
        std::string all;
        for (const double x : {-1.0, 1.0}) {
          for (const double y : {-1.0, 1.0}) {
            all += shape({ahead + x * (0.5 * of_.foot_length - radius), y * (0.5 * of_.foot_width - radius),
                          -kAnkleHeight + radius},
                         fmt::format("<sphere radius=\"{:.12g}\"/>", radius * of_.hip_height_m));
          }
        }
        return all;
      }
      case FootShape::tapered_mesh:
        break;
    }
    write_stl(folder_ / (prefix + "foot.stl"), tapered(height));
    return shape({0.0, 0.0, 0.0}, "<mesh filename=\"" + prefix + "foot.stl\"/>");
  }
  [[nodiscard]] Surface tapered(double height) const {
    Surface prism;
    const std::vector<Eigen::Vector2d> outline = outline_of_foot(of_);
    for (const double z : {-kAnkleHeight, -kAnkleHeight + height}) {
      for (const Eigen::Vector2d& corner : outline) {
        prism.point_m.emplace_back(corner.x(), corner.y(), z * of_.hip_height_m);
      }
    }
    prism.triangle = {{0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {4, 6, 7}, {0, 1, 5}, {0, 5, 4},
                      {1, 2, 6}, {1, 6, 5}, {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}};
    return prism;
  }

  void add_trunk() {
    add_joint("waist_yaw", "base", "chest", 2, {0.0, 0.0, 0.15}, {-1.0, 1.0});
    const double legs = (of_.four_legs ? 4.0 : 2.0) * of_.leg_share;
    const double arms = 2.0 * (of_.arm_joints > 0 ? of_.arm_share : 0.0);
    const double chest = std::max(0.01, 1.0 - of_.base_share - legs - arms);
    add_link("chest", chest, {0.0, 0.0, 0.2}, box({0.0, 0.0, 0.2}, {0.15, 0.28, 0.35}));
    if (!of_.imu_frame) return;
    add_fixed("imu_mount", "chest", "imu_link", {0.02, 0.0, 0.1});
    text_ += "<link name=\"" + named("imu_link") + "\"/>\n";
  }
  // Shoulder pitch, roll and yaw, elbow and so on, all along a hanging arm.
  void add_arm(int side, const std::string& prefix) {
    static constexpr std::array<int, 4> kAxes{1, 0, 2, 1};
    std::string parent = "chest";
    for (int i = 0; i < of_.arm_joints; ++i) {
      const std::string child = fmt::format("{}arm_{}", prefix, i);
      const Eigen::Vector3d at = i == 0   ? Eigen::Vector3d(0.0, side * 0.2, 0.35)
                                 : i == 3 ? Eigen::Vector3d(0.0, 0.0, -0.3)
                                          : Eigen::Vector3d(0.0, 0.0, -0.02);
      add_joint(child + "_joint", parent, child, kAxes[static_cast<std::size_t>(i % 4)], at, {-1.6, 1.6});
      add_link(child, of_.arm_share / of_.arm_joints, {0.0, 0.0, i == 2 ? -0.15 : -0.02}, "");
      parent = child;
    }
  }

  const Humanoid& of_;
  const std::filesystem::path& folder_;
  std::string text_;
};

// robot.urdf, and meshes beside it.
inline std::filesystem::path write_humanoid(const Humanoid& humanoid, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "robot.urdf", std::ios::binary) << HumanoidUrdf(humanoid, folder).write();
  return folder / "robot.urdf";
}

}  // namespace gaitway::importer::test
