// By how much each pixel of the left picture is shifted in the right one, where that can be told.
#pragma once

#include <opencv2/calib3d.hpp>
#include <opencv2/core.hpp>

namespace gaitway::vision {

// Semi-global matching (H. Hirschmüller, "Stereo Processing by Semiglobal Matching and Mutual Information",
// 2008) with a check from right to left. What has no unique match, lies in a speckle, or does not correlate
// (for want of texture, say) has no disparity. The same bits for the same pictures: one thread, and the mode
// with one pass.
class DisparityMatcher {
 public:
  // Pictures of up to 320 pixels a row are matched as they are, larger ones at half their size.
  explicit DisparityMatcher(int width);

  // Of rectified pictures. Holds until the next call.
  void match(const cv::Mat& left, const cv::Mat& right);

  // In 1/16 pixels of the matched size; negative: none.
  [[nodiscard]] const cv::Mat& disparity() const noexcept { return disparity_; }
  // The pictures at the size at which they were matched; they hold as long as those that were given.
  [[nodiscard]] const cv::Mat& left() const noexcept { return matched_[0]; }
  [[nodiscard]] const cv::Mat& right() const noexcept { return matched_[1]; }
  // Pixels of the whole picture for one that is matched.
  [[nodiscard]] int scale() const noexcept { return scale_; }
  // Of all pixels, those that have a disparity.
  [[nodiscard]] double matched_share() const noexcept { return matched_share_; }

  static constexpr int kDisparities = 64;  // at the matched size: from 0, that is from infinity
  static constexpr double kUnits = 16.0;   // of disparity(), in a pixel

 private:
  void remove_unlike(const cv::Mat& left, const cv::Mat& right);

  int scale_;
  cv::Ptr<cv::StereoSGBM> matcher_;
  cv::Mat matched_[2], half_[2], bordered_[2], all_, disparity_;
  cv::Mat left_, shifted_, mean_[2], square_[2], product_;  // of the comparison
  double matched_share_ = 0.0;
};

}  // namespace gaitway::vision
