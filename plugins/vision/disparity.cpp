// OpenCV's semi-global matcher, and what of its answers is believed.
#include "gaitway/vision/disparity.hpp"

#include <algorithm>
#include <cstdint>
#include <opencv2/imgproc.hpp>

namespace gaitway::vision {
namespace {

constexpr int kBlock = 5;
constexpr int kSmallStep = 8 * kBlock * kBlock, kLargeStep = 32 * kBlock * kBlock;  // penalties of a change
constexpr int kClip = 31;        // of the prefiltered gradient
constexpr int kUniqueness = 15;  // percent by which the best cost is below the second
// What stands on the ground is one surface with it at its foot, so even small obstacles are no speckles.
constexpr int kSpeckle_px = 200;
constexpr int kSpeckleStep = 1;         // of disparity within a surface, between neighbours
constexpr int kWindow = 7;              // in which both pictures must be alike
constexpr float kAlikeWindows = 0.7F;   // correlation: where there is no texture but noise it is about 0
constexpr float kLeastVariance = 9.0F;  // grey levels squared: below it is noise alone

}  // namespace

DisparityMatcher::DisparityMatcher(int width)
    : scale_(width > 320 ? 2 : 1),
      matcher_(cv::StereoSGBM::create(0, kDisparities, kBlock, kSmallStep, kLargeStep, 1, kClip, kUniqueness,
                                      kSpeckle_px, kSpeckleStep, cv::StereoSGBM::MODE_SGBM)) {}

void DisparityMatcher::match(const cv::Mat& left, const cv::Mat& right) {
  matched_[0] = left;
  matched_[1] = right;
  if (scale_ > 1) {
    for (std::size_t i = 0; i < 2; ++i) {
      cv::resize(matched_[i], half_[i], {}, 1.0 / scale_, 1.0 / scale_, cv::INTER_AREA);
      matched_[i] = half_[i];
    }
  }
  // The matcher says nothing of the columns whose farthest match would lie beyond the picture: with a border
  // that matches nothing it does, as far as the match itself is within.
  for (std::size_t i = 0; i < 2; ++i) {
    cv::copyMakeBorder(matched_[i], bordered_[i], 0, 0, kDisparities, 0, cv::BORDER_CONSTANT);
  }
  matcher_->compute(bordered_[0], bordered_[1], all_);
  all_.colRange(kDisparities, all_.cols).copyTo(disparity_);
  remove_unlike(matched_[0], matched_[1]);
  matched_share_ =
      static_cast<double>(cv::countNonZero(disparity_ > 0)) / static_cast<double>(disparity_.total());
}

// The right picture is laid over the left one by the disparities, and what does not correlate there is no
// match.
void DisparityMatcher::remove_unlike(const cv::Mat& left, const cv::Mat& right) {
  shifted_.create(left.size(), CV_32F);
  left.convertTo(left_, CV_32F);
  for (int y = 0; y < left.rows; ++y) {
    const auto* const shift = disparity_.ptr<std::int16_t>(y);
    const auto* const from = right.ptr<std::uint8_t>(y);
    auto* const to = shifted_.ptr<float>(y);
    for (int x = 0; x < left.cols; ++x) {
      const int at = x * static_cast<int>(kUnits) - std::max<int>(shift[x], 0);  // in 1/16 pixels
      if (at < 0) {  // beyond the picture, where there is no match
        to[x] = 0.0F;
        continue;
      }
      const int pixel = std::clamp(at / static_cast<int>(kUnits), 0, left.cols - 2);
      const float share = static_cast<float>(at) / static_cast<float>(kUnits) - static_cast<float>(pixel);
      to[x] = from[pixel] + share * static_cast<float>(from[pixel + 1] - from[pixel]);
    }
  }
  const cv::Size window(kWindow, kWindow);
  cv::boxFilter(left_, mean_[0], CV_32F, window);
  cv::boxFilter(shifted_, mean_[1], CV_32F, window);
  cv::boxFilter(left_.mul(left_), square_[0], CV_32F, window);
  cv::boxFilter(shifted_.mul(shifted_), square_[1], CV_32F, window);
  cv::boxFilter(left_.mul(shifted_), product_, CV_32F, window);
  for (int y = 0; y < left.rows; ++y) {
    for (int x = 0; x < left.cols; ++x) {
      const float mean_left = mean_[0].at<float>(y, x), mean_right = mean_[1].at<float>(y, x);
      const float variance_left = square_[0].at<float>(y, x) - mean_left * mean_left;
      const float variance_right = square_[1].at<float>(y, x) - mean_right * mean_right;
      const float common = product_.at<float>(y, x) - mean_left * mean_right;
      const bool is_alike = variance_left > kLeastVariance && variance_right > kLeastVariance &&
                            common > 0.0F &&
                            common * common > kAlikeWindows * kAlikeWindows * variance_left * variance_right;
      if (!is_alike) disparity_.at<std::int16_t>(y, x) = -1;
    }
  }
}

}  // namespace gaitway::vision
