// Reads PNGs as grey and looks for the board in both halves.
#include "tools/calibrate/camera/board_pictures.hpp"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <opencv2/calib3d.hpp>

#include "gaitway/input/complaint.hpp"

namespace gaitway::calibration {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& file, const std::string& rule, const std::string& remedy) {
  input::refuse({.file = file, .line = 0, .field = {}, .value = {}, .rule = rule, .remedy = remedy});
}

cv::Mat read_grey(const fs::path& file) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_file(&image, file.c_str()) == 0) {
    refuse(file, fmt::format("is no PNG that can be read: {}", image.message), "Take the picture again");
  }
  image.format = PNG_FORMAT_GRAY;
  cv::Mat picture(static_cast<int>(image.height), static_cast<int>(image.width), CV_8UC1);
  if (png_image_finish_read(&image, nullptr, picture.data, static_cast<png_int_32>(image.width), nullptr) ==
      0) {
    refuse(file, fmt::format("is cut off or damaged: {}", image.message), "Take the picture again");
  }
  return picture;
}

std::vector<fs::path> pngs_in(const fs::path& folder) {
  std::vector<fs::path> files;
  if (!fs::is_directory(folder)) return files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.is_regular_file() && entry.path().extension() == ".png") files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

struct Pictures {
  std::string name;
  cv::Mat left, right;
};

Pictures halves_of(const fs::path& file) {
  const cv::Mat both = read_grey(file);
  if (both.cols % 2 != 0 || both.cols < 2 * both.rows) {
    refuse(file, "is no pair side by side",
           "Put pairs into one picture, the left one left, or into the folders left and right");
  }
  return {file.filename(), both.colRange(0, both.cols / 2).clone(),
          both.colRange(both.cols / 2, both.cols).clone()};
}

std::vector<cv::Point2f> corners_in(const cv::Mat& picture, const Board& board) {
  std::vector<cv::Point2f> corners;
  const int flags = cv::CALIB_CB_EXHAUSTIVE | cv::CALIB_CB_ACCURACY;
  if (!cv::findChessboardCornersSB(picture, {board.columns, board.rows}, corners, flags)) corners.clear();
  return corners;
}

}  // namespace

BoardPictures find_boards(const fs::path& folder, const Board& board) {
  if ((board.columns + board.rows) % 2 == 0) {
    refuse(
        folder,
        fmt::format("a board of {} x {} inner corners looks the same upside down", board.columns, board.rows),
        "Take one with an even number along one side and an odd one along the other");
  }
  const bool apart = fs::is_directory(folder / "left") && fs::is_directory(folder / "right");
  const std::vector<fs::path> files = pngs_in(apart ? folder / "left" : folder);
  if (files.empty()) {
    refuse(folder, "there is no PNG in it",
           "Give a folder with pairs side by side, or with the folders left and right");
  }
  BoardPictures found;
  for (const fs::path& file : files) {
    const fs::path other = folder / "right" / file.filename();
    if (apart && !fs::exists(other)) refuse(other, "there is no such picture", "Remove the left one, too");
    const Pictures pair =
        apart ? Pictures{file.filename(), read_grey(file), read_grey(other)} : halves_of(file);
    if (found.size.empty()) found.size = pair.left.size();
    if (pair.left.size() != found.size || pair.right.size() != found.size) {
      refuse(file,
             fmt::format("must be of {} x {} pixels as the first one", found.size.width, found.size.height),
             "Calibrate with pictures of one size");
    }
    BoardPair corners{pair.name, corners_in(pair.left, board), {}};
    if (!corners.left.empty()) corners.right = corners_in(pair.right, board);
    if (corners.right.empty())
      found.without_board.push_back(pair.name);
    else
      found.pairs.push_back(std::move(corners));
  }
  return found;
}

}  // namespace gaitway::calibration
