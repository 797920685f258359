// Sensors that the topics do not speak of are turned into those that they do.
#include "gaitway/msgcontroller/feedback_collector.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "gaitway/facts/facts.hpp"
#include "robots/robot_variants.hpp"

namespace gaitway::msgcontroller {
namespace {

using gaitway::test::RobotVariant;

// One robot's feedback, slot by slot.
class Feedback {
 public:
  explicit Feedback(const urdf::RobotModel& robot) : robot_(robot), collector_(robot, nodes_of(robot)) {}

  // All joints say this of all channels that have such a name.
  void slot(const std::map<std::string, double>& value) {
    collector_.begin_slot(++slot_);
    for (std::size_t joint = 0; joint < robot_.joints.size(); ++joint) {
      can::Feedback feedback{};
      for (std::size_t i = 0; i < 2; ++i) {
        const urdf::SensorChannel& channel = robot_.channels[joint][i];
        const auto found = value.find(urdf::channel_name(channel));
        if (found == value.end()) continue;
        feedback.channel[i] = static_cast<std::int16_t>(std::lround(found->second / channel.scale));
      }
      collector_.take(static_cast<int>(joint), feedback, facts::kSlot_ns * slot_);
    }
  }
  [[nodiscard]] const FeedbackCollector& collector() const { return collector_; }

 private:
  static std::vector<can::NodeId> nodes_of(const urdf::RobotModel& robot) {
    std::vector<can::NodeId> nodes;
    for (const urdf::Joint& joint : robot.joints) nodes.push_back(joint.node);
    return nodes;
  }
  urdf::RobotModel robot_;
  FeedbackCollector collector_;
  std::uint32_t slot_ = 0;
};

TEST(FeedbackCollector, ASixAxisSensorSpeaksAsFourCells) {
  RobotVariant variant;
  variant.give_six_axis_feet();
  const urdf::RobotModel robot = urdf::load_robot(variant.folder());
  Feedback feedback(robot);
  // 30 N at (40, -20) mm of the left sole; the right foot hangs in the air.
  feedback.slot({{"left_foot_force_z", 30.0}, {"left_foot_torque_x", -0.6}, {"left_foot_torque_y", -1.2}});
  const FootForces& forces = feedback.collector().foot_forces();
  const std::array<double, 4> expected = robot.feet[0].cell_forces_N(30.0, {0.04, -0.02});
  for (std::size_t cell = 0; cell < 4; ++cell) {
    EXPECT_NEAR(forces.force[0][cell], expected[cell], 0.02);
    EXPECT_EQ(forces.force[1][cell], 0.0);
  }
  EXPECT_EQ(forces.stamp_ns, facts::kSlot_ns);
}

// Upside down and turned to the left, as boards are mounted.
TEST(FeedbackCollector, AnImuThatIsTurnedSpeaksAlongItsLinksAxes) {
  const RobotVariant variant;
  urdf::RobotModel robot = urdf::load_robot(variant.folder());
  const Eigen::Matrix3d turn = (Eigen::AngleAxisd(0.5 * std::numbers::pi, Eigen::Vector3d::UnitZ()) *
                                Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitX()))
                                   .toRotationMatrix();
  robot.imu.pose.linear() = turn;
  // The link pitches forward by 0.1 rad, turns and is at rest otherwise.
  const Eigen::Vector3d up(-std::sin(0.1), 0.0, std::cos(0.1)), rate(0.1, 0.2, 0.3);
  const Eigen::Vector3d felt = turn.transpose() * up, turning = turn.transpose() * rate;
  Feedback feedback(robot);
  feedback.slot({{"acceleration_x", 9.81 * felt.x()},
                 {"acceleration_y", 9.81 * felt.y()},
                 {"acceleration_z", 9.81 * felt.z()},
                 {"angular_velocity_x", turning.x()},
                 {"angular_velocity_y", turning.y()},
                 {"angular_velocity_z", turning.z()},
                 {"inclination_roll", std::atan2(felt.y(), felt.z())},
                 {"inclination_pitch", std::atan2(-felt.x(), std::hypot(felt.y(), felt.z()))}});
  const Imu& imu = feedback.collector().imu();
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(imu.acceleration[axis], 9.81 * up[axis], 0.01);
    EXPECT_NEAR(imu.angular_velocity[axis], rate[axis], 0.001);
  }
  EXPECT_NEAR(imu.inclination[0], 0.0, 1e-3);
  EXPECT_NEAR(imu.inclination[1], 0.1, 1e-3);
}

// As a calibration has it.
TEST(FeedbackCollector, EachSensorOfTheImuIsLevelled) {
  const RobotVariant variant;
  urdf::RobotModel robot = urdf::load_robot(variant.folder());
  const Eigen::Vector3d ahead = Eigen::Vector3d::UnitY(), left = Eigen::Vector3d::UnitX();
  robot.imu.levelling = {.gyro = Eigen::AngleAxisd(0.02, left).toRotationMatrix(),
                         .accelerometer = Eigen::AngleAxisd(0.03, ahead).toRotationMatrix(),
                         .inclinometer = Eigen::AngleAxisd(0.04, ahead).toRotationMatrix()};
  Feedback feedback(robot);
  feedback.slot({{"acceleration_x", 9.81 * std::sin(-0.03)},
                 {"acceleration_z", 9.81 * std::cos(0.03)},
                 {"angular_velocity_y", std::cos(0.02)},
                 {"angular_velocity_z", std::sin(-0.02)},
                 {"inclination_pitch", 0.04}});
  const Imu& imu = feedback.collector().imu();
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(imu.acceleration[axis], axis == 2 ? 9.81 : 0.0, 0.01);
    EXPECT_NEAR(imu.angular_velocity[axis], axis == 1 ? 1.0 : 0.0, 0.001);
  }
  EXPECT_NEAR(imu.inclination[0], 0.0, 1e-3);
  EXPECT_NEAR(imu.inclination[1], 0.0, 1e-3);
}

class DerivedInclination : public ::testing::Test {
 protected:
  // A trunk that stands rolled and pitched by this much, turning at `rate`.
  static std::map<std::string, double> tilted(double roll_rad, double pitch_rad, double rate_rad_per_s) {
    const Eigen::Vector3d felt =
        facts::kGravity_m_per_s2 * Eigen::Vector3d(-std::sin(pitch_rad),
                                                   std::sin(roll_rad) * std::cos(pitch_rad),
                                                   std::cos(roll_rad) * std::cos(pitch_rad));
    return {{"acceleration_x", felt.x()}, {"acceleration_y", felt.y()},
            {"acceleration_z", felt.z()}, {"angular_velocity_y", rate_rad_per_s},
            {"inclination_roll", 0.3},    {"inclination_pitch", 0.3}};
  }
  [[nodiscard]] static urdf::RobotModel robot(bool has_inclinometer) {
    RobotVariant variant;
    if (!has_inclinometer) variant.take_inclinometer();
    return urdf::load_robot(variant.folder());
  }
};

TEST_F(DerivedInclination, IsThatOfTheAccelerometerAtRest) {
  Feedback feedback(robot(false));
  feedback.slot(tilted(0.1, -0.2, 0.0));
  EXPECT_NEAR(feedback.collector().imu().inclination[0], 0.1, 0.002);
  EXPECT_NEAR(feedback.collector().imu().inclination[1], -0.2, 0.002);
}

TEST_F(DerivedInclination, FollowsTheGyroAtOnceAndTheAccelerometerSlowly) {
  Feedback feedback(robot(false));
  feedback.slot(tilted(0.0, 0.0, 0.0));
  for (int i = 0; i < 10; ++i) feedback.slot(tilted(0.0, 0.0, 1.0));
  EXPECT_NEAR(feedback.collector().imu().inclination[1], 0.1, 0.015) << "what the gyro says";
  for (int i = 0; i < 300; ++i) feedback.slot(tilted(0.0, 0.0, 0.0));
  EXPECT_NEAR(feedback.collector().imu().inclination[1], 0.0, 0.005) << "what the accelerometer says";
}

TEST_F(DerivedInclination, DoesNotBelieveAnAccelerometerThatIsShaken) {
  Feedback feedback(robot(false));
  feedback.slot(tilted(0.0, 0.0, 0.0));
  for (int i = 0; i < 100; ++i) {
    auto shaken = tilted(0.0, 0.0, 0.0);
    shaken["acceleration_x"] = 6.0;
    feedback.slot(shaken);
  }
  EXPECT_NEAR(feedback.collector().imu().inclination[1], 0.0, 0.001);
}

TEST_F(DerivedInclination, IsTheInclinometersOwnWhereThereIsOne) {
  urdf::RobotModel fused = robot(true);
  fused.imu.inclinometer = urdf::Inclinometer::fused;
  Feedback feedback(fused);
  feedback.slot(tilted(0.1, -0.2, 0.0));
  EXPECT_NEAR(feedback.collector().imu().inclination[0], 0.3, 1e-4);
  EXPECT_NEAR(feedback.collector().tilt_rad().x(), 0.3, 1e-4);
}

// It is passed on as it is, but nobody balances by it.
TEST_F(DerivedInclination, OfAPendulumIsNoTilt) {
  Feedback feedback(robot(true));
  feedback.slot(tilted(0.1, -0.2, 0.0));
  EXPECT_NEAR(feedback.collector().imu().inclination[0], 0.3, 1e-4);
  EXPECT_NEAR(feedback.collector().tilt_rad().x(), 0.1, 0.002);
  EXPECT_NEAR(feedback.collector().tilt_rad().y(), -0.2, 0.002);
}

}  // namespace
}  // namespace gaitway::msgcontroller
