// Each lens alone, then both with what lies between them.
#include "tools/calibrate/camera/stereo_calibration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/calib3d.hpp>
#include <opencv2/core/eigen.hpp>
#include <sstream>

#include "gaitway/input/complaint.hpp"

namespace gaitway::calibration {
namespace {

constexpr std::size_t kLeastPairs = 8;
constexpr double kLeastCovered = 0.4;
constexpr double kMostError_px = 1.0;

[[noreturn]] void refuse_boards(const std::filesystem::path& folder, const std::string& rule,
                                const std::string& remedy) {
  input::refuse({.file = folder, .line = 0, .field = {}, .value = {}, .rule = rule, .remedy = remedy});
}

std::vector<cv::Point3f> corners_of(const Board& board) {
  std::vector<cv::Point3f> corners;
  for (int row = 0; row < board.rows; ++row) {
    for (int column = 0; column < board.columns; ++column) {
      corners.emplace_back(static_cast<float>(column * board.square_m),
                           static_cast<float>(row * board.square_m), 0.0F);
    }
  }
  return corners;
}

// Share of an 8 by 6 grid over the picture in whose fields a corner lies.
double covered_share(const std::vector<std::vector<cv::Point2f>>& seen, cv::Size size) {
  constexpr int kColumns = 8, kRows = 6;
  std::array<bool, kColumns * kRows> reached{};
  for (const auto& corners : seen) {
    for (const cv::Point2f& corner : corners) {
      const int x = std::clamp(static_cast<int>(corner.x) * kColumns / size.width, 0, kColumns - 1);
      const int y = std::clamp(static_cast<int>(corner.y) * kRows / size.height, 0, kRows - 1);
      reached[static_cast<std::size_t>(y * kColumns + x)] = true;
    }
  }
  return static_cast<double>(std::ranges::count(reached, true)) / static_cast<double>(reached.size());
}

urdf::LensParameters lens_of(const cv::Mat& matrix, const cv::Mat& distortion) {
  urdf::LensParameters lens{.fx_px = matrix.at<double>(0, 0),
                            .fy_px = matrix.at<double>(1, 1),
                            .cx_px = matrix.at<double>(0, 2),
                            .cy_px = matrix.at<double>(1, 2)};
  for (int i = 0; i < 5; ++i) lens.distortion[static_cast<std::size_t>(i)] = distortion.at<double>(i);
  return lens;
}

std::string in_yaml(const urdf::LensParameters& lens) {
  return fmt::format(
      "{{fx_px: {:.3f}, fy_px: {:.3f}, cx_px: {:.3f}, cy_px: {:.3f}, distortion: [{:.5f}, {:.5f}, {:.6f}, "
      "{:.6f}, "
      "{:.5f}]}}",
      lens.fx_px, lens.fy_px, lens.cx_px, lens.cy_px, lens.distortion[0], lens.distortion[1],
      lens.distortion[2], lens.distortion[3], lens.distortion[4]);
}

std::string in_yaml(const Eigen::Isometry3d& right_in_left) {
  const Eigen::AngleAxisd turn(right_in_left.linear());
  const Eigen::Vector3d turn_deg = 180.0 / std::numbers::pi * turn.angle() * turn.axis();
  const Eigen::Vector3d& at = right_in_left.translation();
  return fmt::format("{{position_m: [{:.5f}, {:.5f}, {:.5f}], rotation_deg: [{:.4f}, {:.4f}, {:.4f}]}}",
                     at.x(), at.y(), at.z(), turn_deg.x(), turn_deg.y(), turn_deg.z());
}

std::string comment_of(const std::string& line) {
  const std::size_t hash = line.find(" #");
  return hash == std::string::npos ? "" : " " + line.substr(hash);
}

}  // namespace

StereoCalibration calibrate(const BoardPictures& pictures, const Board& board,
                            const std::filesystem::path& folder) {
  if (pictures.pairs.size() < kLeastPairs) {
    refuse_boards(
        folder,
        fmt::format("{} pairs show the whole board of {} x {} inner corners to both cameras, {} are needed",
                    pictures.pairs.size(), board.columns, board.rows, kLeastPairs),
        "Check --columns and --rows, or take more pairs: the board whole, sharp, lit, with a white border");
  }
  std::vector<std::vector<cv::Point2f>> seen[2];
  for (const BoardPair& pair : pictures.pairs) {
    seen[0].push_back(pair.left);
    seen[1].push_back(pair.right);
  }
  const std::vector<std::vector<cv::Point3f>> corners(pictures.pairs.size(), corners_of(board));
  StereoCalibration found;
  cv::Mat matrix[2], distortion[2];
  for (std::size_t i = 0; i < 2; ++i) {
    found.covered[i] = covered_share(seen[i], pictures.size);
    if (found.covered[i] < kLeastCovered) {
      refuse_boards(folder,
                    fmt::format("the boards reach {:.0f} % of the {} picture, {:.0f} % are needed",
                                100 * found.covered[i], i == 0 ? "left" : "right", 100 * kLeastCovered),
                    "Hold the board into the corners and edges of the picture, too");
    }
    std::vector<cv::Mat> turns, places;
    found.lens_error_px[i] =
        cv::calibrateCamera(corners, seen[i], pictures.size, matrix[i], distortion[i], turns, places);
  }
  cv::Mat turn, place, essential, fundamental;
  found.pair_error_px =
      cv::stereoCalibrate(corners, seen[0], seen[1], matrix[0], distortion[0], matrix[1], distortion[1],
                          pictures.size, turn, place, essential, fundamental, cv::CALIB_USE_INTRINSIC_GUESS);
  if (!(found.pair_error_px <= kMostError_px)) {
    refuse_boards(
        folder,
        fmt::format("the corners are off by {:.2f} pixels, at most {:.1f} may be", found.pair_error_px,
                    kMostError_px),
        "Is the board flat and --square its size? Hold it still: a rolling shutter bends what moves");
  }
  for (std::size_t i = 0; i < 2; ++i) found.lens[i] = lens_of(matrix[i], distortion[i]);
  Eigen::Matrix3d rotation;
  Eigen::Vector3d translation;
  cv::cv2eigen(turn, rotation);
  cv::cv2eigen(place, translation);
  Eigen::Isometry3d left_in_right = Eigen::Isometry3d::Identity();
  left_in_right.linear() = rotation;
  left_in_right.translation() = translation;
  found.right_in_left = left_in_right.inverse();
  return found;
}

std::string with_calibration(const std::string& camera_yaml, const StereoCalibration& calibration,
                             int width_px, int height_px) {
  const std::array<std::pair<std::string, std::string>, 4> values{
      {{"size_px", fmt::format("[{}, {}]", width_px, height_px)},
       {"left", in_yaml(calibration.lens[0])},
       {"right", in_yaml(calibration.lens[1])},
       {"right_from_left", in_yaml(calibration.right_in_left)}}};
  std::array<bool, 4> written{};
  std::istringstream lines(camera_yaml);
  std::string text, line;
  bool replaces = false;  // the key's own further lines go with its value
  while (std::getline(lines, line)) {
    if (replaces && (line.starts_with(' ') || line.starts_with('\t'))) continue;
    replaces = false;
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (!line.starts_with(values[i].first + ":")) continue;
      line = values[i].first + ": " + values[i].second + comment_of(line);
      written[i] = replaces = true;
      break;
    }
    text += line + "\n";
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!written[i]) text += values[i].first + ": " + values[i].second + "\n";
  }
  return text;
}

}  // namespace gaitway::calibration
