// Signs and places of the gains, checked by forward kinematics.
#include "gaitway/stability/trim_feedback.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "gaitway/urdf/forward_kinematics.hpp"
#include "test_robot.hpp"

namespace gaitway::stability {
namespace {

using test::channel_of;
using test::humanoid;

// How far the trunk turns about world x and y (roll, pitch) when trims are added to the home posture and one
// foot stands still.
Eigen::Vector2d trunk_turn(const urdf::RobotModel& model, const std::array<double, kTrimChannels>& angle,
                           urdf::Side stance) {
  std::vector<double> posture;
  for (const urdf::Joint& joint : model.joints) posture.push_back(joint.home_rad);
  urdf::ForwardKinematics kinematics(model);
  const auto trunk_in_sole = [&]() -> Eigen::Matrix3d {
    kinematics.compute(posture);
    return kinematics.sole_pose(stance).linear().transpose() * kinematics.link_rotation(model.imu.link);
  };
  const Eigen::Matrix3d before = trunk_in_sole();
  for (std::size_t i = 0; i < posture.size(); ++i) {
    if (model.joints[i].trim_channel >= 0) {
      posture[i] += angle[static_cast<std::size_t>(model.joints[i].trim_channel)];
    }
  }
  const Eigen::AngleAxisd turn(trunk_in_sole() * before.transpose());
  return (turn.angle() * turn.axis()).head<2>();
}

class TrimSigns : public ::testing::TestWithParam<bool> {
 protected:
  TrimSigns() : model_(GetParam() ? test::robot_with_flipped_axes() : humanoid()) {}
  urdf::RobotModel model_;
};

TEST_P(TrimSigns, TrimsTurnTheTrunkAgainstItsErrorWhileTheFootStandsStill) {
  const auto gains = TrimGainMatrix(model_).gains({});
  for (std::size_t support = 0; support < 3; ++support) {
    for (const double error : {-0.04, 0.04}) {
      for (const urdf::Side stance : urdf::kSides) {
        if (support < 2 && support != static_cast<std::size_t>(stance)) continue;
        const double hip = support == kBothFeet ? 0.15 : 0.0;
        const auto pitched =
            msgclient::trim_angles(gains, static_cast<int>(support), {0.0, error, 0.0, 0.0}, 0.1);
        const Eigen::Vector2d pitch_turn = trunk_turn(model_, pitched, stance);
        EXPECT_NEAR(pitch_turn.y(), -(0.25 + hip) * error, 1e-6);
        EXPECT_NEAR(pitch_turn.x(), 0.0, 1e-6);
        const auto rolled =
            msgclient::trim_angles(gains, static_cast<int>(support), {error, 0.0, 0.0, 0.0}, 0.1);
        const Eigen::Vector2d roll_turn = trunk_turn(model_, rolled, stance);
        EXPECT_NEAR(roll_turn.x(), -0.25 * error, 1e-6);
        EXPECT_NEAR(roll_turn.y(), 0.0, 1e-6);
      }
    }
  }
}

TEST_P(TrimSigns, RatesActLikeAngles) {
  const auto gains = TrimGainMatrix(model_).gains({});
  const auto angle = msgclient::trim_angles(gains, 0, {0.0, 0.0, 0.5, -0.7}, 0.1);
  const Eigen::Vector2d turn = trunk_turn(model_, angle, urdf::Side::left);
  EXPECT_NEAR(turn.x(), -0.06 * 0.5, 1e-3);  // the two turns do not quite commute
  EXPECT_NEAR(turn.y(), 0.03 * 0.7, 1e-3);
}

INSTANTIATE_TEST_SUITE_P(Robots, TrimSigns, ::testing::Values(false, true),
                         [](const auto& robot) { return robot.param ? "FlippedAxes" : "Humanoid22"; });

TEST(TrimGainMatrix, NoseDownPressesTheToes) {
  // humanoid22's pitch axes point along +y: a trunk that is nose down turns the stance foot nose down against
  // the shin.
  const auto gains = TrimGainMatrix(humanoid()).gains({});
  const auto& row = gains.gain[kLeftFoot][channel_of(humanoid(), 0, 4)];
  EXPECT_FLOAT_EQ(row[1], 0.25F);
  EXPECT_FLOAT_EQ(row[3], 0.03F);
  EXPECT_FLOAT_EQ(row[0], 0.0F);
}

TEST(TrimGainMatrix, SwingLegGetsNothingAndBothAnklesWorkInDoubleSupport) {
  const auto gains = TrimGainMatrix(humanoid()).gains({});
  EXPECT_EQ(gains.channel_count, 8U);
  for (std::size_t side = 0; side < 2; ++side) {
    for (std::size_t channel = 0; channel < kTrimChannels; ++channel) {
      const bool own_ankle =
          channel == channel_of(humanoid(), side, 4) || channel == channel_of(humanoid(), side, 5);
      EXPECT_EQ(gains.gain[side][channel] != (std::array<float, 4>{}), own_ankle);
    }
    for (const std::size_t joint : {std::size_t{4}, std::size_t{5}}) {
      const std::size_t channel = channel_of(humanoid(), side, joint);
      EXPECT_EQ(gains.gain[kBothFeet][channel], gains.gain[side][channel]);
    }
    EXPECT_FLOAT_EQ(gains.gain[kBothFeet][channel_of(humanoid(), side, 2)][1], 0.15F);
    EXPECT_EQ(gains.gain[side][channel_of(humanoid(), side, 2)], (std::array<float, 4>{}));
  }
}

TEST(TrimGainMatrix, RobotWithoutTrimChannelsHasNoGains) {
  urdf::RobotModel model = humanoid();
  for (urdf::Joint& joint : model.joints) joint.trim_channel = -1;
  EXPECT_EQ(TrimGainMatrix(model).gains({}), msgclient::TrimGains{});
}

}  // namespace
}  // namespace gaitway::stability
