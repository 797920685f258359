// What does not move against each other is one body: its mass, centre and inertia, its surfaces and frames.
#include <random>

#include "maker_folder.hpp"

namespace gaitway::importer {
namespace {

class Dice {
 public:
  explicit Dice(unsigned seed) : engine_(seed) {}
  double within(double low, double high) { return std::uniform_real_distribution(low, high)(engine_); }
  int below(int end) { return std::uniform_int_distribution(0, end - 1)(engine_); }
  Eigen::Vector3d vector(double most) {
    return {within(-most, most), within(-most, most), within(-most, most)};
  }
  Eigen::Isometry3d pose() {
    Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
    result.linear() =
        Eigen::Quaterniond(Eigen::Vector4d(within(-1, 1), within(-1, 1), within(-1, 1), within(0.1, 1)))
            .normalized()
            .toRotationMatrix();
    result.translation() = vector(1.0);
    return result;
  }

 private:
  std::mt19937 engine_;
};

MakerLink any_link(Dice& dice, const std::string& name) {
  MakerLink link;
  link.name = name;
  link.mass_kg = dice.below(4) == 0 ? 0.0 : dice.within(0.1, 5.0);
  if (link.mass_kg > 0.0) {
    link.com_m = dice.vector(0.3);
    const Eigen::Matrix3d axes = dice.pose().linear();
    const Eigen::Vector3d moments(dice.within(0.1, 0.2), dice.within(0.1, 0.2), dice.within(0.1, 0.2));
    link.inertia_kg_m2 = axes * moments.asDiagonal() * axes.transpose();
  }
  Surface point;
  point.point_m = {dice.vector(1.0)};
  link.visual.push_back({point, Eigen::Vector4d::Ones()});
  link.collision.push_back(point);
  link.frames["sensor of " + name] = dice.pose();
  return link;
}

MakerRobot any_robot(Dice& dice) {
  MakerRobot robot;
  robot.links.push_back(any_link(dice, "link 0"));
  for (int i = 0; i < 9; ++i) {
    MakerJoint joint;
    joint.name = "joint " + std::to_string(i);
    joint.parent_link = dice.below(i + 1);
    joint.child_link = i + 1;
    joint.origin = dice.pose();
    joint.axis = dice.vector(1.0).normalized();
    robot.joints.push_back(joint);
    robot.links.push_back(any_link(dice, "link " + std::to_string(i + 1)));
    robot.links.back().parent_joint = i;
  }
  return robot;
}

// About the root's origin.
struct Sum {
  double mass_kg = 0.0;
  Eigen::Vector3d moment_kg_m = Eigen::Vector3d::Zero();
  Eigen::Matrix3d inertia_kg_m2 = Eigen::Matrix3d::Zero();
};

Sum sum_of(const MakerRobot& robot, const std::vector<double>& angle_rad) {
  Sum sum;
  const std::vector<Eigen::Isometry3d> poses = link_poses(robot, angle_rad);
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    const MakerLink& link = robot.links[i];
    const Eigen::Vector3d com_m = poses[i] * link.com_m;
    Eigen::Matrix3d cross;
    cross << 0.0, -com_m.z(), com_m.y(), com_m.z(), 0.0, -com_m.x(), -com_m.y(), com_m.x(), 0.0;
    sum.mass_kg += link.mass_kg;
    sum.moment_kg_m += link.mass_kg * com_m;
    sum.inertia_kg_m2 +=
        poses[i].linear() * link.inertia_kg_m2 * poses[i].linear().transpose() - link.mass_kg * cross * cross;
  }
  return sum;
}

std::map<std::string, Eigen::Isometry3d> frames_of(const MakerRobot& robot,
                                                   const std::vector<double>& angle_rad) {
  std::map<std::string, Eigen::Isometry3d> result;
  const std::vector<Eigen::Isometry3d> poses = link_poses(robot, angle_rad);
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    result[robot.links[i].name] = poses[i];
    for (const auto& [name, pose] : robot.links[i].frames) {
      result[name] = poses[i] * pose;
    }
  }
  return result;
}

// The sum of all surface points: enough to see that none is lost or moved.
Eigen::Vector3d surface_sum(const MakerRobot& robot, const std::vector<double>& angle_rad) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  const std::vector<Eigen::Isometry3d> poses = link_poses(robot, angle_rad);
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    for (const VisualSurface& visual : robot.links[i].visual) {
      sum += poses[i] * visual.surface.point_m.at(0);
    }
    for (const Surface& collision : robot.links[i].collision) {
      sum += 2.0 * (poses[i] * collision.point_m.at(0));
    }
  }
  return sum;
}

TEST(MergedLinks, AnyJointsHeldStillAreTheSameRobot) {
  for (unsigned seed = 1; seed <= 50; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Dice dice(seed);
    const MakerRobot robot = any_robot(dice);
    std::vector<double> angle_rad, free_rad;
    std::vector<std::optional<double>> held;
    for (std::size_t i = 0; i < robot.joints.size(); ++i) {
      angle_rad.push_back(dice.within(-3.0, 3.0));
      const bool is_held = dice.below(2) == 0;
      held.push_back(is_held ? std::optional(angle_rad.back()) : std::nullopt);
      if (!is_held) {
        free_rad.push_back(angle_rad.back());
      }
    }
    const MakerRobot still = hold_still(robot, held);
    ASSERT_EQ(still.joints.size(), free_rad.size());
    const Sum before = sum_of(robot, angle_rad), after = sum_of(still, free_rad);
    EXPECT_NEAR(after.mass_kg, before.mass_kg, 1e-12);
    EXPECT_TRUE(after.moment_kg_m.isApprox(before.moment_kg_m, 1e-9));
    EXPECT_TRUE(after.inertia_kg_m2.isApprox(before.inertia_kg_m2, 1e-9));
    EXPECT_TRUE(surface_sum(still, free_rad).isApprox(surface_sum(robot, angle_rad), 1e-9));
    const auto expected = frames_of(robot, angle_rad), frames = frames_of(still, free_rad);
    ASSERT_EQ(frames.size(), expected.size());
    for (const auto& [name, pose] : expected) {
      EXPECT_TRUE(frames.at(name).isApprox(pose, 1e-9)) << name;
    }
    for (std::size_t i = 0; i < still.joints.size(); ++i) {
      EXPECT_EQ(still.joints[i].child_link, static_cast<int>(i) + 1);
      EXPECT_EQ(still.links[i + 1].parent_joint, static_cast<int>(i));
    }
  }
}

TEST(MergedLinks, TwoMassesAreOneInTheMiddle) {
  MakerRobot robot;
  robot.links.resize(2);
  robot.links[0].mass_kg = robot.links[1].mass_kg = 2.0;
  robot.joints.resize(1);
  robot.joints[0].child_link = 1;
  robot.joints[0].origin.translation() = Eigen::Vector3d(0.0, 2.0, 0.0);
  const MakerLink whole = hold_still(robot, {0.0}).links.at(0);
  EXPECT_EQ(whole.mass_kg, 4.0);
  EXPECT_EQ(whole.com_m, Eigen::Vector3d(0.0, 1.0, 0.0));
  EXPECT_TRUE(whole.inertia_kg_m2.isApprox(Eigen::Vector3d(4.0, 0.0, 4.0).asDiagonal().toDenseMatrix()));
}

TEST(MergedLinks, WithoutMassTheCentreStays) {
  MakerRobot robot;
  robot.links.resize(2);
  robot.joints.resize(1);
  robot.joints[0].child_link = 1;
  EXPECT_EQ(hold_still(robot, {0.0}).links.at(0).com_m, Eigen::Vector3d::Zero());
}

TEST(MergedLinks, AValueForEachJointIsWanted) {
  Dice dice(1);
  const MakerRobot robot = any_robot(dice);
  EXPECT_THROW((void)hold_still(robot, {}), std::invalid_argument);
  EXPECT_THROW((void)link_poses(robot, {0.0}), std::invalid_argument);
}

}  // namespace
}  // namespace gaitway::importer
