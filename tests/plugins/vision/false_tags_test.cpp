// Pictures without a tag, and no tag found in them: textures, checkers, letters' edges, noise.
#include <gtest/gtest.h>

#include <cstdlib>
#include <opencv2/imgproc.hpp>
#include <random>

#include "gaitway/vision/tag_finder.hpp"

namespace gaitway::vision::testing {
namespace {

// Rectangles, quadrilaterals with cells like a tag's, and lines of random grey over smooth noise.
cv::Mat clutter(std::mt19937& random) {
  const auto drawn = [&random](int least, int most) {
    return std::uniform_int_distribution<int>(least, most)(random);
  };
  cv::Mat grains(drawn(6, 60), drawn(8, 80), CV_8UC1), picture;
  for (int y = 0; y < grains.rows; ++y) {
    for (int x = 0; x < grains.cols; ++x)
      grains.at<std::uint8_t>(y, x) = static_cast<std::uint8_t>(drawn(60, 200));
  }
  cv::resize(grains, picture, {320, 240}, 0.0, 0.0, cv::INTER_CUBIC);
  for (int i = drawn(3, 12); i > 0; --i) {
    // A black square with eight by eight cells of any pattern, in a white frame, seen aslant.
    cv::Mat plate(10, 10, CV_8UC1, cv::Scalar(255));
    plate(cv::Rect(1, 1, 8, 8)).setTo(0);
    for (int y = 2; y < 8; ++y) {
      for (int x = 2; x < 8; ++x) plate.at<std::uint8_t>(y, x) = drawn(0, 1) != 0 ? 255 : 0;
    }
    const float side = static_cast<float>(drawn(20, 90));
    const auto x = static_cast<float>(drawn(0, 300)), y = static_cast<float>(drawn(0, 220));
    const auto shaken = [&] { return static_cast<float>(drawn(-15, 15)) * side / 90.0F; };
    const std::vector<cv::Point2f> from{{0, 0}, {10, 0}, {10, 10}, {0, 10}};
    const std::vector<cv::Point2f> to{{x + shaken(), y + shaken()},
                                      {x + side + shaken(), y + shaken()},
                                      {x + side + shaken(), y + side + shaken()},
                                      {x + shaken(), y + side + shaken()}};
    cv::warpPerspective(plate, picture, cv::getPerspectiveTransform(from, to), picture.size(),
                        cv::INTER_NEAREST, cv::BORDER_TRANSPARENT);
  }
  for (int i = drawn(0, 8); i > 0; --i) {
    cv::rectangle(picture, cv::Rect(drawn(0, 300), drawn(0, 220), drawn(4, 80), drawn(4, 80)),
                  cv::Scalar(drawn(0, 255)), drawn(-1, 3));
  }
  cv::Mat noise(picture.size(), CV_16SC1), noisy;
  cv::RNG shots(random());
  shots.fill(noise, cv::RNG::NORMAL, 0, 4);
  picture.convertTo(noisy, CV_16SC1);
  noisy += noise;
  noisy.convertTo(picture, CV_8UC1);
  return picture;
}

// What a random pattern's six by six bits have by chance of being one of 587 tags in four turns is 3e-8.
TEST(FalseTags, NoneInPicturesWithoutOne) {
  cv::setNumThreads(1);
#ifdef GAITWAY_LONG
  constexpr int kPictures = 10'000;
#else
  constexpr int kPictures = 150;
#endif
  std::mt19937 random(20);
  TagFinder finder({});
  int found = 0;
  for (int i = 0; i < kPictures; ++i) found += static_cast<int>(finder.find(clutter(random)).size());
  EXPECT_EQ(found, 0) << "of " << kPictures << " pictures";
  RecordProperty("pictures", kPictures);
}

}  // namespace
}  // namespace gaitway::vision::testing
