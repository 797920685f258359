// Falls of a pendulum whose impact is known, and what must not be taken for one.
#include "gaitway/zmp/fall_recognition.hpp"
#include "gaitway/facts/facts.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace gaitway::zmp {
namespace {

constexpr double kPi = std::numbers::pi;
using facts::kSlot_s;
constexpr double kHeight_m = 0.38;
constexpr double kHalfLength_m = 0.0675, kHalfWidth_m = 0.0425, kFootAside_m = 0.05;

std::array<Eigen::Vector3d, 4> sole(const Eigen::Vector2d& centre_m) {
  std::array<Eigen::Vector3d, 4> corners;
  std::size_t i = 0;
  for (const double x : {-kHalfLength_m, kHalfLength_m}) {
    for (const double y : {-kHalfWidth_m, kHalfWidth_m}) {
      const Eigen::Vector2d corner = centre_m + Eigen::Vector2d(x, y);
      corners[i++] = {corner.x(), corner.y(), 0.0};
    }
  }
  return corners;
}

FallInputs standing() {
  FallInputs inputs;
  inputs.body.com_m = {0.0, 0.0, kHeight_m};
  inputs.body.sole_corner_m = {sole({0.0, kFootAside_m}), sole({0.0, -kFootAside_m})};
  inputs.load_share = 1.0;
  return inputs;
}

// A rigid body that tips over the middle of an edge in `direction`, integrated finely.
class TippingBody {
 public:
  TippingBody(double direction_rad, double rate_rad_per_s)
      : direction_rad_(direction_rad), rate_(rate_rad_per_s) {
    const bool sideways = std::abs(std::sin(direction_rad)) > 0.5;
    edge_m_ = sideways ? kFootAside_m + kHalfWidth_m : kHalfLength_m;
    tilt_rad_ = std::atan2(-edge_m_, kHeight_m);
    length_m_ = std::hypot(edge_m_, kHeight_m);
  }
  void tick() {
    constexpr int kSteps = 100;
    for (int i = 0; i < kSteps; ++i) {
      rate_ += kSlot_s / kSteps * 9.81 / (length_m_ * TippingModel{}.inertia_factor) * std::sin(tilt_rad_);
      tilt_rad_ += kSlot_s / kSteps * rate_;
    }
  }
  [[nodiscard]] FallInputs inputs() const {
    const Eigen::Vector2d out(std::cos(direction_rad_), std::sin(direction_rad_));
    FallInputs inputs = standing();
    inputs.body.com_m.head<2>() = out * (edge_m_ + length_m_ * std::sin(tilt_rad_));
    inputs.body.com_m.z() = length_m_ * std::cos(tilt_rad_);
    inputs.body.com_velocity_m_per_s.head<2>() = out * length_m_ * std::cos(tilt_rad_) * rate_;
    inputs.body.com_velocity_m_per_s.z() = -length_m_ * std::sin(tilt_rad_) * rate_;
    inputs.trunk_tilt_rad = std::max(0.0, tilt_rad_);
    return inputs;
  }
  [[nodiscard]] bool has_hit() const { return tilt_rad_ >= TippingModel{}.impact_tilt_rad; }
  [[nodiscard]] double tilt_rad() const { return tilt_rad_; }

 private:
  double direction_rad_, rate_, edge_m_ = 0.0, tilt_rad_ = 0.0, length_m_ = 0.0;
};

TEST(Tipping, ABodyThatStandsStillDoesNotTip) {
  const Tipping tipping = tipping_of(standing().body, {});
  EXPECT_LT(tipping.state, -0.1);
  EXPECT_EQ(tipping.time_to_impact_s, kNoImpact_s);
}

TEST(Tipping, IsZeroWhereTheBodyJustComesToRestOverTheEdge) {
  for (const double rate : {0.70, 0.76, 0.82, 0.90}) {
    TippingBody body(0.0, rate);
    const bool told = tipping_of(body.inputs().body, {}).state > 0.0;
    for (int i = 0; i < 150 && !body.has_hit() && body.tilt_rad() < 0.3; ++i) body.tick();
    EXPECT_EQ(told, body.tilt_rad() > 0.0) << "tilt rate " << rate;
  }
}

TEST(Tipping, PredictsTheImpactOfAPendulumInEachDirection) {
  for (const double direction_rad : {0.0, kPi / 2.0, kPi, -kPi / 2.0}) {
    TippingBody body(direction_rad, 2.0);
    std::vector<double> predicted_s;
    while (!body.has_hit()) {
      const Tipping tipping = tipping_of(body.inputs().body, {});
      EXPECT_NEAR(tipping.direction.x(), std::cos(direction_rad), 1e-9);
      EXPECT_NEAR(tipping.direction.y(), std::sin(direction_rad), 1e-9);
      predicted_s.push_back(tipping.time_to_impact_s);
      body.tick();
    }
    ASSERT_GT(predicted_s.size(), 20U);
    for (std::size_t i = 0; i < predicted_s.size(); ++i) {
      EXPECT_NEAR(predicted_s[i], kSlot_s * static_cast<double>(predicted_s.size() - i), 0.03) << i;
    }
  }
}

TEST(Tipping, DoesNotCareHowTheFrameIsTurned) {
  TippingBody body(0.0, 2.0);
  for (int i = 0; i < 10; ++i) body.tick();
  const BodyOverFeet straight = body.inputs().body;
  const Tipping wanted = tipping_of(straight, {});
  for (double angle_rad = -3.0; angle_rad < 3.1; angle_rad += 0.37) {
    const Eigen::AngleAxisd turn(angle_rad, Eigen::Vector3d::UnitZ());
    BodyOverFeet turned = straight;
    turned.com_m = turn * straight.com_m;
    turned.com_velocity_m_per_s = turn * straight.com_velocity_m_per_s;
    for (auto& foot : turned.sole_corner_m) {
      for (Eigen::Vector3d& corner : foot) corner = turn * corner;
    }
    const Tipping tipping = tipping_of(turned, {});
    EXPECT_NEAR(tipping.state, wanted.state, 1e-9);
    EXPECT_NEAR(tipping.direction.x(), std::cos(angle_rad), 1e-6);
  }
}

class FallRecognitionTest : public ::testing::Test {
 protected:
  void run(const FallInputs& inputs, int ticks) {
    for (int i = 0; i < ticks; ++i) recognition_.update(inputs);
  }
  // Until told; returns how long before the impact, negative if only after it.
  double lead_s(TippingBody& body) {
    double lead_s = 0.0;
    bool told = false;
    for (; !body.has_hit(); body.tick()) {
      recognition_.update(body.inputs());
      told = told || recognition_.fall() == Fall::falls;
      lead_s += told ? kSlot_s : 0.0;
    }
    return told ? lead_s : -1.0;
  }
  static FallInputs beyond_the_margin() {
    TippingBody body(0.0, 3.0);
    for (int i = 0; i < 5; ++i) body.tick();
    return body.inputs();
  }
  FallRecognition recognition_{FallParameters{}};
};

TEST_F(FallRecognitionTest, TellsAFallAtLeastAQuarterOfASecondBeforeTheImpact) {
  for (const double direction_rad : {0.0, kPi / 2.0, kPi, -kPi / 2.0}) {
    for (const double rate : {1.6, 2.0, 2.5}) {
      recognition_ = FallRecognition(FallParameters{});
      TippingBody body(direction_rad, rate);
      EXPECT_GE(lead_s(body), 0.25) << direction_rad << " rad, " << rate << " rad/s";
      EXPECT_NEAR(std::remainder(recognition_.direction_rad() - direction_rad, 2.0 * kPi), 0.0, 1e-6);
    }
  }
}

TEST_F(FallRecognitionTest, DirectionIsAgainstTheTrunksHeading) {
  FallInputs inputs = beyond_the_margin();
  inputs.heading_rad = kPi / 2.0;
  run(inputs, 2);
  ASSERT_EQ(recognition_.fall(), Fall::falls);
  EXPECT_NEAR(recognition_.direction_rad(), -kPi / 2.0, 1e-9) << "to the right of where it looks";
}

TEST_F(FallRecognitionTest, ASpikeOfOneTickIsNoFall) {
  for (int i = 0; i < 50; ++i) {
    run(beyond_the_margin(), 1);
    run(standing(), 1);
    ASSERT_EQ(recognition_.fall(), Fall::upright);
  }
  run(beyond_the_margin(), 2);
  EXPECT_EQ(recognition_.fall(), Fall::falls);
}

TEST_F(FallRecognitionTest, ARobotThatIsCarriedDoesNotFall) {
  FallInputs inputs = standing();
  inputs.load_share = 0.0;
  run(inputs, 20);
  inputs.body = beyond_the_margin().body;
  run(inputs, 100);
  EXPECT_EQ(recognition_.fall(), Fall::upright);
}

TEST_F(FallRecognitionTest, NumbersThatAreNoneAreNoFall) {
  FallInputs inputs = beyond_the_margin();
  inputs.body.com_velocity_m_per_s.x() = std::numeric_limits<double>::quiet_NaN();
  run(inputs, 100);
  EXPECT_EQ(recognition_.fall(), Fall::upright);
  EXPECT_TRUE(std::isfinite(recognition_.direction_rad() + recognition_.time_to_impact_s()));
}

TEST_F(FallRecognitionTest, LiesAfterTheImpactAndStandsOnlyAfterHalfASecondOnItsFeet) {
  TippingBody body(0.0, 2.0);
  ASSERT_GT(lead_s(body), 0.0);
  FallInputs lying = body.inputs();
  lying.trunk_tilt_rad = 1.4;
  lying.load_share = 0.1;
  run(lying, 60);
  EXPECT_EQ(recognition_.fall(), Fall::lies);
  EXPECT_EQ(recognition_.time_to_impact_s(), 0.0);
  run(lying, 500);
  EXPECT_EQ(recognition_.fall(), Fall::lies);
  run(standing(), 45);
  run(lying, 1);
  run(standing(), 45);
  EXPECT_EQ(recognition_.fall(), Fall::lies);
  run(standing(), 10);
  EXPECT_EQ(recognition_.fall(), Fall::upright);
}

TEST_F(FallRecognitionTest, FindsARobotThatLiesAtTheStart) {
  FallInputs lying = standing();
  lying.trunk_tilt_rad = 1.5;
  lying.load_share = 0.0;
  run(lying, 60);
  EXPECT_EQ(recognition_.fall(), Fall::lies);
}

// Steps of a linear inverted pendulum that walks; sway and speed are random, the swing foot glides to its
// place.
TEST_F(FallRecognitionTest, AnUndisturbedWalkNeverAlarms) {
  constexpr double kStep_s = 0.4;
  const double omega = std::sqrt(9.81 / kHeight_m);
  std::mt19937 random(7);
  for (int walk = 0; walk < 200; ++walk) {
    std::uniform_real_distribution<double> speed(-0.3, 0.6), spacing(0.08, 0.14);
    const Eigen::Vector2d stride(speed(random) * kStep_s, 0.0);
    const double aside_m = 0.5 * spacing(random);
    const double growth = std::exp(omega * kStep_s);
    Eigen::Vector2d stance(0.0, aside_m), from = Eigen::Vector2d(0.0, -aside_m) - stride;
    double side = 1.0;
    // The limit cycle: ahead it leaves each foot by stride / (growth - 1), aside towards the other foot.
    const auto offset = [&] {
      return Eigen::Vector2d(stride.x() / (growth - 1.0), -side * 2.0 * aside_m / (growth + 1.0));
    };
    Eigen::Vector2d com = stance + 0.5 * Eigen::Vector2d(-stride.x(), -side * aside_m);
    for (int step = 0; step < 20; ++step) {
      const Eigen::Vector2d next(stance.x() + stride.x(), -stance.y());
      const Eigen::Vector2d start = offset();
      for (double t_s = 0.0; t_s < kStep_s - 1e-9; t_s += kSlot_s) {
        const Eigen::Vector2d dcm = stance + start * std::exp(omega * t_s);
        const Eigen::Vector2d velocity = omega * (dcm - com);
        FallInputs inputs = standing();
        inputs.body.com_m.head<2>() = com;
        inputs.body.com_velocity_m_per_s.head<2>() = velocity;
        inputs.body.sole_corner_m = {sole(stance), sole(from + (next - from) * t_s / kStep_s)};
        recognition_.update(inputs);
        ASSERT_EQ(recognition_.fall(), Fall::upright)
            << "walk " << walk << ", step " << step << ", " << t_s << " s";
        com += kSlot_s * velocity;
      }
      from = stance;
      stance = next;
      side = -side;
    }
  }
}

TEST(FallParameters, RefusesNonsenseByName) {
  FallParameters parameters;
  parameters.margin = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(FallRecognition{parameters}, std::invalid_argument);
  parameters = {};
  parameters.model.inertia_factor = 0.0;
  try {
    parameters.validate();
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("fall_inertia is 0"), std::string::npos) << error.what();
  }
}

// What takes half a second with humanoid22 takes the root of two longer with a body twice as large.
TEST(FallParameters, ALargerBodyTakesLongerToLie) {
  const auto ticks_until_it_lies = [](const FallParameters& parameters) {
    FallRecognition recognition(parameters);
    FallInputs tilted;
    tilted.trunk_tilt_rad = 1.3;
    int ticks = 0;
    while (recognition.fall() != Fall::lies && ticks < 500) {
      recognition.update(tilted);
      ++ticks;
    }
    return ticks;
  };
  FallParameters large;
  scale_to_body(large.numbers(), facts::BodyScale(0.72, 54.72));
  EXPECT_EQ(ticks_until_it_lies(FallParameters{}), 50);
  EXPECT_EQ(ticks_until_it_lies(large), 71);
}

}  // namespace
}  // namespace gaitway::zmp
