// Published descriptions are read as they are.
#include <algorithm>

#include "gaitway/importer/import.hpp"
#include "gaitway/urdf/robot_model.hpp"

#include "maker_folder.hpp"
#include "maker_robots.hpp"
#include "surface_measures.hpp"

namespace gaitway::importer {
namespace {

struct Example {
  const char* urdf;  // below the robots' folder
  double mass_kg;    // the plain sum of its <mass> elements
  std::size_t joints;
  double height_m;  // of its visual surfaces, at zero; 0: it has none
  int up = 2;       // axis
};

void PrintTo(const Example& example, std::ostream* stream) {
  *stream << example.urdf;
}

class ExampleRobot : public testing::TestWithParam<Example> {};

TEST_P(ExampleRobot, IsReadWithItsMassAndHeight) {
  GAITWAY_SKIP_WITHOUT_MAKER_ROBOTS();
  const Example& expected = GetParam();
  const MakerRobot robot = read_maker_urdf(*test::maker_robots() / expected.urdf, {});
  double mass_kg = 0.0;
  Eigen::AlignedBox3d box;
  const auto poses = link_poses(robot, std::vector<double>(robot.joints.size()));
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    mass_kg += robot.links[i].mass_kg;
    for (const VisualSurface& visual : robot.links[i].visual) {
      for (const Eigen::Vector3d& point : visual.surface.point_m) {
        box.extend(poses[i] * point);
      }
    }
  }
  EXPECT_NEAR(mass_kg, expected.mass_kg, 1e-4);
  EXPECT_EQ(robot.joints.size(), expected.joints);
  EXPECT_EQ(box.isEmpty(), expected.height_m == 0.0);
  if (!box.isEmpty()) {
    EXPECT_NEAR(box.sizes()[expected.up], expected.height_m, 0.01);
  }
}

TEST(ExampleRobots, HullsOfTheirMeshesFaceOutwards) {
  GAITWAY_SKIP_WITHOUT_MAKER_ROBOTS();
  const MakerRobot robot =
      read_maker_urdf(*test::maker_robots() / "talos_data/robots/talos_full_v2.urdf", {});
  for (const MakerLink& link : robot.links) {
    for (const VisualSurface& visual : link.visual) {
      const Surface hull = convex_hull(visual.surface, 64);
      EXPECT_LE(hull.point_m.size(), 64U);
      EXPECT_TRUE(test::is_closed(hull)) << hull.source;
      EXPECT_GT(test::volume_m3(hull), 0.0) << hull.source;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Published, ExampleRobot,
    testing::Values(Example{"talos_data/robots/talos_full_v2.urdf", 93.3357, 32, 1.76},
                    Example{"talos_data/robots/talos_reduced.urdf", 90.2722, 32, 1.75},
                    Example{"romeo_description/urdf/romeo.urdf", 40.5294, 33, 1.40},
                    Example{"romeo_description/urdf/romeo_small.urdf", 40.5294, 31, 1.40},
                    Example{"romeo_description/urdf/romeo_laas_small.urdf", 40.8, 33, 0.0},
                    Example{"g1_description/urdf/g1_29dof_rev_1_0.urdf", 33.3411, 29, 1.32},
                    Example{"g1_description/urdf/g1_29dof_with_hand_rev_1_0.urdf", 34.3942, 43, 1.32},
                    Example{"icub_description/robots/icub.urdf", 28.3469, 32, 1.05},
                    Example{"simple_humanoid_description/urdf/simple_humanoid.urdf", 130.8, 29, 0.0},
                    Example{"alexander_description/urdf/alexander_v1.lowerBodyOnly.urdf", 49.0807, 13, 1.39},
                    Example{"human_description/robots/human.urdf", 74.712, 36, 1.79, 1},
                    Example{"bolt_description/robots/bolt.urdf", 1.2539, 6, 0.53}),
    [](const auto& test) {
      std::string name = std::filesystem::path(test.param.urdf).stem();
      std::replace(name.begin(), name.end(), '.', '_');
      return name;
    });

class ExampleHumanoid : public testing::TestWithParam<const char*> {};

TEST_P(ExampleHumanoid, IsBroughtAndLoads) {
  GAITWAY_SKIP_WITHOUT_MAKER_ROBOTS();
  const test::MakerFolder folder;
  const ImportedRobot imported = import_robot(*test::maker_robots() / GetParam(), {});
  write_robot_folder(with_fewer_joints(imported, 24), folder.path() / "out");
  const urdf::RobotModel robot = urdf::load_robot(folder.path() / "out");
  EXPECT_NEAR(robot.total_mass_kg(), total_mass_kg(imported.robot), 0.01 * robot.total_mass_kg());
  EXPECT_NEAR(robot.hip_height_m, imported.home.hip_height_m, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(
    Published, ExampleHumanoid,
    testing::Values("talos_data/robots/talos_full_v2.urdf", "talos_data/robots/talos_full_v2_box.urdf",
                    "talos_data/robots/talos_reduced.urdf", "talos_data/robots/talos_reduced_box.urdf",
                    "talos_data/robots/talos_reduced_corrected.urdf", "romeo_description/urdf/romeo.urdf",
                    "romeo_description/urdf/romeo_small.urdf", "romeo_description/urdf/romeo_laas_small.urdf",
                    "g1_description/urdf/g1_29dof_rev_1_0.urdf",
                    "g1_description/urdf/g1_29dof_with_hand_rev_1_0.urdf",
                    "icub_description/robots/icub.urdf", "icub_description/robots/icub_reduced.urdf",
                    "alexander_description/urdf/alexander_v1.lowerBodyOnly.urdf",
                    "human_description/robots/human.urdf"),
    [](const auto& test) {
      std::string name = std::filesystem::path(test.param).stem();
      std::replace(name.begin(), name.end(), '.', '_');
      return name;
    });

TEST(ExampleRobots, WithoutLimitsOrAnklesAreRefusedForIt) {
  GAITWAY_SKIP_WITHOUT_MAKER_ROBOTS();
  const auto complaint = [](const char* urdf) -> std::string {
    try {
      (void)import_robot(*test::maker_robots() / urdf, {});
    } catch (const input::InputError& error) {
      return error.what();
    }
    return "(brought without complaint)";
  };
  EXPECT_THAT(complaint("simple_humanoid_description/urdf/simple_humanoid.urdf"),
              testing::HasSubstr("limit"));
  EXPECT_THAT(complaint("bolt_description/robots/bolt.urdf"), testing::HasSubstr("joints only"));
}

}  // namespace
}  // namespace gaitway::importer
