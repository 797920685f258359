// The camera in the whole chain: it takes no part in the run but by its pictures, takes none for nobody, and
// a robot without one has none.
#include "gaitway/simulator/stereo_camera.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <memory>

#include "gaitway/msgclient/topics.hpp"
#include "gaitway/simulator/cosimulation.hpp"
#include "gaitway/world/world_file.hpp"

namespace gaitway::scenarios {
namespace {

using testing::HasSubstr;

simulator::CosimulationOptions options(bool always) {
  simulator::CosimulationOptions result;
  result.plant.seed = 4;
  result.plant.world = world::read_world(GAITWAY_WORLDS "/course.yaml");
  result.main_controller.configuration = GAITWAY_CONFIGURATION;
  result.main_controller.plugin_path = {GAITWAY_PLUGIN_DIR};
  result.camera.always = always;
  return result;
}

struct Seen {
  std::vector<double> positions;
  simulator::PicturePair pair;
  std::int64_t published_ns = 0;
  std::uint64_t in_topic = 0;
};

// Two seconds of walking.
Seen walked(bool always) {
  static const urdf::RobotModel robot = urdf::load_robot(GAITWAY_ROBOT);
  simulator::Cosimulation run(robot, options(always));
  auto reader = run.client().read<StereoPictures>("stereo_pictures");
  run.apply({0.0, simulator::WalkEvent{.velocity_m_per_s = {0.15, 0.0}}});
  while (run.now_ns() < 2'000'000'000) run.advance_millisecond();
  Seen seen{.positions = {run.plant().positions().begin(), run.plant().positions().end()},
            .pair = run.camera()->newest()};
  const auto message = std::make_unique<StereoPictures>();
  if (const auto result = reader.read(*message)) {
    seen.published_ns = result.stamp_ns;
    seen.in_topic = message->number;
  }
  return seen;
}

TEST(StereoCameraInTheChain, ChangesNothingButItsTopicAndIsTheSameToTheBit) {
  const Seen with = walked(true), again = walked(true), without = walked(false);
  EXPECT_EQ(with.pair.number, 25U);
  EXPECT_EQ(with.in_topic, 25U);
  EXPECT_EQ(with.published_ns, with.pair.stamp_ns + 30'000'000);
  EXPECT_EQ(with.pair.grey, again.pair.grey);
  EXPECT_EQ(with.positions, without.positions);
  EXPECT_EQ(without.pair.number, 0U) << "nobody wants pictures";
  EXPECT_EQ(without.in_topic, 0U);
}

TEST(StereoCameraInTheChain, ARobotWithoutACameraHasNoneAndNoFaultOfOne) {
  std::string folder = (std::filesystem::temp_directory_path() / "gaitway-blind-XXXXXX").string();
  ASSERT_NE(mkdtemp(folder.data()), nullptr);
  for (const char* const file : {"robot.urdf", "robot.yaml"}) {
    std::filesystem::copy_file(std::filesystem::path(GAITWAY_ROBOT) / file,
                               std::filesystem::path(folder) / file);
  }
  const urdf::RobotModel robot = urdf::load_robot(folder);
  simulator::Cosimulation run(robot, options(true));
  run.advance_millisecond();
  EXPECT_EQ(run.camera(), nullptr);
  try {
    run.apply({0.0, simulator::CameraFault{}});
    ADD_FAILURE() << "a fault of nothing";
  } catch (const urdf::RobotError& error) {
    EXPECT_THAT(error.what(), HasSubstr("camera.yaml"));
  }
  std::filesystem::remove_all(folder);
}

TEST(StereoCameraInTheChain, AFaultOfTheScenarioReachesIt) {
  static const urdf::RobotModel robot = urdf::load_robot(GAITWAY_ROBOT);
  simulator::Cosimulation run(robot, options(true));
  run.apply({0.0, simulator::CameraFault{.how = simulator::CameraFault::How::dead,
                                         .camera = simulator::CameraFault::Camera::right}});
  while (run.now_ns() < 60'000'000) run.advance_millisecond();
  const simulator::PicturePair& pair = run.camera()->newest();
  ASSERT_EQ(pair.number, 1U);
  EXPECT_EQ(*std::ranges::max_element(pair.grey[1]), 0);
  EXPECT_GT(*std::ranges::max_element(pair.grey[0]), 0);
}

}  // namespace
}  // namespace gaitway::scenarios
