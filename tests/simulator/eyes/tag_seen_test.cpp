// A tag of the course is read in both pictures, while the robot stands at its start.
#include <apriltag/apriltag.h>
#include <apriltag/tag36h11.h>
#include <gtest/gtest.h>

#include "eyes_fixture.hpp"

namespace gaitway::simulator {
namespace {

TEST_F(EyesTest, TheTagOfTheCourseIsReadFromTheStart) {
  PlantOptions how{.seed = 3};
  how.world = world::read_world(std::filesystem::path(GAITWAY_SOURCE_DIR) / "tools/worlds/course.yaml");
  const world::Tag tag = how.world->tags.at(0);
  const Plant robot(model_, how);
  const auto seeing = see(how);
  seeing->wait(robot, 700);  // until the exposure has followed the light
  apriltag_family_t* const family = tag36h11_create();
  apriltag_detector_t* const detector = apriltag_detector_create();
  apriltag_detector_add_family(detector, family);
  detector->quad_decimate = 1.0F;
  detector->nthreads = 1;
  for (const urdf::Side side : urdf::kSides) {
    std::vector<std::uint8_t> grey = seeing->camera.newest().grey[urdf::index_of(side)];
    image_u8_t image{320, 240, 320, grey.data()};
    zarray_t* const found = apriltag_detector_detect(detector, &image);
    ASSERT_EQ(zarray_size(found), 1);
    apriltag_detection_t* one = nullptr;
    zarray_get(found, 0, &one);
    EXPECT_EQ(one->id, tag.id);
    const Eigen::Vector2d told = pixel_of(robot, tag.pose.translation(), side);
    EXPECT_LT((Eigen::Vector2d(one->c) - told).norm(), 4.0)
        << "as far as the mismatch of camera and neck goes";
    apriltag_detections_destroy(found);
  }
  apriltag_detector_destroy(detector);
  tag36h11_destroy(family);
}

}  // namespace
}  // namespace gaitway::simulator
