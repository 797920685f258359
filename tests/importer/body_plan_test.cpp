// Generated humanoids of every build are brought with their legs, soles and stand; what is none is refused.
#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <fstream>
#include <functional>
#include <iterator>

#include "gaitway/importer/import.hpp"
#include "gaitway/urdf/forward_kinematics.hpp"
#include "gaitway/urdf/robot_model.hpp"
#include "generated_humanoid.hpp"
#include "maker_folder.hpp"

namespace gaitway::importer {
namespace {

using test::FootShape;
using test::Humanoid;
using testing::HasSubstr;

Eigen::Matrix3d backward_and_y_up() {
  Eigen::Matrix3d turned;
  turned.col(0) = -Eigen::Vector3d::UnitX();
  turned.col(2) = Eigen::Vector3d::UnitY();
  turned.col(1) = turned.col(2).cross(turned.col(0));
  return turned;
}

struct Build {
  const char* name;
  std::function<void(Humanoid&)> change;
};
void PrintTo(const Build& build, std::ostream* stream) {
  *stream << build.name;
}

class GeneratedHumanoid : public testing::TestWithParam<Build> {
 protected:
  GeneratedHumanoid() {
    GetParam().change(humanoid_);
    imported_ = import_robot(test::write_humanoid(humanoid_, folder_.path()), {});
  }
  [[nodiscard]] urdf::RobotModel loaded() const {
    write_robot_folder(imported_, folder_.path() / "out");
    return urdf::load_robot(folder_.path() / "out");
  }

  test::MakerFolder folder_;
  Humanoid humanoid_;
  ImportedRobot imported_;
};

TEST_P(GeneratedHumanoid, ItsLegsAreFoundFromHipToFoot) {
  EXPECT_TRUE(imported_.plan.base_in_root.isApprox(humanoid_.base_in_root, 1e-9))
      << imported_.plan.base_in_root;
  for (std::size_t side = 0; side < 2; ++side) {
    EXPECT_EQ(imported_.plan.beyond_feet.size(), humanoid_.toes ? 2U : 0U);
    if (!humanoid_.plain_names) continue;
    const std::string prefix = side == 0 ? "left_" : "right_";
    const LegChain& leg = imported_.plan.legs[side];
    EXPECT_EQ(leg.foot, prefix + "foot");
    EXPECT_EQ(leg.joints[3], prefix + "knee");
    constexpr std::array<const char*, 3> kHip{"hip_yaw", "hip_roll", "hip_pitch"};
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(leg.joints[i], prefix + kHip.at(static_cast<std::size_t>(humanoid_.hip.at(i))));
    }
    constexpr std::array<const char*, 2> kAnkle{"ankle_pitch", "ankle_roll"};
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_EQ(leg.joints[i + 4], prefix + kAnkle.at(static_cast<std::size_t>(humanoid_.ankle.at(i))));
    }
  }
}

TEST_P(GeneratedHumanoid, ItsSolesLieWithinWhatTouchesTheGround) {
  const std::vector<Eigen::Vector2d> outline = test::outline_of_foot(humanoid_);
  for (const FoundSole& sole : imported_.soles) {
    EXPECT_THAT(sole.source, HasSubstr("collision geometry"));
    EXPECT_GT(sole.size_m.minCoeff(), 0.05 * humanoid_.hip_height_m);
    EXPECT_NEAR(sole.pose.translation().norm(), test::kAnkleHeight * humanoid_.hip_height_m,
                1e-6 * humanoid_.hip_height_m);
    for (const double x : {-0.5, 0.5}) {
      for (const double y : {-0.5, 0.5}) {
        const Eigen::Vector2d corner = sole.centre_m + sole.size_m.cwiseProduct(Eigen::Vector2d(x, y));
        for (std::size_t i = 0; i < outline.size(); ++i) {
          const Eigen::Vector2d edge = outline[(i + 1) % outline.size()] - outline[i];
          const Eigen::Vector2d to = corner - outline[i];
          EXPECT_GT((edge.x() * to.y() - edge.y() * to.x()) / edge.norm(), -1e-4 * humanoid_.hip_height_m);
        }
      }
    }
  }
  if (humanoid_.foot == FootShape::box) {
    EXPECT_TRUE(imported_.soles[0].size_m.isApprox(
        humanoid_.hip_height_m * Eigen::Vector2d(humanoid_.foot_length, humanoid_.foot_width), 1e-5));
  }
}

TEST_P(GeneratedHumanoid, ItStandsOnLevelSolesUnderItsMassWithItsKneesForward) {
  const urdf::RobotModel robot = loaded();
  const urdf::ForwardKinematics home(robot);
  const Eigen::Isometry3d left = home.sole_pose(urdf::Side::left), right = home.sole_pose(urdf::Side::right);
  const auto middle = [&](const Eigen::Isometry3d& pose, std::size_t side) -> Eigen::Vector3d {
    const Eigen::Vector2d& centre_m = robot.feet[side].centre_m;
    return pose * Eigen::Vector3d(centre_m.x(), centre_m.y(), 0.0);
  };
  for (const Eigen::Isometry3d& sole : {left, right}) {
    EXPECT_TRUE(sole.linear().isIdentity(1e-6)) << sole.linear();
  }
  EXPECT_NEAR(left.translation().z(), right.translation().z(), 1e-6);
  EXPECT_NEAR(middle(left, 0).x(), middle(right, 1).x(), 1e-5);
  EXPECT_GT(left.translation().y() - right.translation().y(), robot.feet[0].size_m.y());
  EXPECT_NEAR(home.com_m().x(), 0.5 * (middle(left, 0) + middle(right, 1)).x(), 1e-5);
  EXPECT_GT(imported_.home.knee_bend_rad, 0.25);
  EXPECT_NEAR(imported_.home.hip_height_m, humanoid_.hip_height_m, 0.1 * humanoid_.hip_height_m);
  for (std::size_t i = 0; i < imported_.robot.joints.size(); ++i) {
    const MakerJoint& joint = imported_.robot.joints[i];
    EXPECT_GT(imported_.home.angle_rad[i], joint.lower_rad) << joint.name;
    EXPECT_LT(imported_.home.angle_rad[i], joint.upper_rad) << joint.name;
  }
}

TEST_P(GeneratedHumanoid, ItsFolderLoadsWithItsMassAndSoundInertias) {
  const urdf::RobotModel robot = loaded();
  EXPECT_NEAR(robot.total_mass_kg(), total_mass_kg(imported_.robot), 1e-6 * humanoid_.mass_kg);
  const double share = humanoid_.massless_hip_links ? 0.93 : 1.0;  // of what the hips and ankles leave
  EXPECT_NEAR(robot.total_mass_kg(), share * humanoid_.mass_kg, 0.005 * humanoid_.mass_kg);
  EXPECT_EQ(robot.joints.size(), 13U + 2U * static_cast<std::size_t>(humanoid_.arm_joints));
  for (const urdf::Link& link : robot.links) {
    EXPECT_GT(link.mass_kg, 0.0) << link.name;
    const Eigen::Vector3d moment =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(link.inertia_kg_m2).eigenvalues();
    EXPECT_GT(moment[0], 0.0) << link.name;
    EXPECT_GE(moment[0] + moment[1], moment[2] * (1.0 - 1e-9)) << link.name;
  }
}

TEST_P(GeneratedHumanoid, ItsImuLooksAlongTheBase) {
  const urdf::RobotModel robot = loaded();
  EXPECT_THAT(imported_.imu.why, HasSubstr(humanoid_.imu_frame ? "'imu_link'" : "guess"));
  const std::vector<Eigen::Isometry3d> poses = link_poses(imported_.robot, imported_.home.angle_rad);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (imported_.robot.links[i].name != imported_.imu.link) continue;
    EXPECT_TRUE(poses[i].linear().isIdentity(1e-6)) << "the link that carries it";
    const Eigen::Vector3d at = (poses[i] * imported_.imu.pose).translation() / humanoid_.hip_height_m;
    const Eigen::Vector3d mount =
        humanoid_.imu_frame ? Eigen::Vector3d(0.02, 0.0, 0.25) : Eigen::Vector3d::Zero();
    EXPECT_TRUE((at - mount).isZero(1e-6)) << at.transpose();
  }
}

INSTANTIATE_TEST_SUITE_P(
    Builds, GeneratedHumanoid,
    testing::Values(Build{"plain", [](Humanoid&) {}},
                    Build{"small", [](Humanoid& h) { h.hip_height_m = 0.25, h.mass_kg = 2.5; }},
                    Build{"large", [](Humanoid& h) { h.hip_height_m = 1.4, h.mass_kg = 150.0; }},
                    Build{"yaw_pitch_roll",
                          [](Humanoid& h) {
                            h.hip = {0, 2, 1};
                          }},
                    Build{"roll_yaw_pitch",
                          [](Humanoid& h) {
                            h.hip = {1, 0, 2};
                          }},
                    Build{"roll_pitch_yaw",
                          [](Humanoid& h) {
                            h.hip = {1, 2, 0};
                          }},
                    Build{"pitch_yaw_roll",
                          [](Humanoid& h) {
                            h.hip = {2, 0, 1};
                          }},
                    Build{"pitch_roll_yaw_ankle_roll_first",
                          [](Humanoid& h) {
                            h.hip = {2, 1, 0}, h.ankle = {1, 0};
                          }},
                    Build{"every_second_axis_negative", [](Humanoid& h) { h.turned_axes = 0b101010; }},
                    Build{"every_axis_negative", [](Humanoid& h) { h.turned_axes = 0b111111; }},
                    Build{"offset_hip_axes", [](Humanoid& h) { h.hip_offset = 0.04; }},
                    Build{"looks_backward",
                          [](Humanoid& h) {
                            h.base_in_root = Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitZ())
                                                 .toRotationMatrix();
                            h.base_in_root = h.base_in_root.array().round();
                          }},
                    Build{"backward_and_y_up",
                          [](Humanoid& h) { h.base_in_root = backward_and_y_up(), h.imu_frame = true; }},
                    Build{"names_tell_nothing", [](Humanoid& h) { h.plain_names = false; }},
                    Build{"fixed_joints_and_links_without_mass",
                          [](Humanoid& h) { h.fixed_joints = h.massless_hip_links = true; }},
                    Build{"inertias_that_no_body_has", [](Humanoid& h) { h.unsound_inertia = true; }},
                    Build{"cylinder_feet", [](Humanoid& h) { h.foot = FootShape::cylinder; }},
                    Build{"feet_on_spheres", [](Humanoid& h) { h.foot = FootShape::corner_spheres; }},
                    Build{"feet_of_a_mesh", [](Humanoid& h) { h.foot = FootShape::tapered_mesh; }},
                    Build{"no_arms", [](Humanoid& h) { h.arm_joints = 0; }},
                    Build{"toes_and_seven_arm_joints", [](Humanoid& h) { h.toes = true, h.arm_joints = 7; }},
                    Build{"knees_both_ways", [](Humanoid& h) { h.symmetric_knees = true; }},
                    Build{"imu_on_the_chest", [](Humanoid& h) { h.imu_frame = true; }}),
    [](const auto& test) { return std::string(test.param.name); });

// Names of strangers' links are no file names.
TEST(ImportedStand, IsFoundForLegsThatDifferALittle) {
  for (const double less : {-0.01, -0.0005, 0.0002, 0.0005, 0.002, 0.01}) {
    const test::MakerFolder folder;
    const ImportedRobot imported =
        import_robot(test::write_humanoid({.right_shin_less = less}, folder.path()), {});
    EXPECT_NEAR(imported.home.knee_bend_rad, kUsualBend_rad, 0.01) << less;
  }
}

TEST(ImportedFolder, LoadsWhateverYamlTakesItsNamesFor) {
  const test::MakerFolder folder;
  const std::filesystem::path file = test::write_humanoid({}, folder.path());
  std::ifstream stream(file);
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  for (std::size_t at = 0; (at = text.find("\"left_knee\"", at)) != text.npos;)
    text.replace(at, 11, "\"null\"");
  write_robot_folder(import_robot(folder.write("robot.urdf", text), {}), folder.path() / "out");
  EXPECT_EQ(urdf::load_robot(folder.path() / "out").legs[0].joints.size(), 6U);
}

// What is told of a humanoid with a lamp on its chest that weighs so much, and has no inertia.
std::vector<std::string> notes_with_lamp(const std::string& mass_kg) {
  const test::MakerFolder folder;
  const std::filesystem::path file = test::write_humanoid({}, folder.path());
  std::ifstream stream(file);
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  const std::string lamp =
      "<link name=\"bulb\"><inertial><mass value=\"" + mass_kg +
      "\"/></inertial></link><joint name=\"lamp\" type=\"revolute\"><parent link=\"chest\"/>"
      "<child link=\"bulb\"/><limit lower=\"-1\" upper=\"1\"/></joint>";
  return import_robot(folder.write("robot.urdf", text.insert(text.find("</robot>"), lamp)), {}).notes;
}

TEST(ImportedFolder, TellsOfEveryLinkThatIsMadeHeavier) {
  EXPECT_THAT(notes_with_lamp("1e-4"),
              testing::Contains(testing::AllOf(HasSubstr("0.0299 kg more in all"), HasSubstr("bulb"))));
}

TEST(ImportedFolder, TellsOfEveryLinkThatGetsAnInertia) {
  EXPECT_THAT(notes_with_lamp("1"),
              testing::Contains(testing::AllOf(HasSubstr("links without inertia"), HasSubstr("bulb"))));
}

TEST(ImportedFolder, KeepsMeshesApartWhoseLinksAreCalledAlike) {
  const test::MakerFolder folder;
  ImportedRobot imported = import_robot(test::write_humanoid({}, folder.path()), {});
  std::vector<MakerLink*> renamed;
  for (MakerLink& link : imported.robot.links) {
    if (link.name.find("arm") != std::string::npos) renamed.push_back(&link);
  }
  ASSERT_GE(renamed.size(), 2U);
  Surface tetrahedron;
  tetrahedron.point_m = {{0.0, 0.0, 0.0}, {0.05, 0.0, 0.0}, {0.0, 0.05, 0.0}, {0.0, 0.0, 0.05}};
  for (MakerLink* const link : {renamed[0], renamed[1]}) link->collision = {tetrahedron};
  renamed[0]->name = "../../a b";
  renamed[1]->name = "../../a_b";
  const std::filesystem::path written = folder.path() / "written";
  write_robot_folder(imported, written);
  std::set<std::filesystem::path> meshes;
  const urdf::RobotModel robot = urdf::load_robot(written);
  for (const char* name : {"../../a b", "../../a_b"}) {
    const urdf::Link& link = robot.links[static_cast<std::size_t>(robot.link_index(name))];
    for (const urdf::Shape& shape : link.collision) meshes.insert(shape.mesh.file);
    ASSERT_FALSE(link.collision.empty()) << name;
  }
  EXPECT_EQ(meshes.size(), renamed[0]->collision.size() + renamed[1]->collision.size());
}

class NoHumanoid : public testing::Test {
 protected:
  std::string complaint(const ImportOptions& options = {}) {
    try {
      (void)import_robot(test::write_humanoid(humanoid_, folder_.path()), options);
    } catch (const std::exception& error) {
      return error.what();
    }
    return "(brought without complaint)";
  }
  test::MakerFolder folder_;
  Humanoid humanoid_;
};

TEST_F(NoHumanoid, WithoutAnkleRollIsRefused) {
  humanoid_.no_ankle_roll = true;
  EXPECT_THAT(complaint(),
              testing::AllOf(HasSubstr("legs"), HasSubstr("has 5 joints only"), HasSubstr("left_knee")));
}
TEST_F(NoHumanoid, WithFourLegsIsRefused) {
  humanoid_.four_legs = true;
  EXPECT_THAT(complaint(),
              testing::AllOf(HasSubstr("4 chains like legs"), HasSubstr("right_rear_ankle_roll")));
}
TEST_F(NoHumanoid, WithAKneeWithoutLimitsIsRefused) {
  humanoid_.endless_knees = true;
  EXPECT_THAT(complaint(), testing::AllOf(HasSubstr("'left_knee' limit"), HasSubstr("must have limits")));
}
TEST_F(NoHumanoid, OfWhichNothingTurnsIsRefused) {
  humanoid_.all_fixed = true;
  EXPECT_THAT(complaint(), HasSubstr("nothing of it turns"));
}
TEST_F(NoHumanoid, WhoseLegsHangOnAWaistIsRefused) {
  humanoid_.legs_on_waist = true;
  EXPECT_THAT(complaint(), testing::AllOf(HasSubstr("'pelvis'"), HasSubstr("not the root 'base'")));
}
TEST_F(NoHumanoid, WithoutMassIsRefused) {
  humanoid_.no_mass = true;
  EXPECT_THAT(complaint(), HasSubstr("no link has a mass"));
}
// By the maker's line: the folder that would be made of it could not be loaded.
TEST_F(NoHumanoid, ThatNoFolderMayHoldIsRefusedByTheMakersLine) {
  humanoid_.mass_kg = 5000.0;
  EXPECT_THAT(complaint(), testing::AllOf(testing::ContainsRegex("robot.urdf:[0-9]+: link '"),
                                          HasSubstr("must be at most 200 kg"), HasSubstr("kilograms")));
  humanoid_.mass_kg = 60.0;
  humanoid_.rating[1] = {.torque = 1e-6, .speed = 2.0};
  EXPECT_THAT(complaint(), testing::AllOf(testing::ContainsRegex("robot.urdf:[0-9]+: joint 'left_knee'"),
                                          HasSubstr("effort"), HasSubstr("at least 0.01 N·m")));
  humanoid_.rating[1] = {.torque = 0.4, .speed = 1e-3};
  EXPECT_THAT(complaint(), testing::AllOf(testing::ContainsRegex("robot.urdf:[0-9]+: joint 'left_knee'"),
                                          HasSubstr("velocity"), HasSubstr("at least 0.1 rad/s")));
}
TEST_F(NoHumanoid, ThatLooksEitherWayIsRefusedUnlessItIsTold) {
  humanoid_.symmetric_knees = true;
  humanoid_.foot_ahead = 0.0;
  EXPECT_THAT(complaint(), testing::AllOf(HasSubstr("is forward"), HasSubstr("--forward")));
  ImportOptions told;
  told.plan.forward = -Eigen::Vector3d::UnitX();
  const ImportedRobot imported = import_robot(folder_.path() / "robot.urdf", told);
  EXPECT_EQ(imported.plan.legs[0].foot, "right_foot") << "the left one, seen from behind";
}
TEST_F(NoHumanoid, ThatIsSaidToLookAcrossItsLegsIsRefused) {
  ImportOptions told;
  told.plan.forward = Eigen::Vector3d::UnitY();
  EXPECT_THAT(complaint(told), testing::AllOf(HasSubstr("y was said"), HasSubstr("--forward x or -x")));
}
TEST_F(NoHumanoid, NoLegsJointAndNoUnknownOneIsHeldStill) {
  ImportOptions held;
  held.held_still = {"left_knee"};
  EXPECT_THAT(complaint(held), HasSubstr("'left_knee' is a leg's joint"));
  held.held_still = {"wing"};
  EXPECT_THAT(complaint(held), HasSubstr("--hold 'wing': no joint that turns by itself is called so"));
}

TEST(HeldStill, AJointIsMergedAndTheMassStays) {
  const test::MakerFolder folder;
  const std::filesystem::path file = test::write_humanoid({}, folder.path());
  ImportOptions held;
  held.held_still = {"waist_yaw"};
  const ImportedRobot free = import_robot(file, {}), still = import_robot(file, held);
  EXPECT_FALSE(still.robot.joint_index("waist_yaw"));
  EXPECT_EQ(still.robot.joints.size() + 1, free.robot.joints.size());
  EXPECT_NEAR(total_mass_kg(still.robot), total_mass_kg(free.robot), 1e-9);
  EXPECT_THAT(still.held_still, testing::ElementsAre("waist_yaw"));
}

TEST(HeldStill, TheJointsThatCarryLeastGoFirstAndInPairs) {
  const test::MakerFolder folder;
  const ImportedRobot all = import_robot(test::write_humanoid({}, folder.path()), {});
  const ImportedRobot fewer = with_fewer_joints(all, 19);
  EXPECT_LE(fewer.robot.joints.size(), 19U);
  for (const char* const side : {"left_", "right_"}) {
    EXPECT_FALSE(fewer.robot.joint_index(std::string(side) + "arm_3_joint"));
    EXPECT_TRUE(fewer.robot.joint_index(std::string(side) + "knee"));
  }
  EXPECT_EQ(fewer.drives.size(), fewer.robot.joints.size());
  EXPECT_EQ(fewer.home.angle_rad.size(), fewer.robot.joints.size());
  EXPECT_THROW((void)with_fewer_joints(all, 11), std::invalid_argument);
}

}  // namespace
}  // namespace gaitway::importer
