// The simulated robot stands, falls, feels and repeats itself.
#include "gaitway/simulator/plant.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "gaitway/simulator/camera.hpp"

namespace gaitway::simulator {
namespace {

urdf::RobotModel robot() {
  return urdf::load_robot(std::filesystem::path(GAITWAY_SOURCE_DIR) / "urdf" / "humanoid22");
}

// Holds the home posture with each joint's own servo gains.
class HomeServo {
 public:
  explicit HomeServo(const urdf::RobotModel& model) : model_(model), torque_(model.joints.size()) {}
  std::span<const double> operator()(const Plant& plant) {
    for (std::size_t j = 0; j < torque_.size(); ++j) {
      const urdf::Joint& joint = model_.joints[j];
      const double angle = plant.sensors().encoder_count[j] * joint.encoder_count_rad;
      torque_[j] = joint.servo.stiffness_Nm_per_rad * (joint.home_rad - angle) -
                   joint.servo.damping_Nms_per_rad * plant.velocities()[6 + j];
    }
    return torque_;
  }

 private:
  const urdf::RobotModel& model_;
  std::vector<double> torque_;
};

class PlantTest : public ::testing::Test {
 protected:
  void stand(Plant& plant, double seconds) {
    HomeServo servo(model_);
    for (int i = 0; i < static_cast<int>(seconds * 1000); ++i) {
      plant.step(servo(plant));
    }
  }
  urdf::RobotModel model_ = robot();
  PlantOptions exact_{.seed = 1, .mismatch = 0.0, .sensor_noise = false};
};

TEST_F(PlantTest, StandsInItsHomePostureUnderItsServos) {
  Plant plant(model_, exact_);
  stand(plant, 2.0);
  EXPECT_FALSE(plant.fallen());
  EXPECT_LT(plant.truth().trunk_tilt_rad, 0.03);
  const GroundContact& contact = plant.ground_contact();
  EXPECT_NEAR(contact.normal_force_N[0] + contact.normal_force_N[1], model_.total_mass_kg() * 9.81, 1.0);
}

TEST_F(PlantTest, FallsWithoutTorqueAndSaysSo) {
  Plant plant(model_, exact_);
  const std::vector<double> nothing(model_.joints.size(), 0.0);
  for (int i = 0; i < 3000 && !plant.fallen(); ++i) {
    plant.step(nothing);
  }
  EXPECT_TRUE(plant.fallen());
}

TEST_F(PlantTest, TheCellsSeeTheCentreOfPressure) {
  Plant plant(model_, exact_);
  plant.push("trunk", Eigen::Vector3d::UnitX(), 0.5, 0.2);
  HomeServo servo(model_);
  for (int i = 0; i < 500; ++i) {
    plant.step(servo(plant));
    for (std::size_t foot = 0; foot < 2; ++foot) {
      const double force = plant.ground_contact().normal_force_N[foot];
      const auto& cells = plant.sensors().force_N[foot];
      EXPECT_NEAR(std::accumulate(cells.begin(), cells.end(), 0.0), force, 1e-9);
      if (force < 1.0) {
        continue;
      }
      Eigen::Vector2d moment = Eigen::Vector2d::Zero();
      for (std::size_t cell = 0; cell < 4; ++cell) {
        moment += cells[cell] * model_.feet[foot].cell_m[cell];
      }
      EXPECT_LT((moment / force - plant.ground_contact().foot_cop_m[foot]).norm(), 1e-9);
    }
  }
}

TEST_F(PlantTest, APushMovesTheBodyByItsImpulse) {
  Plant plant(model_, exact_);
  stand(plant, 0.5);
  const double before = plant.velocities()[0];
  plant.push("pelvis", Eigen::Vector3d(2.0, 0.0, 0.0), 1.0, 0.01);
  HomeServo servo(model_);
  for (int i = 0; i < 10; ++i) {
    plant.step(servo(plant));
  }
  EXPECT_GT(plant.velocities()[0] - before, 0.05);
  EXPECT_THROW(plant.push("tail", Eigen::Vector3d::UnitX(), 1.0, 0.1), std::invalid_argument);
}

TEST_F(PlantTest, TheImuFeelsGravityAtRestAndNothingInFreeFall) {
  Plant plant(model_, exact_);
  stand(plant, 1.0);
  EXPECT_NEAR(plant.sensors().acceleration_m_per_s2.norm(), 9.81, 0.2);
  urdf::RobotModel high = model_;
  Plant falling(high, exact_);
  const std::vector<double> nothing(model_.joints.size(), 0.0);
  falling.push("pelvis", Eigen::Vector3d::UnitZ(), 40.0, 0.05);  // off the ground
  bool weightless = false;
  for (int i = 0; i < 400; ++i) {
    falling.step(nothing);
    const auto& force = falling.ground_contact().normal_force_N;
    weightless = weightless || (i > 60 && force[0] + force[1] == 0.0 &&
                                falling.sensors().acceleration_m_per_s2.norm() < 3.0);
  }
  EXPECT_TRUE(weightless);
}

TEST_F(PlantTest, OneSeedGivesTheSameMotionToTheBitAndAnotherAnother) {
  const auto end_of = [this](std::uint64_t seed) {
    Plant plant(model_, {.seed = seed, .mismatch = 1.0, .sensor_noise = true});
    stand(plant, 0.5);
    std::vector<double> end(plant.positions().begin(), plant.positions().end());
    end.push_back(plant.sensors().acceleration_m_per_s2.x());
    return end;
  };
  EXPECT_EQ(end_of(3), end_of(3));
  EXPECT_NE(end_of(3), end_of(4));
}

TEST_F(PlantTest, MismatchScalesWhatThePlannerDoesNotKnow) {
  const auto zero_error = [this](double scale) {
    const Plant plant(model_, {.seed = 5, .mismatch = scale, .sensor_noise = false});
    double sum = 0.0;
    for (std::size_t j = 0; j < model_.joints.size(); ++j) {
      sum += std::abs(plant.sensors().encoder_count[j] * model_.joints[j].encoder_count_rad - model_.joints[j].home_rad);
    }
    return sum / static_cast<double>(model_.joints.size());
  };
  EXPECT_LT(zero_error(0.0), 1e-4);
  EXPECT_NEAR(zero_error(1.0), 0.8 * 0.00698, 0.003);  // mean of |N| is 0.8 sigma, sigma 0.4 deg
  EXPECT_NEAR(zero_error(2.0), 2.0 * zero_error(1.0), 2e-4);
}

TEST_F(PlantTest, TheMotorsFadeAtSpeed) {
  Plant plant(model_, exact_);
  std::vector<double> full(model_.joints.size(), 0.0);
  const auto elbow = static_cast<std::size_t>(model_.joint_index("left_elbow"));
  full[elbow] = 100.0;
  plant.step(full);
  EXPECT_NEAR(plant.sensors().motor_torque_Nm[elbow], 8.0, 0.01);
  for (int i = 0; i < 20; ++i) {
    plant.step(full);
    const double speed = plant.velocities()[6 + elbow];
    if (speed > 0.1 && speed < 8.0) {
      EXPECT_LT(plant.sensors().motor_torque_Nm[elbow], 8.0);
    }
  }
}

TEST_F(PlantTest, TheCameraSeesTheRobotAndTheStripIsAPicture) {
  const Plant plant(model_, exact_);
  Camera camera(plant, 160, 120);
  const Image image = camera.render(plant.positions());
  ASSERT_EQ(image.rgb.size(), 160U * 120U * 3U);
  const auto [darkest, brightest] = std::minmax_element(image.rgb.begin(), image.rgb.end());
  EXPECT_GT(*brightest - *darkest, 100) << "an empty picture";
  const auto file = std::filesystem::temp_directory_path() / "gaitway_film_strip_test.png";
  write_film_strip(file.string(), std::vector<Image>{image, image}, 2);
  EXPECT_GT(std::filesystem::file_size(file), 1000U);
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace gaitway::simulator
