// What a lens does to directions: numbers of OpenCV's own model, its way back, and where it stops.
#include "gaitway/urdf/lens.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace gaitway::urdf {
namespace {

constexpr LensParameters kBarrel{258.4, 258.1, 160.7, 118.6, {-0.281, 0.071, 0.0004, -0.0003, 0.0}};

// cv2.projectPoints(points, 0, 0, K, distortion) of OpenCV 5.0.0.
TEST(Lens, projects_as_opencv_does) {
  constexpr LensParameters kLens{258.4, 258.1, 160.7, 118.6, {-0.281, 0.071, 0.0021, -0.0013, 0.011}};
  const Lens lens(kLens);
  const auto seen = lens.project({0.3, -0.2, 0.8});
  ASSERT_TRUE(seen);
  EXPECT_NEAR(seen->x(), 252.0974696895599, 1e-6);
  EXPECT_NEAR(seen->y(), 57.80375404298781, 1e-6);
}

TEST(Lens, draws_together_what_is_far_from_the_axis) {
  const Lens lens(kBarrel);
  const double straight_px = kBarrel.fx_px * 0.5;
  const auto seen = lens.project({0.5, 0.0, 1.0});
  ASSERT_TRUE(seen);
  EXPECT_LT(seen->x() - kBarrel.cx_px, straight_px - 7.0);
  EXPECT_GT(seen->x() - kBarrel.cx_px, straight_px - 10.0);
}

TEST(Lens, goes_back_from_every_pixel) {
  const Lens lens(kBarrel);
  for (int v = 0; v < 240; v += 7) {
    for (int u = 0; u < 320; u += 7) {
      const auto direction = lens.unproject(Eigen::Vector2d(u, v));
      ASSERT_TRUE(direction) << u << ", " << v;
      const auto back = lens.project(3.0 * direction->homogeneous());
      ASSERT_TRUE(back);
      EXPECT_NEAR((*back - Eigen::Vector2d(u, v)).norm(), 0.0, 1e-8);
    }
  }
}

TEST(Lens, sees_nothing_behind_and_nothing_where_its_polynomial_has_turned_back) {
  LensParameters strong = kBarrel;
  strong.distortion = {-0.5, 0.0, 0.0, 0.0, 0.0};  // rises up to sqrt(1 / 1.5)
  const Lens lens(strong);
  EXPECT_NEAR(lens.largest_radius(), std::sqrt(1.0 / 1.5), 1e-6);
  EXPECT_TRUE(lens.project({0.8, 0.0, 1.0}));
  EXPECT_FALSE(lens.project({0.83, 0.0, 1.0}));
  EXPECT_FALSE(lens.project({0.1, 0.1, -1.0}));
  EXPECT_FALSE(lens.project({0.1, 0.1, 0.0}));
  EXPECT_FALSE(lens.unproject({strong.cx_px + strong.fx_px * 0.6, strong.cy_px}))
      << "farther out than any direction is seen";
  EXPECT_TRUE(std::isinf(Lens(kBarrel).largest_radius()));
}

}  // namespace
}  // namespace gaitway::urdf
