// Bodies that nobody has seen are brought with a gait, or refused with a reason; the first of them stand.
// GAITWAY_RANDOM_BODIES=1000 random_bodies_tests brings more than the usual number of them.
#include <gtest/gtest.h>

#include <cstdlib>
#include <random>

#include "gaitway/importer/import.hpp"
#include "gaitway/input/complaint.hpp"
#include "gaitway/process/private_folder.hpp"
#include "gaitway/simulator/cosimulation.hpp"
#include "gaitway/trajectory/robot_gait.hpp"
#include "gaitway/urdf/robot_model.hpp"
#include "generated_humanoid.hpp"
#include "tools/run/run_recorder.hpp"

namespace gaitway::importer {
namespace {

using test::Humanoid;

int bodies() {
  constexpr int kUsual = 60;
  const char* const wanted = std::getenv("GAITWAY_RANDOM_BODIES");
  return wanted ? std::atoi(wanted) : kUsual;
}

Humanoid random_body(std::uint64_t seed) {
  std::mt19937_64 engine(seed);
  const auto between = [&](double least, double most) {
    return least + (most - least) * static_cast<double>(engine() >> 11U) * 0x1p-53;
  };
  const auto maybe = [&] { return (engine() & 1U) != 0; };
  Humanoid body;
  body.hip_height_m = between(0.25, 1.3);
  // The density of humanoids, half of it to twice of it.
  body.mass_kg = 80.0 * std::pow(body.hip_height_m, 3) * between(0.5, 2.0);
  std::shuffle(body.hip.begin(), body.hip.end(), engine);
  std::shuffle(body.ankle.begin(), body.ankle.end(), engine);
  body.turned_axes = static_cast<std::uint32_t>(engine() % 64U);
  body.hip_offset = maybe() ? between(-0.05, 0.05) : 0.0;
  for (std::uint64_t quarter = engine() % 4U; quarter > 0; --quarter) {
    Eigen::Matrix3d turn;
    turn << 0, -1, 0, 1, 0, 0, 0, 0, 1;
    body.base_in_root = turn * body.base_in_root;
  }
  body.plain_names = maybe();
  body.fixed_joints = maybe();
  body.massless_hip_links = maybe();
  body.foot = static_cast<test::FootShape>(engine() % 4U);
  body.foot_length = between(0.15, 0.35);
  body.foot_width = between(0.08, 0.18);
  body.foot_ahead = between(0.0, 0.08);
  body.thigh = between(0.40, 0.52);
  body.arm_joints = static_cast<int>(engine() % 8U);
  body.arm_share = between(0.02, 0.08);
  body.toes = maybe();
  body.imu_frame = maybe();
  body.unsound_inertia = maybe();
  return body;
}

bool falls_while_standing(const urdf::RobotModel& robot) {
  simulator::CosimulationOptions how;
  how.plant.seed = 1;
  how.main_controller.configuration = std::filesystem::path(GAITWAY_SOURCE_DIR) / "core/config/walk.yaml";
  how.main_controller.plugin_path = {GAITWAY_PLUGIN_DIR};
  simulator::Cosimulation run(robot, how);
  tools::RunRecorder recorder(run, {}, false);
  run.observe(&recorder);
  constexpr int kStands_ms = 4000;
  for (int i = 0; i < kStands_ms && !recorder.metrics().fell; ++i) run.advance_millisecond();
  return recorder.metrics().fell;
}

TEST(RandomBodies, AreBroughtWithAGaitOrRefusedWithAReasonAndStand) {
  constexpr int kStanding = 10;
  int walk = 0, refused = 0, stood = 0, fell = 0;
  for (int seed = 1; seed <= bodies(); ++seed) {
    SCOPED_TRACE("body " + std::to_string(seed));
    const process::PrivateFolder folder("gaitway-body");
    ImportedRobot imported;
    try {
      imported = import_robot(
          test::write_humanoid(random_body(static_cast<std::uint64_t>(seed)), folder.path() / "maker"), {});
    } catch (const input::InputError& reason) {
      EXPECT_FALSE(std::string(reason.what()).empty());
      std::printf("body %d: %s\n", seed, reason.what());
      ++refused;
      continue;
    }
    // What was brought must load: a complaint about a file that the import itself wrote is a fault.
    ASSERT_NO_THROW(write_robot_folder(imported, folder.path() / "out"));
    std::optional<urdf::RobotModel> robot;
    try {
      robot = urdf::load_robot(folder.path() / "out");
    } catch (const std::exception& fault) {
      ADD_FAILURE() << fault.what();
      continue;
    }
    try {
      trajectory::gait_of(*robot).validate();
      ++walk;
    } catch (const std::invalid_argument& reason) {
      std::printf("body %d: %s\n", seed, reason.what());
      ++refused;
      continue;
    }
    if (stood++ >= kStanding) continue;
    if (falls_while_standing(*robot)) {
      ++fell;
      ADD_FAILURE() << "falls while it stands";
    }
  }
  std::printf("%d bodies: %d have a gait, %d a reason, %d fell\n", bodies(), walk, refused, fell);
  EXPECT_GT(walk, bodies() / 2);
}

}  // namespace
}  // namespace gaitway::importer
