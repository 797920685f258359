// OpenCV's semi-global matcher, and what of its answers is believed.
#include "gaitway/vision/disparity.hpp"

#include <opencv2/imgproc.hpp>

namespace gaitway::vision {
namespace {

constexpr int kBlock = 5;
constexpr int kSmallStep = 8 * kBlock * kBlock, kLargeStep = 32 * kBlock * kBlock;  // penalties of a change
constexpr int kClip = 31;               // of the prefiltered gradient
constexpr int kUniqueness = 10;         // percent by which the best cost is below the second
constexpr int kSpeckle_px = 80;         // smaller ones are no surface
constexpr int kSpeckleStep = 1;         // of disparity within a surface, between neighbours
constexpr int kWindow = 9;              // in which there must be texture
constexpr double kLeastTexture = 12.0;  // mean |Sobel| along a row: noise of two levels makes about 6

}  // namespace

DisparityMatcher::DisparityMatcher(int width)
    : scale_(width > 320 ? 2 : 1),
      matcher_(cv::StereoSGBM::create(0, kDisparities, kBlock, kSmallStep, kLargeStep, 1, kClip, kUniqueness,
                                      kSpeckle_px, kSpeckleStep, cv::StereoSGBM::MODE_SGBM)) {}

void DisparityMatcher::match(const cv::Mat& left, const cv::Mat& right) {
  const cv::Mat* pictures[2] = {&left, &right};
  if (scale_ > 1) {
    for (int i = 0; i < 2; ++i) {
      cv::resize(*pictures[i], half_[i], {}, 1.0 / scale_, 1.0 / scale_, cv::INTER_AREA);
      pictures[i] = &half_[i];
    }
  }
  matcher_->compute(*pictures[0], *pictures[1], disparity_);
  remove_untextured(*pictures[0]);
  const int could = (disparity_.cols - kDisparities) * disparity_.rows;
  matched_share_ = could > 0 ? static_cast<double>(cv::countNonZero(disparity_ > 0)) / could : 0.0;
}

void DisparityMatcher::remove_untextured(const cv::Mat& left) {
  cv::Sobel(left, gradient_, CV_16S, 1, 0);
  cv::boxFilter(cv::abs(gradient_), texture_, CV_32F, {kWindow, kWindow});
  disparity_.setTo(-1, texture_ < kLeastTexture);
}

}  // namespace gaitway::vision
