// Pins the shipped robot to its published and measured figures: dimensions, masses, motors, feet, contact,
// time step.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "gaitway/facts/facts.hpp"
#include "gaitway/urdf/forward_kinematics.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::urdf {
namespace {

using facts::kRadPerDegree;

class Humanoid22 : public testing::Test {
 protected:
  const Joint& joint(const std::string& name) const {
    return robot.joints[static_cast<std::size_t>(robot.joint_index(name))];
  }
  const Link& link(const std::string& name) const {
    return robot.links[static_cast<std::size_t>(robot.link_index(name))];
  }
  // Largest minus smallest coordinate of all shapes with every joint at zero.
  template <typename Shapes>
  Eigen::Vector3d extent_at_zero(Shapes shapes_of) const {
    ForwardKinematics kinematics(robot);
    kinematics.compute(std::vector<double>(robot.joints.size(), 0.0));
    Eigen::AlignedBox3d bounds;
    for (std::size_t i = 0; i < robot.links.size(); ++i) {
      for (const auto& shape : shapes_of(robot.links[i])) {
        for (int corner = 0; corner < 8; ++corner) {
          const Eigen::Vector3d sign(corner & 1 ? 0.5 : -0.5, corner & 2 ? 0.5 : -0.5,
                                     corner & 4 ? 0.5 : -0.5);
          bounds.extend(kinematics.link_pose(static_cast<int>(i)) *
                        (shape.pose * sign.cwiseProduct(shape.size_m)));
        }
      }
    }
    return bounds.sizes();
  }

  const RobotModel robot = load_robot(std::filesystem::path(GAITWAY_URDF_DIR) / "humanoid22");
};

TEST_F(Humanoid22, HasTwentyTwoJointsAndWeighs6840Grams) {
  EXPECT_EQ(robot.joints.size(), 22U);
  EXPECT_EQ(robot.links.size(), 23U);
  EXPECT_EQ(robot.channels.size(), 22U);
  EXPECT_EQ(robot.tree.getNrOfJoints(), 22U);
  EXPECT_NEAR(robot.total_mass_kg(), 6.84, 1e-12);
}

TEST_F(Humanoid22, Stands825MillimetresHighAnd330WideWithStraightLegsAndHangingArms) {
  const Eigen::Vector3d touch = extent_at_zero([](const Link& l) { return l.collision; });
  EXPECT_NEAR(touch.z(), 0.825, 1e-9);
  EXPECT_NEAR(touch.y(), 0.330, 1e-9);
  const Eigen::Vector3d look = extent_at_zero([](const Link& l) { return l.visual; });
  EXPECT_NEAR(look.z(), 0.825, 1e-6);
  EXPECT_LE(look.y(), 0.330 + 1e-6);  // cylinders lie on their sides with six digits of a right angle
}

TEST_F(Humanoid22, HasTheLinkLengthsOfTheFigures) {
  for (const double side : {1.0, -1.0}) {
    const std::string prefix = side > 0 ? "left_" : "right_";
    const auto origin = [&](const char* name) {
      return Eigen::Vector3d(joint(prefix + name).origin.translation());
    };
    EXPECT_EQ(origin("hip_yaw"), Eigen::Vector3d(0.0, 0.05 * side, 0.0));
    EXPECT_EQ(origin("hip_roll"), Eigen::Vector3d::Zero());
    EXPECT_EQ(origin("hip_pitch"), Eigen::Vector3d::Zero());
    EXPECT_EQ(origin("knee"), Eigen::Vector3d(0.0, 0.0, -0.17));
    EXPECT_EQ(origin("ankle_pitch"), Eigen::Vector3d(0.0, 0.0, -0.17));
    EXPECT_EQ(origin("ankle_roll"), Eigen::Vector3d::Zero());
    EXPECT_EQ(origin("shoulder_pitch"), Eigen::Vector3d(0.0, 0.125 * side, 0.2));
    EXPECT_EQ(origin("elbow"), Eigen::Vector3d(0.0, 0.0, -0.14));
  }
  EXPECT_EQ(joint("waist_yaw").origin.translation(), Eigen::Vector3d(0.0, 0.0, 0.06));
  EXPECT_EQ(joint("waist_pitch").origin.translation(), Eigen::Vector3d::Zero());
}

TEST_F(Humanoid22, HasTheMassesOfTheFigures) {
  EXPECT_EQ(link("pelvis").mass_kg, 0.70);
  EXPECT_EQ(link("waist").mass_kg, 0.15);
  EXPECT_EQ(link("trunk").mass_kg, 2.09);
  EXPECT_NEAR(link("neck").mass_kg + link("head").mass_kg, 0.30, 1e-15);
  for (const std::string side : {"left_", "right_"}) {
    EXPECT_EQ(link(side + "hip_yoke").mass_kg, 0.10);
    EXPECT_EQ(link(side + "hip_block").mass_kg, 0.15);
    EXPECT_EQ(link(side + "thigh").mass_kg, 0.45);
    EXPECT_EQ(link(side + "shin").mass_kg, 0.35);
    EXPECT_EQ(link(side + "ankle").mass_kg, 0.10);
    EXPECT_EQ(link(side + "foot").mass_kg, 0.30);
    EXPECT_NEAR(
        link(side + "shoulder").mass_kg + link(side + "upper_arm").mass_kg + link(side + "forearm").mass_kg,
        0.35, 1e-15);
  }
}

TEST_F(Humanoid22, StandsWithHipsAt360AndCentreOfMassAt378Millimetres) {
  const ForwardKinematics home(robot);
  const Eigen::Isometry3d sole = home.sole_pose(Side::left);
  EXPECT_EQ(robot.hip_height_m, 0.36);
  EXPECT_NEAR(-sole.translation().z(), 0.36, 1e-5);
  const Eigen::Vector3d com_m = home.com_m() - sole.translation();
  EXPECT_NEAR(com_m.z(), 0.378, 0.002);
  EXPECT_NEAR(com_m.x(), robot.feet[0].centre_m.x(), 0.002);  // over the middle of the feet
  EXPECT_NEAR(home.com_m().y(), 0.0, 1e-12);
  EXPECT_NEAR(std::sqrt(9.81 / com_m.z()), 5.1, 0.05);
  EXPECT_NEAR(joint("left_knee").home_rad, 40.0 * kRadPerDegree, 1.0 * kRadPerDegree);
}

TEST_F(Humanoid22, HasTheServosAndMotorsOfTheFigures) {
  for (const Joint& joint : robot.joints) {
    EXPECT_EQ(joint.servo.stiffness_Nm_per_rad, 300.0) << joint.name;
    EXPECT_EQ(joint.servo.damping_Nms_per_rad, 4.0);
    EXPECT_EQ(joint.motor.torque_limit_Nm, 8.0);
    EXPECT_EQ(joint.motor.speed_limit_rad_per_s, 8.0);
    EXPECT_EQ(joint.motor.armature_kg_m2, 0.010);
    EXPECT_EQ(joint.motor.damping_Nms_per_rad, 0.15);
    EXPECT_EQ(joint.motor.friction_Nm, 0.10);
    EXPECT_NEAR(joint.count_rad, 0.05 * kRadPerDegree, 1e-15);
    EXPECT_NEAR(joint.encoder_count_rad * 200000.0, 2.0 * std::numbers::pi, 1e-12);
    EXPECT_LE(joint.velocity_limit_rad_per_s, 8.0);
    EXPECT_LE(joint.velocity_limit_rad_per_s * 0.010, 127.0 * joint.count_rad);
  }
}

TEST_F(Humanoid22, HasTheFeetOfTheFigures) {
  for (const Side side : kSides) {
    const Foot& foot = robot.feet[static_cast<std::size_t>(side)];
    EXPECT_EQ(robot.links[static_cast<std::size_t>(foot.link)].name,
              side == Side::left ? "left_foot" : "right_foot");
    EXPECT_EQ(foot.size_m, Eigen::Vector2d(0.135, 0.085));
    EXPECT_EQ(foot.centre_m, Eigen::Vector2d(0.010, 0.0));
    EXPECT_EQ(foot.sole.translation(), Eigen::Vector3d(0.0, 0.0, -0.04));
    const Shape& box = robot.links[static_cast<std::size_t>(foot.link)].collision.front();
    EXPECT_EQ(box.size_m.head<2>(), foot.size_m);
    EXPECT_NEAR(box.pose.translation().z() - 0.5 * box.size_m.z(), -0.04, 1e-15);
    EXPECT_NEAR(box.pose.translation().x(), 0.010, 1e-15);
    for (std::size_t cell = 0; cell < 4; ++cell) {  // FL, FR, RL, RR: just inside the corners
      const Eigen::Vector2d corner(cell < 2 ? 0.0775 : -0.0575, cell % 2 == 0 ? 0.0425 : -0.0425);
      EXPECT_LT((foot.cell_m[cell] - corner).norm(), 0.010);
      EXPECT_TRUE(((foot.cell_m[cell] - foot.centre_m).cwiseAbs().array() < 0.5 * foot.size_m.array()).all());
    }
  }
}

TEST_F(Humanoid22, HasTheSensorsContactAndTimeStepOfTheFigures) {
  EXPECT_EQ(robot.links[static_cast<std::size_t>(robot.imu.link)].name, "trunk");
  EXPECT_EQ(robot.noise.angular_velocity_rad_per_s, 0.01);
  EXPECT_EQ(robot.noise.acceleration_m_per_s2, 0.15);
  EXPECT_EQ(robot.noise.force_N, 0.2);
  EXPECT_EQ(robot.noise.inclination_rad, 0.003);
  EXPECT_EQ(robot.contact.friction, 0.8);
  EXPECT_EQ(robot.physics_step_s, 0.001);
  EXPECT_EQ(robot.imu.inclinometer, Inclinometer::pendulum);
  EXPECT_EQ(robot.parts_deviation, 1.0);
  EXPECT_NEAR(robot.trim.count_rad, 0.05 * kRadPerDegree, 1e-15);
  EXPECT_NEAR(robot.trim.limit_rad, 127.0 * robot.trim.count_rad, 1e-12);
}

TEST_F(Humanoid22, OrdersJointsLegsFirstAndParentsBeforeChildren) {
  EXPECT_EQ(robot.links[0].name, "pelvis");
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    EXPECT_EQ(robot.joints[i].child_link, static_cast<int>(i) + 1);
    EXPECT_LT(robot.joints[i].parent_link, robot.joints[i].child_link);
    EXPECT_EQ(robot.links[i + 1].parent_joint, static_cast<int>(i));
    EXPECT_EQ(robot.joints[i].node, i + 1);
    EXPECT_EQ(robot.joint_of_node(robot.joints[i].node), static_cast<int>(i));
  }
  EXPECT_EQ(robot.legs[0].joints, (std::array<int, 6>{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(robot.legs[1].joints, (std::array<int, 6>{6, 7, 8, 9, 10, 11}));
  EXPECT_FALSE(robot.joint_of_node(23));
}

TEST_F(Humanoid22, CarriesEverySensorChannelWhereTheDesignPutsIt) {
  const auto kinds = [this](const std::string& name) {
    std::set<SensorKind> set;
    for (const SensorChannel& channel : robot.channels[static_cast<std::size_t>(robot.joint_index(name))]) {
      if (channel.kind != SensorKind::none) set.insert(channel.kind);
    }
    return set;
  };
  for (const std::string side : {"left_", "right_"}) {
    EXPECT_EQ(kinds(side + "ankle_roll"), std::set{SensorKind::force_cell});
    EXPECT_EQ(kinds(side + "ankle_pitch"), std::set{SensorKind::force_cell});
    EXPECT_EQ(kinds(side + "knee"), std::set{SensorKind::foot_acceleration});
    EXPECT_EQ(kinds(side + "hip_pitch"), std::set{SensorKind::foot_acceleration});
  }
  std::map<SensorKind, int> count;
  for (const auto& pair : robot.channels) {
    for (const SensorChannel& channel : pair) ++count[channel.kind];
  }
  EXPECT_EQ(count[SensorKind::force_cell], 8);
  EXPECT_EQ(count[SensorKind::foot_acceleration], 6);
  EXPECT_EQ(count[SensorKind::angular_velocity], 3);
  EXPECT_EQ(count[SensorKind::acceleration], 3);
  EXPECT_EQ(count[SensorKind::inclination], 2);
}

TEST_F(Humanoid22, TrimsHipsAndAnkles) {
  const std::array names{"left_hip_roll",    "right_hip_roll",    "left_hip_pitch",  "right_hip_pitch",
                         "left_ankle_pitch", "right_ankle_pitch", "left_ankle_roll", "right_ankle_roll"};
  for (std::size_t channel = 0; channel < names.size(); ++channel) {
    EXPECT_EQ(joint(names[channel]).trim_channel, static_cast<int>(channel));
  }
  EXPECT_EQ(std::count_if(robot.joints.begin(), robot.joints.end(),
                          [](const Joint& j) { return j.trim_channel < 0; }),
            14);
}

TEST_F(Humanoid22, IsMirroredLeftToRight) {
  const Eigen::Vector3d mirror(1.0, -1.0, 1.0);
  for (const Joint& left : robot.joints) {
    if (!left.name.starts_with("left_")) continue;
    const Joint& right = joint("right_" + left.name.substr(5));
    const double sign = left.axis.y() == 1.0 ? 1.0 : -1.0;  // roll and yaw change their sign in a mirror
    EXPECT_EQ(left.axis, right.axis) << left.name;
    EXPECT_EQ(left.home_rad, sign * right.home_rad) << left.name;
    EXPECT_EQ(left.lower_rad, sign > 0 ? right.lower_rad : -right.upper_rad) << left.name;
    EXPECT_EQ(left.upper_rad, sign > 0 ? right.upper_rad : -right.lower_rad) << left.name;
    const Link& left_link = robot.links[static_cast<std::size_t>(left.child_link)];
    const Link& right_link = robot.links[static_cast<std::size_t>(right.child_link)];
    EXPECT_EQ(left_link.com_m, right_link.com_m.cwiseProduct(mirror)) << left_link.name;
    EXPECT_EQ(left_link.inertia_kg_m2, right_link.inertia_kg_m2) << left_link.name;
  }
}

TEST_F(Humanoid22, HasSomethingToSeeAndToTouchInEveryLink) {
  for (const Link& link : robot.links) {
    EXPECT_FALSE(link.collision.empty()) << link.name;
    EXPECT_FALSE(link.visual.empty()) << link.name;
    for (const Shape& shape : link.visual) {
      EXPECT_EQ(shape.rgba.w(), 1.0) << link.name;
    }
  }
  EXPECT_LT(link("left_foot").visual.front().rgba.x(), 0.2);  // the sole is dark: colours arrive
}

TEST_F(Humanoid22, UnknownNamesAreRefusedWithTheNearest) {
  try {
    (void)robot.joint_index("left_kne");
    FAIL() << "the name should be refused";
  } catch (const RobotError& error) {
    EXPECT_STREQ(error.what(), "robot 'humanoid22' has no joint 'left_kne'. Did you mean 'left_knee'?");
  }
  EXPECT_THROW((void)robot.link_index("tail"), RobotError);
}

}  // namespace
}  // namespace gaitway::urdf
