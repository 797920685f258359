// Rows are exposed one after the other, and for a while: what a turning head sees.
#include "eyes/shutter.hpp"

#include <gtest/gtest.h>

#include "eyes_fixture.hpp"

namespace gaitway::simulator {
namespace {

using urdf::Side;

// Looks at a black pole straight ahead of the left camera.
class ShutterTest : public EyesTest {
 protected:
  ShutterTest() {
    world::Solid pole = ball("pole", {1.0, 0.03, 1.0}, 0.06);
    pole.shape = world::Solid::Shape::cylinder;
    pole.size_m.z() = 2.0;
    robot_.put(pole, {0.0, 0.0, 0.0}, std::nullopt);
    file_of_camera_.lens[0].distortion = {};  // upright poles stay straight
    file_of_camera_.left_in_link.linear() << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  }
  // While the neck turns to the left and the whole robot goes ahead.
  std::vector<float> take(double turn_rad_per_s, double speed_m_per_s, double exposure_s, double readout_s) {
    const int head = model_.link_index("head");
    SceneView view(robot_, head, {.shadow_px = 0});
    Shutter shutter(urdf::Lens(file_of_camera_.lens[0]), file_of_camera_.width_px, file_of_camera_.height_px,
                    1.5);
    const auto neck = static_cast<std::size_t>(model_.joint_index("neck_yaw"));
    std::vector<PictureInstant> instants;
    for (int ms = -20; ms <= 20; ++ms) {
      PictureInstant& one = instants.emplace_back();
      one.at_ns = 1'000'000'000 + ms * 1'000'000;
      one.positions.assign(robot_.positions().begin(), robot_.positions().end());
      one.positions[7 + neck] += turn_rad_per_s * 1e-3 * ms;
      one.positions[0] += speed_m_per_s * 1e-3 * ms;
      one.link = view.link_pose(one.positions, head);
    }
    std::vector<float> light;
    shutter.take(instants, {.middle_ns = 1'000'000'000, .exposure_s = exposure_s, .readout_s = readout_s},
                 file_of_camera_.left_in_link, view, light);
    bands_ = shutter.bands();
    return light;
  }
  // Middle of what is dark in a row, and how many pixels its left edge takes from a tenth to nine tenths.
  struct Row {
    double middle_px = 0.0, edge_px = 0.0;
  };
  [[nodiscard]] Row row_of(const std::vector<float>& light, int row) const {
    const int width = file_of_camera_.width_px;
    const auto at = [&](int column) {
      return static_cast<double>(light[static_cast<std::size_t>(row * width + column)]);
    };
    double most = 0.0, weight = 0.0;
    Row result;
    for (int column = 115; column < 205; ++column) most = std::max(most, at(column));
    double least = most;
    for (int column = 115; column < 205; ++column) least = std::min(least, at(column));
    for (int column = 115; column < 205; ++column) {
      const double dark = std::max(most - at(column) - 0.3 * (most - least), 0.0);
      result.middle_px += dark * column;
      weight += dark;
    }
    result.middle_px /= weight;
    int column = 115;
    while (at(column) > most - 0.1 * (most - least)) ++column;
    const int begins = column;
    while (at(column) > least + 0.1 * (most - least)) ++column;
    result.edge_px = column - begins;
    return result;
  }
  Plant robot_{model_, options(kBright)};
  int bands_ = 0;
};

TEST_F(ShutterTest, AHeadThatTurnsLeftSeesAPoleLeanToTheRightDownwards) {
  constexpr double kTurn_rad_per_s = 2.0, kReadout_s = 0.012;
  const std::vector<float> light = take(kTurn_rad_per_s, 0.0, 0.0001, kReadout_s);
  const double lean_px = row_of(light, 200).middle_px - row_of(light, 40).middle_px;
  const double told_px = file_of_camera_.lens[0].fx_px * kTurn_rad_per_s * kReadout_s * 160.0 / 239.0;
  EXPECT_NEAR(lean_px, told_px, 0.12 * told_px);
  const std::vector<float> other = take(-kTurn_rad_per_s, 0.0, 0.0001, kReadout_s);
  EXPECT_NEAR(row_of(other, 200).middle_px - row_of(other, 40).middle_px, -told_px, 0.12 * told_px);
}

TEST_F(ShutterTest, WithoutReadoutThePoleStandsUpright) {
  const std::vector<float> light = take(2.0, 0.0, 0.0001, 0.0);
  EXPECT_NEAR(row_of(light, 200).middle_px, row_of(light, 40).middle_px, 0.4);
}

TEST_F(ShutterTest, TheMiddleRowIsSeenAtTheStamp) {
  const double still_px = row_of(take(0.0, 0.0, 0.004, 0.012), 120).middle_px;
  EXPECT_NEAR(row_of(take(3.0, 0.0, 0.004, 0.012), 120).middle_px, still_px, 0.7)
      << "0.67 of a pixel is one of the drawing";
}

TEST_F(ShutterTest, AnExposureBlursWhatMoves) {
  constexpr double kTurn_rad_per_s = 4.0, kExposure_s = 0.012;
  const double sharp_px = row_of(take(0.0, 0.0, kExposure_s, 0.0), 120).edge_px;
  const double blurred_px = row_of(take(kTurn_rad_per_s, 0.0, kExposure_s, 0.0), 120).edge_px;
  const double told_px =
      0.8 * file_of_camera_.lens[0].fx_px * kTurn_rad_per_s * kExposure_s;  // of it: 10 to 90 %
  EXPECT_LE(sharp_px, 3.0);
  EXPECT_NEAR(blurred_px, told_px, 0.25 * told_px);
}

TEST_F(ShutterTest, ACameraThatTravelsDrawsMoreOften) {
  take(0.0, 0.0, 0.004, 0.012);
  EXPECT_EQ(bands_, 1);
  take(1.0, 0.0, 0.004, 0.012);
  const int turning = bands_;
  take(0.0, 0.1, 0.004, 0.012);
  EXPECT_EQ(bands_, 3);
  EXPECT_LE(turning, bands_);
}

// Bands join: what is drawn in three pieces shows no seam where nothing moves but by a little.
TEST_F(ShutterTest, BandsShowTheSamePole) {
  const std::vector<float> light = take(0.0, 0.1, 0.0001, 0.012);
  ASSERT_EQ(bands_, 3);
  for (int row = 45; row < 200; ++row) {
    EXPECT_NEAR(row_of(light, row).middle_px, row_of(light, row + 1).middle_px, 0.5) << row;
  }
}

}  // namespace
}  // namespace gaitway::simulator
