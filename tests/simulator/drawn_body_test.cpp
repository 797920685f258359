// What the seed has drawn of joints and soles is in the physics, also after the world has changed around the
// robot.
#include <gtest/gtest.h>

#include "plant_implementation.hpp"
#include "world_fixture.hpp"

namespace gaitway::simulator {
namespace {

class DrawnBodyTest : public WorldTest {
 protected:
  DrawnBodyTest() { model_.parts_deviation = 1.0; }
  void expect_drawn(const Plant& plant) const {
    const Plant::Implementation& self = plant.implementation();
    const BodyTruth truth = plant.body_truth();
    ASSERT_EQ(truth.joints.size(), model_.joints.size());
    for (std::size_t j = 0; j < model_.joints.size(); ++j) {
      const urdf::Motor& motor = model_.joints[j].motor;
      const int address = self.velocity_address[j];
      EXPECT_DOUBLE_EQ(self.model->dof_frictionloss[address],
                       motor.friction_Nm * truth.joints[j].friction_factor);
      EXPECT_DOUBLE_EQ(self.model->dof_damping[address],
                       motor.damping_Nms_per_rad * truth.joints[j].damping_factor);
      const int play = mj_name2id(self.model.get(), mjOBJ_JOINT, (model_.joints[j].name + "_play").c_str());
      if (play < 0) continue;
      const mjtNum* const range = self.model->jnt_range + 2 * play;
      EXPECT_DOUBLE_EQ(range[1] - range[0], self.conditions.body.backlash_rad * truth.play_factor[j]);
      EXPECT_GE(truth.play_factor[j], 0.5);
      EXPECT_LE(truth.play_factor[j], 1.5);
    }
    for (const double sole : truth.sole_time_factor) {
      EXPECT_GE(sole, 0.6);
      EXPECT_LE(sole, 1.4);
    }
  }
};

// As the contacts have it, not the shapes.
class DrawnSoles : public DrawnBodyTest, public ::testing::WithParamInterface<bool> {};

TEST_P(DrawnSoles, GiveWayInTheirOwnTime) {
  const bool in_a_world = GetParam();
  PlantOptions drawn = in_a_world ? options("start: {position_m: [0, 0]}\n") : PlantOptions{};
  drawn.seed = 4;
  drawn.mismatch = 1.0;
  drawn.sensor_noise = false;
  Plant plant(model_, drawn);
  HomeServo(model_).hold(plant, 20);
  const Plant::Implementation& self = plant.implementation();
  const double ground_time_s = self.model->geom_solref[0];
  std::array<int, 2> contacts{};
  for (int i = 0; i < self.data->ncon; ++i) {
    const mjContact& contact = self.data->contact[i];
    for (std::size_t foot = 0; foot < 2; ++foot) {
      const int body = model_.feet[foot].link + 1;
      if (self.model->geom_bodyid[contact.geom[0]] != body &&
          self.model->geom_bodyid[contact.geom[1]] != body)
        continue;
      ++contacts[foot];
      EXPECT_NEAR(contact.solref[0], ground_time_s * plant.body_truth().sole_time_factor[foot], 1e-12);
    }
  }
  EXPECT_GT(contacts[0], 0);
  EXPECT_GT(contacts[1], 0);
}

INSTANTIATE_TEST_SUITE_P(On, DrawnSoles, ::testing::Values(false, true),
                         [](const auto& tested) { return tested.param ? "AWorldsFloor" : "APlainFloor"; });

TEST_F(DrawnBodyTest, IsInThePhysicsAndStaysWhenSomethingIsPutThere) {
  PlantOptions drawn = options("start: {position_m: [0, 0]}\n");
  drawn.mismatch = 1.0;
  Plant plant(model_, drawn);
  expect_drawn(plant);
  world::Solid box;
  box.name = "box";
  box.size_m.setConstant(0.2);
  box.pose.translation() = Eigen::Vector3d(1.0, 1.0, 0.1);
  plant.put(box, {0.8, 0.1, 0.1}, std::nullopt);
  expect_drawn(plant);
  EXPECT_NE(plant.body_truth().joints[0].friction_factor, 1.0);
  EXPECT_NE(plant.body_truth().sole_time_factor[0], plant.body_truth().sole_time_factor[1]);
}

TEST_F(DrawnBodyTest, IsAsDescribedWhereTheDescriptionSaysNothingOfParts) {
  model_.parts_deviation = 0.0;
  const Plant plant(model_, {.seed = 4, .mismatch = 1.0, .sensor_noise = false});
  expect_drawn(plant);
  const BodyTruth truth = plant.body_truth();
  EXPECT_EQ(truth.joints[0].friction_factor, 1.0);
  EXPECT_EQ(truth.joints[0].servo_stiffness_factor, 1.0);
  EXPECT_EQ(truth.sole_time_factor, (std::array<double, 2>{1.0, 1.0}));
  EXPECT_EQ(truth.imu.mounting, Eigen::Matrix3d::Identity());
}

TEST_F(DrawnBodyTest, FrictionIsTheMotorsAloneWhereAJointHasPlay) {
  PlantOptions drawn{.seed = 4, .mismatch = 1.0, .sensor_noise = false};
  drawn.conditions.body.backlash_rad = 0.01;
  const Plant plant(model_, drawn);
  expect_drawn(plant);
}

}  // namespace
}  // namespace gaitway::simulator
