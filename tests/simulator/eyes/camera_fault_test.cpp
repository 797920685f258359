// Each fault does what it is called, for as long as it lasts, and nothing else.
#include <gtest/gtest.h>

#include "eyes_fixture.hpp"

namespace gaitway::simulator {
namespace {

using How = CameraFault::How;
using Which = CameraFault::Camera;

class CameraFaultTest : public EyesTest {
 protected:
  // The newest pair after so long; the fifth one.
  [[nodiscard]] PicturePair with(const CameraFault& fault, int ms = 380) {
    const auto seeing = see(how_);
    seeing->camera.begin(fault, 0);
    seeing->wait(robot_, ms);
    seen_at_ns_ = seeing->now_ns;
    return seeing->camera.newest();
  }
  [[nodiscard]] PicturePair sound() { return with({.how = How::late, .later_s = 1e-9}); }

  static constexpr const char* kRoom =
      "surfaces: {boards: {noise: [[0.2, 0.2, 0.2], [0.8, 0.8, 0.8]], repeat_m: 0.9}}\nfloor: {surface: "
      "boards}\n"
      "lights: [{sun: [0.2, 0.1, -1]}]\n";
  PlantOptions how_ = options(kRoom);
  Plant robot_{model_, how_};
  std::int64_t seen_at_ns_ = 0;
};

TEST_F(CameraFaultTest, ADeadCameraIsBlackAndTheOtherOneSees) {
  const PicturePair pair = with({.how = How::dead, .camera = Which::left});
  EXPECT_EQ(*std::ranges::max_element(pair.grey[0]), 0);
  EXPECT_EQ(pair.grey[1], sound().grey[1]) << "to the bit as without the fault";
}

TEST_F(CameraFaultTest, ADarkOneSeesNextToNothingButNoise) {
  const PicturePair pair = with({.how = How::dark, .camera = Which::right});
  EXPECT_LT(mean(pair.grey[1]), 20.0);
  EXPECT_GT(*std::ranges::max_element(pair.grey[1]), 0);
  EXPECT_EQ(pair.grey[0], sound().grey[0]);
}

TEST_F(CameraFaultTest, AnOverExposedOneIsWhite) {
  EXPECT_GT(mean(with({.how = How::over_exposed, .camera = Which::left}).grey[0]), 240.0);
}

TEST_F(CameraFaultTest, ExchangedOnesShowEachOthersPicture) {
  const PicturePair pair = with({.how = How::exchanged}), before = sound();
  EXPECT_EQ(pair.grey[0], before.grey[1]);
  EXPECT_EQ(pair.grey[1], before.grey[0]);
}

TEST_F(CameraFaultTest, OneThatIsTurnedSeesEverythingElsewhere) {
  robot_.put(ball("ball", {1.0, 0.0, 0.5}, 0.06), {0.0, 0.0, 0.0}, std::nullopt);
  const Eigen::Vector2d told = pixel_of(robot_, {1.0, 0.0, 0.5}, urdf::Side::right);
  const auto seen = [&](const PicturePair& pair) {
    return dark_around(pair, urdf::Side::right, told, 14.0).centre;
  };
  const Eigen::Vector2d from = seen(sound());
  const Eigen::Vector2d to =
      seen(with({.how = How::turned, .camera = Which::right, .turn_deg = {1.0, 0.0, 0.0}}));
  EXPECT_NEAR((to - from).x(), 0.0, 0.7);
  EXPECT_NEAR((to - from).y(), file_of_camera_.lens[1].fy_px * facts::kRadPerDegree, 0.7)
      << "about x: it looks up, and what it sees goes down";
}

TEST_F(CameraFaultTest, DroppedPairsDoNotCome) {
  EXPECT_EQ(with({.how = How::dropped, .duration_s = 0.25}).number, 5U) << "after it they do";
  EXPECT_EQ(with({.how = How::dropped}).number, 0U);
  const std::uint64_t last = with({.how = How::dropped, .share = 0.5}, 3000).number;
  EXPECT_GT(last, 30U);
}

TEST_F(CameraFaultTest, LatePairsComeInOrderWithTheirOwnStamps) {
  const PicturePair pair = with({.how = How::late, .later_s = 0.2});
  EXPECT_EQ(pair.number, 2U);
  EXPECT_EQ(pair.stamp_ns, 88'000'000);
  EXPECT_EQ(pair.grey, with({.how = How::dropped, .share = 0.0}, 160).grey)
      << "the picture itself is as ever";
}

TEST_F(CameraFaultTest, AFrozenOneShowsTheSameAgain) {
  const auto seeing = see(how_);
  seeing->wait(robot_, 60);
  const PicturePair first = seeing->camera.newest();
  seeing->camera.begin({.how = How::frozen, .camera = Which::left, .duration_s = 0.2}, seeing->now_ns);
  seeing->wait(robot_, 160);
  const PicturePair later = seeing->camera.newest();
  EXPECT_GT(later.number, first.number);
  EXPECT_GT(later.stamp_ns, first.stamp_ns);
  EXPECT_EQ(later.grey[0], first.grey[0]);
  EXPECT_NE(later.grey[1], first.grey[1]) << "noise alone makes a living camera's pictures differ";
  seeing->wait(robot_, 160);
  EXPECT_NE(seeing->camera.newest().grey[0], first.grey[0]);
}

TEST_F(CameraFaultTest, ANewerFaultOfAKindTakesTheOldOnesPlace) {
  const auto seeing = see(how_);
  seeing->camera.begin({.how = How::dead, .camera = Which::left}, 0);
  seeing->camera.begin({.how = How::dead, .camera = Which::both, .duration_s = 0.1}, 0);
  seeing->wait(robot_, 220);
  EXPECT_GT(mean(seeing->camera.newest().grey[0]), 20.0) << "the one for ever is gone";
}

}  // namespace
}  // namespace gaitway::simulator
