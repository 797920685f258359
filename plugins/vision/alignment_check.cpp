// Corners of the left picture, each compared with a window of the right one by normalised cross-correlation.
#include "gaitway/vision/alignment_check.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <optional>

namespace gaitway::vision {
namespace {

constexpr int kCorners = 48;
constexpr int kBetweenCorners_px = 14;
constexpr double kCornerQuality = 0.02;
constexpr int kPatch = 5;         // half its side
constexpr int kColumns = 64;      // searched to either side
constexpr int kRows = 8;          // searched up and down
constexpr double kAlike = 0.9;    // correlation of a match
constexpr double kUnique = 0.85;  // at most this share of it for the second one
constexpr int kBesidePeak = 3;
constexpr std::size_t kLeastMatches = 10;
constexpr double kMostShare = 0.6;
constexpr double kMisaligned_px = 1.0;

std::optional<cv::Point> shift_of(const cv::Mat& left, const cv::Mat& right, cv::Point corner) {
  const cv::Rect picture(0, 0, left.cols, left.rows);
  const cv::Rect patch(corner.x - kPatch, corner.y - kPatch, 2 * kPatch + 1, 2 * kPatch + 1);
  if ((patch & picture) != patch) return std::nullopt;
  const cv::Rect window =
      cv::Rect(patch.x - kColumns, patch.y - kRows, patch.width + 2 * kColumns, patch.height + 2 * kRows) &
      picture;
  cv::Mat alike;
  cv::matchTemplate(right(window), left(patch), alike, cv::TM_CCOEFF_NORMED);
  double best = 0.0, second = 0.0;
  cv::Point at;
  cv::minMaxLoc(alike, nullptr, &best, nullptr, &at);
  if (!(best > kAlike)) return std::nullopt;
  const cv::Rect peak(at.x - kBesidePeak, at.y - kBesidePeak, 2 * kBesidePeak + 1, 2 * kBesidePeak + 1);
  alike(peak & cv::Rect(0, 0, alike.cols, alike.rows)).setTo(-1.0);
  cv::minMaxLoc(alike, nullptr, &second);
  if (second > kUnique * best) return std::nullopt;
  return cv::Point(window.x + at.x - patch.x, window.y + at.y - patch.y);
}

}  // namespace

Alignment alignment_of(const cv::Mat& left, const cv::Mat& right) {
  std::vector<cv::Point2f> corners;
  cv::goodFeaturesToTrack(left, corners, kCorners, kCornerQuality, kBetweenCorners_px);
  std::vector<cv::Point> shifts;
  for (const cv::Point2f& corner : corners) {
    if (const auto shift = shift_of(left, right, cv::Point(cvRound(corner.x), cvRound(corner.y)))) {
      shifts.push_back(*shift);
    }
  }
  Alignment found{.matches = static_cast<int>(shifts.size())};
  if (shifts.size() < kLeastMatches) return found;
  // What the right camera sees further right is farther than infinity.
  const auto beyond = std::ranges::count_if(shifts, [](const cv::Point& shift) { return shift.x > 1; });
  double squared = 0.0;
  for (const cv::Point& shift : shifts) squared += static_cast<double>(shift.y) * shift.y;
  const auto count = static_cast<double>(shifts.size());
  found.rows_off_px = std::sqrt(squared / count);
  if (static_cast<double>(beyond) > kMostShare * count) {
    found.verdict = Alignment::Verdict::exchanged;
  } else if (found.rows_off_px > kMisaligned_px) {
    found.verdict = Alignment::Verdict::misaligned;
  } else {
    found.verdict = Alignment::Verdict::fine;
  }
  return found;
}

}  // namespace gaitway::vision
