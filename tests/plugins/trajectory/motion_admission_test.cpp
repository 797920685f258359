// Who may begin which motion, and what the others are told.
#include "gaitway/trajectory/motion_admission.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

namespace gaitway::trajectory {
namespace {

constexpr double kQuarterTurn_rad = 0.5 * std::numbers::pi;

MotionTable motion(const std::string& name, bool on_ground, std::optional<LyingSide> lies_on = {}) {
  MotionTable table;
  table.name = name;
  table.on_ground = on_ground;
  table.lies_on = lies_on;
  return table;
}

class Admission : public ::testing::Test {
 protected:
  // Asks for a motion with the trunk at this roll and pitch; what is answered.
  std::string ask(const std::string& name, double roll_rad, double pitch_rad) {
    MotionRequest request{};
    request.number = ++number_;
    std::memcpy(request.name, name.data(), name.size());
    Estimate estimate{};
    estimate.attitude[0] = roll_rad;
    estimate.attitude[1] = pitch_rad;
    const auto order = admission_.answer(request, {.estimate = &estimate}, player_, state_);
    EXPECT_TRUE(order.has_value());
    EXPECT_EQ(state_.answered, number_);
    EXPECT_EQ(order && order->kind == MotionOrder::Kind::play, state_.refused == 0);
    return reinterpret_cast<const char*>(state_.text);
  }

  const std::vector<MotionTable> motions_{
      motion("wave", false), motion("roll", true), motion("get_up_front", true, LyingSide::front),
      motion("get_up_back", true, LyingSide::back), motion("from_the_left", true, LyingSide::left)};
  const MotionPlayer player_{motions_};
  MotionAdmission admission_{motions_, urdf::load_robot(GAITWAY_ROBOTS "/humanoid22")};
  gaitway::MotionState state_{};
  std::uint32_t number_ = 0;
};

TEST_F(Admission, AMotionOfOneSideIsRefusedOnTheOpposite) {
  EXPECT_EQ(ask("get_up_front", 0.0, kQuarterTurn_rad), "'get_up_front' begins");
  EXPECT_EQ(ask("get_up_back", 0.0, kQuarterTurn_rad),
            "'get_up_back' cannot begin: it begins on the back, and the robot lies on its front");
  EXPECT_EQ(ask("get_up_back", 0.0, -kQuarterTurn_rad), "'get_up_back' begins");
  EXPECT_EQ(ask("get_up_front", 0.0, -kQuarterTurn_rad),
            "'get_up_front' cannot begin: it begins on the front, and the robot lies on its back");
}

// The roll of a trunk that points straight down or up is any.
TEST_F(Admission, TheSideIsTheOneThatPointsDownMost) {
  for (const double roll_rad : {-3.0, -1.5, 0.5, 3.0}) {
    EXPECT_EQ(ask("get_up_front", roll_rad, kQuarterTurn_rad - 0.1), "'get_up_front' begins");
    EXPECT_EQ(ask("get_up_back", roll_rad, -kQuarterTurn_rad + 0.1), "'get_up_back' begins");
  }
}

TEST_F(Admission, BetweenFrontAndBackEitherMayTry) {
  for (const double roll_rad : {-kQuarterTurn_rad, kQuarterTurn_rad}) {
    EXPECT_EQ(ask("get_up_front", roll_rad, -0.3), "'get_up_front' begins");
    EXPECT_EQ(ask("get_up_back", roll_rad, 0.3), "'get_up_back' begins");
  }
}

TEST_F(Admission, AMotionOfTheLeftIsRefusedOnTheRight) {
  EXPECT_EQ(ask("from_the_left", -kQuarterTurn_rad, 0.0), "'from_the_left' begins");
  EXPECT_EQ(ask("from_the_left", kQuarterTurn_rad, 0.0),
            "'from_the_left' cannot begin: it begins on the left, and the robot lies on its right");
}

TEST_F(Admission, AMotionThatSaysNoSideBeginsOnEach) {
  EXPECT_EQ(ask("roll", 0.0, kQuarterTurn_rad), "'roll' begins");
  EXPECT_EQ(ask("roll", kQuarterTurn_rad, 0.0), "'roll' begins");
}

TEST_F(Admission, AMotionOnTheGroundIsRefusedToARobotThatStandsAndViceVersa) {
  EXPECT_EQ(ask("get_up_front", 0.0, 0.1),
            "'get_up_front' cannot begin: it begins on the ground, and the robot does not lie there");
  EXPECT_EQ(ask("wave", 0.0, kQuarterTurn_rad),
            "'wave' cannot begin: it begins in the stand, and the robot does not stand");
  EXPECT_EQ(ask("wave", 0.0, 0.1), "'wave' begins");
}

}  // namespace
}  // namespace gaitway::trajectory
