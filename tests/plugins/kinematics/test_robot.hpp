// A humanoid of 22 joints made in code, so that the tests can bend its geometry: axis signs, zero posture,
// offsets. And plain forward kinematics, link by link: what the tests measure the solvers against.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <span>
#include <string>
#include <vector>

#include "gaitway/kinematics/leg_geometry.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::kinematics::test {

struct LegVariant {
  std::array<double, 6> axis_sign{1, 1, 1, 1, 1, 1};
  std::array<double, 6> zero_rad{};  // nominal angle at which the joint reads zero
  double thigh_lateral_m = 0.0;      // of the knee against the hip
  double ankle_lateral_m = 0.0;      // of the ankle against the knee
  // Of the hip's second joint against its first, of its third against its second, of the ankle's second
  // against its first; in the usual order these are hip roll, hip pitch and ankle roll.
  Eigen::Vector3d hip_roll_shift_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d hip_pitch_shift_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d ankle_roll_shift_m = Eigen::Vector3d::Zero();
  double hip_yaw_tilt_rad = 0.0;                       // of the hip yaw axis about y
  double hip_roll_tilt_rad = 0.0;                      // of the hip roll axis about z
  double knee_tilt_rad = 0.0;                          // of the knee axis about z
  double ankle_roll_tilt_rad = 0.0;                    // of the ankle roll axis about y
  std::array<std::size_t, 6> order{0, 1, 2, 3, 4, 5};  // which of the joints above comes where in the leg
};
inline constexpr std::array<std::size_t, 6> kPitchFirst{2, 1, 0, 3, 4, 5}, kAnkleRollFirst{0, 1, 2, 3, 5, 4},
    kPitchAndAnkleRollFirst{2, 1, 0, 3, 5, 4};

// Angles without the variant's signs and zeros; knee forward.
inline constexpr std::array<double, 6> kNominalHome{0.0, 0.0, -0.345, 0.69, -0.345, 0.0};

class RobotBuilder {
 public:
  explicit RobotBuilder(const LegVariant& variant) : variant_(variant) {
    model_.name = "test robot";
    model_.tree = KDL::Tree("pelvis");
    model_.links.push_back({"pelvis", -1, 0.70, {0.0, 0.0, 0.02}, Eigen::Matrix3d::Zero(), {}});
    model_.hip_height_m = 0.36;
  }

  urdf::RobotModel build() {
    add_leg(urdf::Side::left, 1.0);
    add_leg(urdf::Side::right, -1.0);
    const int waist = add("waist_yaw", 0, {0, 0, 0.06}, Eigen::Vector3d::UnitZ(), 0.15, {0, 0, 0.01}, 0.0);
    const int trunk =
        add("waist_pitch", waist, {0, 0, 0.02}, Eigen::Vector3d::UnitY(), 2.09, {0.005, 0, 0.09}, 0.05);
    const int neck = add("neck_yaw", trunk, {0, 0, 0.22}, Eigen::Vector3d::UnitZ(), 0.05, {0, 0, 0.01}, 0.0);
    add("neck_pitch", neck, {0, 0, 0.03}, Eigen::Vector3d::UnitY(), 0.25, {0.01, 0, 0.05}, 0.1);
    for (const double side : {1.0, -1.0}) {
      const std::string name = side > 0 ? "left_" : "right_";
      const int shoulder = add(name + "shoulder_pitch", trunk, {0, 0.125 * side, 0.2},
                               Eigen::Vector3d::UnitY(), 0.1, {0, 0.01 * side, 0}, 0.3);
      const int arm = add(name + "shoulder_roll", shoulder, {0, 0.02 * side, 0}, Eigen::Vector3d::UnitX(),
                          0.15, {0, 0, -0.07}, 0.15 * side);
      add(name + "elbow", arm, {0, 0, -0.14}, Eigen::Vector3d::UnitY(), 0.1, {0, 0, -0.05}, -0.5);
    }
    return model_;
  }

 private:
  int add(const std::string& name, int parent, const Eigen::Vector3d& position, const Eigen::Vector3d& axis,
          double mass_kg, const Eigen::Vector3d& com, double home_rad, double sign = 1.0,
          double zero_rad = 0.0) {
    urdf::Joint joint;
    joint.name = name;
    joint.parent_link = parent;
    joint.child_link = static_cast<int>(model_.links.size());
    joint.origin.translation() = position;
    joint.origin.linear() = Eigen::AngleAxisd(zero_rad, axis).toRotationMatrix();
    joint.axis = sign * axis;
    joint.home_rad = sign * (home_rad - zero_rad);
    joint.lower_rad = -2.4;
    joint.upper_rad = 2.4;
    joint.velocity_limit_rad_per_s = 20.0;
    joint.count_rad = 0.002;
    model_.links.push_back({name + "_link", static_cast<int>(model_.joints.size()), mass_kg, com, {}, {}});
    model_.joints.push_back(joint);
    const Eigen::Matrix3d r = joint.origin.linear();
    const KDL::Frame frame(
        KDL::Rotation(r(0, 0), r(0, 1), r(0, 2), r(1, 0), r(1, 1), r(1, 2), r(2, 0), r(2, 1), r(2, 2)),
        KDL::Vector(position.x(), position.y(), position.z()));
    model_.tree.addSegment(
        KDL::Segment(
            name + "_link",
            KDL::Joint(name, frame.p, frame.M * KDL::Vector(joint.axis.x(), joint.axis.y(), joint.axis.z()),
                       KDL::Joint::RotAxis),
            frame),
        model_.links[static_cast<std::size_t>(parent)].name);
    return joint.child_link;
  }

  void add_leg(urdf::Side side, double y) {
    using Eigen::Vector3d;
    static constexpr std::array kNames{"hip_yaw", "hip_roll",    "hip_pitch",
                                       "knee",    "ankle_pitch", "ankle_roll"};
    static constexpr std::array kMasses_kg{0.10, 0.15, 0.45, 0.35, 0.10, 0.30};
    const auto about = [](double angle, const Vector3d& axis) { return Eigen::AngleAxisd(angle, axis); };
    const std::array<Vector3d, 6> position{Vector3d(0, 0.05 * y, -0.02),
                                           variant_.hip_roll_shift_m,
                                           variant_.hip_pitch_shift_m,
                                           Vector3d(0, variant_.thigh_lateral_m * y, -0.17),
                                           Vector3d(0, variant_.ankle_lateral_m * y, -0.17),
                                           variant_.ankle_roll_shift_m};
    const std::array<Vector3d, 6> axis{
        about(variant_.hip_yaw_tilt_rad, Vector3d::UnitY()) * Vector3d::UnitZ(),
        about(variant_.hip_roll_tilt_rad, Vector3d::UnitZ()) * Vector3d::UnitX(),
        Vector3d::UnitY(),
        about(variant_.knee_tilt_rad, Vector3d::UnitZ()) * Vector3d::UnitY(),
        Vector3d::UnitY(),
        about(variant_.ankle_roll_tilt_rad, Vector3d::UnitY()) * Vector3d::UnitX()};
    const std::array<Vector3d, 6> com{
        Vector3d(0, 0, 0.01),      Vector3d(-0.02, 0, 0),     Vector3d(0.01, 0.005 * y, -0.08),
        Vector3d(0.005, 0, -0.07), Vector3d(0, 0.003 * y, 0), Vector3d(0.01, 0, -0.025)};
    int parent = 0;
    for (std::size_t i = 0; i < 6; ++i) {
      const auto leg = static_cast<std::size_t>(side);
      const std::size_t turns = variant_.order[i];
      model_.legs[leg].joints[i] = static_cast<int>(model_.joints.size());
      parent = add(std::string(y > 0 ? "left_" : "right_") + kNames[turns], parent, position[i], axis[turns],
                   kMasses_kg[i], com[i], kNominalHome[turns], variant_.axis_sign[turns],
                   variant_.zero_rad[turns]);
      model_.feet[leg].link = parent;
      model_.feet[leg].sole.translation() = Vector3d(0, 0, -0.04);
    }
    set_limits(side);
  }

  // Nominal limits, seen through the variant's signs and zeros.
  void set_limits(urdf::Side side) {
    static constexpr std::array kLower_rad{-0.8, -0.6, -1.7, 0.0, -1.2, -0.6};
    static constexpr std::array kUpper_rad{0.8, 0.6, 0.8, 2.3, 1.2, 0.6};
    for (std::size_t i = 0; i < 6; ++i) {
      urdf::Joint& joint =
          model_.joints[static_cast<std::size_t>(model_.legs[static_cast<std::size_t>(side)].joints[i])];
      const std::size_t turns = variant_.order[i];
      const double a = variant_.axis_sign[turns] * (kLower_rad[turns] - variant_.zero_rad[turns]);
      const double b = variant_.axis_sign[turns] * (kUpper_rad[turns] - variant_.zero_rad[turns]);
      joint.lower_rad = std::min(a, b);
      joint.upper_rad = std::max(a, b);
    }
  }

  LegVariant variant_;
  urdf::RobotModel model_;
};

inline urdf::RobotModel make_robot(const LegVariant& variant = {}) {
  return RobotBuilder(variant).build();
}

// Legs with a closed form in every way that it must cope with.
inline std::vector<LegVariant> closed_form_variants() {
  std::vector<LegVariant> variants(1);
  LegVariant flipped;
  flipped.axis_sign = {-1, -1, -1, -1, -1, -1};
  LegVariant mixed;
  mixed.axis_sign = {1, -1, -1, 1, -1, 1};
  mixed.zero_rad = {0.0, 0.0, -0.3, 0.7, -0.4, 0.0};
  LegVariant bent;
  bent.zero_rad = {0.0, 0.0, -0.345, 0.69, -0.2, 0.1};
  bent.axis_sign = {1, 1, -1, -1, 1, -1};
  LegVariant sideways;
  sideways.thigh_lateral_m = 0.008;
  sideways.ankle_lateral_m = -0.02;
  LegVariant tilted;
  tilted.ankle_roll_tilt_rad = 0.15;
  tilted.thigh_lateral_m = 0.01;
  LegVariant roll_first;
  roll_first.order = kAnkleRollFirst;
  LegVariant roll_first_tilted = mixed;
  roll_first_tilted.order = kPitchAndAnkleRollFirst;
  roll_first_tilted.ankle_roll_tilt_rad = 0.15;
  roll_first_tilted.ankle_lateral_m = -0.02;
  variants.insert(variants.end(), {flipped, mixed, bent, sideways, tilted, roll_first, roll_first_tilted});
  return variants;
}

// Legs without one: the hip's axes have no common point.
inline LegVariant offset_hip() {
  LegVariant variant;
  variant.hip_roll_shift_m = {0.03, 0.0, 0.0};   // the yaw axis is behind,
  variant.hip_pitch_shift_m = {0.0, 0.0, 0.02};  // the roll axis below the pitch axis
  return variant;
}
inline std::vector<LegVariant> general_variants() {
  LegVariant roll_first = offset_hip();
  roll_first.order = kAnkleRollFirst;
  LegVariant pitch_first;
  pitch_first.order = kPitchFirst;
  pitch_first.hip_roll_shift_m = {0.0, 0.01, -0.02};
  pitch_first.hip_pitch_shift_m = {-0.03, 0.0, -0.05};
  pitch_first.ankle_roll_shift_m = {0.0, 0.0, -0.0175};
  LegVariant both_first = pitch_first;
  both_first.order = kPitchAndAnkleRollFirst;
  both_first.axis_sign = {-1, -1, -1, -1, -1, -1};
  LegVariant tilted = offset_hip();
  tilted.hip_yaw_tilt_rad = -0.2;
  tilted.hip_roll_tilt_rad = 0.15;
  tilted.knee_tilt_rad = 0.05;
  tilted.ankle_roll_tilt_rad = 0.15;
  tilted.ankle_roll_shift_m = {0.01, 0.0, -0.01};
  LegVariant mixed = offset_hip();
  mixed.axis_sign = {1, -1, -1, 1, -1, 1};
  mixed.zero_rad = {0.0, 0.0, -0.3, 0.7, -0.4, 0.0};
  mixed.order = kAnkleRollFirst;
  mixed.ankle_roll_shift_m = {0.0, 0.0, -0.02};
  return {offset_hip(), roll_first, pitch_first, both_first, tilted, mixed};
}

// base_from_link of every link for the given joint angles, order of RobotModel::joints.
inline std::vector<Eigen::Isometry3d> link_poses(const urdf::RobotModel& model,
                                                 std::span<const double> angle_rad) {
  std::vector<Eigen::Isometry3d> poses(model.links.size(), Eigen::Isometry3d::Identity());
  for (std::size_t i = 0; i < model.joints.size(); ++i) {
    const urdf::Joint& joint = model.joints[i];
    poses[static_cast<std::size_t>(joint.child_link)] = poses[static_cast<std::size_t>(joint.parent_link)] *
                                                        joint.origin *
                                                        Eigen::AngleAxisd(angle_rad[i], joint.axis);
  }
  return poses;
}

inline std::vector<double> home_posture(const urdf::RobotModel& model) {
  std::vector<double> home;
  home.reserve(model.joints.size());
  for (const urdf::Joint& joint : model.joints) home.push_back(joint.home_rad);
  return home;
}

inline Eigen::Isometry3d sole_pose(const urdf::RobotModel& model, urdf::Side side,
                                   std::span<const double> angle_rad) {
  const urdf::Foot& foot = model.feet[static_cast<std::size_t>(side)];
  return link_poses(model, angle_rad)[static_cast<std::size_t>(foot.link)] * foot.sole;
}

// A little below that of the home posture: all legs reach a walk's footholds from there.
inline double walking_hip_height_m(const urdf::RobotModel& model) {
  const Eigen::Isometry3d sole = sole_pose(model, urdf::Side::left, home_posture(model));
  return (hip_centre(model, urdf::Side::left) - sole.translation()).z() - 0.02;
}

}  // namespace gaitway::kinematics::test
