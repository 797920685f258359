// Tags of the family AprilTag 36h11 in a rectified picture: which, and where their corners are.
#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <opencv2/core.hpp>
#include <vector>

namespace gaitway::vision {

// Corners as one who reads the tag has them: lower left, lower right, upper right, upper left. Pixels; the
// middle of the upper left pixel is (0, 0).
struct FoundTag {
  int id = 0;
  std::array<Eigen::Vector2d, 4> corner_px{};
};

struct TagFinderParameters {
  int corrected_bits = 0;       // of a code, 36 bits of which 11 differ from any other's
  double least_margin = 25.0;   // grey levels between a bit and the threshold, on average
  double least_side_px = 10.0;  // the shortest side; smaller ones are no tag
};

// After J. Wang and E. Olson, "AprilTag 2: Efficient and robust fiducial detection", 2016. One thread.
class TagFinder {
 public:
  explicit TagFinder(const TagFinderParameters& parameters);
  ~TagFinder();
  TagFinder(const TagFinder&) = delete;
  TagFinder& operator=(const TagFinder&) = delete;

  // In the order of their numbers; of two with one number none: a number names one place. Only within `part`
  // of the picture.
  [[nodiscard]] std::vector<FoundTag> find(const cv::Mat& picture, const cv::Rect& part);
  [[nodiscard]] std::vector<FoundTag> find(const cv::Mat& picture) {
    return find(picture, {0, 0, picture.cols, picture.rows});
  }

 private:
  struct Detector;
  TagFinderParameters parameters_;
  std::unique_ptr<Detector> detector_;
  cv::Mat larger_;
};

}  // namespace gaitway::vision
