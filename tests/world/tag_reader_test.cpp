// Each tag is read by the AprilTag library as the one that it is, in each of four turns.
#include <apriltag/apriltag.h>
#include <apriltag/tag36h11.h>
#include <gtest/gtest.h>

#include <vector>

#include "gaitway/world/picture.hpp"

namespace gaitway::world {
namespace {

class TagReaderTest : public testing::Test {
 protected:
  TagReaderTest() : family_(tag36h11_create()), detector_(apriltag_detector_create()) {
    apriltag_detector_add_family_bits(detector_, family_, 0);  // not one wrong bit is put right
    detector_->quad_decimate = 1.0F;
    detector_->nthreads = 1;
  }
  ~TagReaderTest() override {
    apriltag_detector_destroy(detector_);
    tag36h11_destroy(family_);
  }
  // What is read of a picture that a white sheet is around; -1: not exactly one.
  int read(const Picture& picture, int quarter_turns) {
    const int side = picture.width_px, sheet = 2 * side;
    std::vector<std::uint8_t> pixels(static_cast<std::size_t>(sheet * sheet), 255);
    for (int row = 0; row < side; ++row) {
      for (int column = 0; column < side; ++column) {
        int y = row, x = column;
        for (int turn = 0; turn < quarter_turns; ++turn) {
          const int old = y;
          y = x;
          x = side - 1 - old;
        }
        pixels[static_cast<std::size_t>((y + side / 2) * sheet + x + side / 2)] =
            picture.rgb[static_cast<std::size_t>(3 * (row * side + column))];
      }
    }
    image_u8_t image{sheet, sheet, sheet, pixels.data()};
    zarray_t* const found = apriltag_detector_detect(detector_, &image);
    int id = -1;
    if (zarray_size(found) == 1) {
      apriltag_detection_t* one = nullptr;
      zarray_get(found, 0, &one);
      id = one->id;
    }
    apriltag_detections_destroy(found);
    return id;
  }

 private:
  apriltag_family_t* family_;
  apriltag_detector_t* detector_;
};

TEST_F(TagReaderTest, ReadsEachTagAsWhatItIs) {
  for (int id = 0; id < kTags; ++id) ASSERT_EQ(read(picture_of_tag(id), id % 4), id);
}

}  // namespace
}  // namespace gaitway::world
